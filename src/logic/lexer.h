#pragma once

#include <heed/logic/formula.h>
#include <heed/util/source.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace heed::logic {

/// A lexical unit of a formula. `Operator` covers every connective, comparison and arithmetic sign; `op` says
/// which.
struct Token {
  enum class Kind : std::uint8_t { End, Name, Number, True, False, Operator, Prime, Open, Close };
  Kind kind = Kind::End;
  Op op = Op::True;
  bool twice = false;      ///< `GF` in one word: two prefix operators.
  std::size_t offset = 0;  ///< Of its first byte in the text.
  std::string text{};      ///< As written; of a quoted name what is between the quotes.
  std::int64_t number = 0;
};

/// Splits a text into tokens, one at a time.
class Lexer {
 public:
  explicit Lexer(util::SourceText source) : source_(std::move(source)) {}

  /// \param operand_expected  A minus sign before digits then belongs to the number.
  /// \throws util::InputError  encoding, malformed names and numbers, signs that are no operators.
  [[nodiscard]] Token next(bool operand_expected);

 private:
  [[nodiscard]] std::string_view rest() const { return std::string_view(source_.text()).substr(offset_); }
  void skip_space();
  [[nodiscard]] Token take(Token token, std::size_t bytes);
  [[nodiscard]] Token read_number();
  [[nodiscard]] Token read_name();
  [[nodiscard]] Token read_quoted();
  [[nodiscard]] Token read_symbol();
  [[noreturn]] void refuse_symbol() const;

  util::SourceText source_;
  std::size_t offset_ = 0;
};

/// True for a word that cannot stand unquoted as a name: an operator letter or constant.
[[nodiscard]] bool is_reserved(std::string_view word);

/// True for what Lexer reads as one unquoted name.
[[nodiscard]] bool is_plain_name(std::string_view word);

}  // namespace heed::logic
