#pragma once

#include <heed/logic/formula.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace heed::spec {

/// What stands in an infix formula of slugs' structured format or of gr1c. `Overwrite` replaces the least
/// significant bits of its right operand by the left one.
enum class Sign : std::uint8_t {
  End,
  Name,
  Number,
  Open,
  Close,
  Not,
  Next,
  Iff,
  Implies,
  Xor,
  Or,
  And,
  Eq,
  Ne,
  Lt,
  Le,
  Gt,
  Ge,
  Plus,
  Overwrite
};

struct Token {
  Sign sign = Sign::End;
  std::size_t begin = 0, end = 0;
  bool square = false;  ///< Of a parenthesis.
};

/// One of several terms that an integer may be: the one whose guard holds.
struct TermCase {
  logic::Formula guard, term;
};

/// A formula or an integer term on its way up. An integer carries what slugs' arithmetic makes of it: its
/// bounds, and the bits that slugs' circuits give it.
struct Operand {
  logic::Formula formula;
  std::size_t begin = 0;
  bool integer = false;
  bool bare = false;  ///< A name or number as it stands.
  std::int64_t low = 0, high = 0;
  std::size_t bits = 0;
  std::vector<TermCase> cases{};  ///< Where overwriting made it depend; empty: `formula`.
};

/// How a dialect reads its formulas.
struct InfixGrammar {
  /// The next token from \p at on. \throws util::InputError  what the dialect does not know
  std::function<Token(std::size_t at)> lex;
  /// The variable that a name stands for. `next`: it stands below a next operator.
  std::function<Operand(std::string_view word, std::size_t begin, bool next)> resolve;
  /// Binding power of a binary sign, larger binds tighter; all group to the left.
  std::function<int(Sign sign)> power;
  bool plain_comparisons = false;  ///< Only a variable with a number.
};

/// Reads one formula by precedence, without recursion. Chains of & or | become one node.
class InfixReader {
 public:
  InfixReader(const util::SourceText& source, const util::Limits& limits, InfixGrammar grammar)
      : source_(source), limits_(limits), grammar_(std::move(grammar)) {}

  /// Reads from \p begin to where the dialect's lexer says End; that offset goes to \p end.
  /// \throws util::InputError
  [[nodiscard]] logic::Formula read(std::size_t begin, std::size_t& end);

 private:
  void operand(const Token& token);
  void binary(const Token& token);
  void close(const Token& token);
  void reduce();
  void reduce_binary(Sign sign, std::size_t begin, std::size_t count);
  void compare(Sign sign, std::size_t begin);
  void add(std::size_t begin);
  void overwrite(std::size_t begin);
  [[nodiscard]] int power(Sign sign) const;
  void require_formula(const Operand& value) const;
  void require_integer(const Operand& value) const;
  [[noreturn]] void fail(std::size_t offset, std::string code, std::string message,
                         std::string hint = {}) const;

  const util::SourceText& source_;
  const util::Limits& limits_;
  InfixGrammar grammar_;
  std::vector<Token> operators_;
  std::vector<Operand> values_;
  std::size_t depth_ = 0, nexts_ = 0;
};

}  // namespace heed::spec
