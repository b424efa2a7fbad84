#pragma once

#include "names.h"
#include "text_lexer.h"

#include <optional>
#include <variant>
#include <vector>

namespace heed::owl {

/// Class expressions and data ranges of the Manchester syntax. Which of the two `p some x` holds depends on
/// what p and x are, so names must have their kinds.
class ManchesterExpressions {
 public:
  ManchesterExpressions(TextLexer& lexer, Names& names) : lexer_(lexer), names_(names) {}

  ClassExpression class_expression();
  DataRange data_range();
  ObjectProperty property();  ///< `p`, `inverse p`, `inverse (p)`
  Iri individual();
  Iri name();         ///< `<iri>`, `p:name` or `name`
  Iri any_name();     ///< The same, or an anonymous individual.
  Literal literal();  ///< \pre at_literal()
  [[nodiscard]] bool at_literal();
  [[nodiscard]] bool is_data_property(Iri property) const;
  /// Takes \p word where it comes next.
  bool take_word(std::string_view word);

 private:
  using Operand = std::variant<ClassExpression, DataRange>;
  /// What waits in front of an operand: `not`, or a restriction that lacks its filler.
  struct Prefix {
    enum class What { Not, Some, Only, Min, Max, Exactly } what;
    ObjectProperty property{};
    std::uint32_t n = 0;
    std::size_t offset = 0;
  };
  /// One bracket: the operands of `or`, those of the last `and`, and the prefixes of the next operand.
  struct Level {
    std::vector<Operand> disjuncts, conjuncts;
    std::vector<Prefix> prefixes;
    bool data = false;  ///< Names are datatypes.
    std::size_t offset = 0;
  };

  Operand expression(bool data);
  bool operand_begins();
  std::optional<Operand> primary(Level& level);
  std::optional<Operand> restriction_of(Level& level, ObjectProperty property, std::size_t offset);
  std::optional<Operand> named(Level& level, Iri name);
  Operand braces(bool data);
  DataRange facets(Iri datatype);
  Operand with_prefix(const Prefix& prefix, Operand operand);
  Operand connect(std::vector<Operand> operands, bool all, std::size_t offset);
  [[nodiscard]] bool wants_data(const Level& level) const;
  bool restriction_word_follows();
  std::uint32_t number();
  void check_depth(const DataRange& range, std::size_t offset) const;

  TextLexer& lexer_;
  Names& names_;
};

/// Words that end with ':' and begin a frame or a section of one.
[[nodiscard]] bool is_manchester_keyword(std::string_view word);

}  // namespace heed::owl
