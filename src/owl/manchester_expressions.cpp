#include "manchester_expressions.h"

#include "kinds.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

// OWL 2 Manchester Syntax, section 2.4: `or` over `and` over `not` and restrictions. One Level per bracket
// instead of one call per bracket.

namespace heed::owl {
namespace {

namespace v = vocabulary;
using Kind = ClassExpression::Kind;

constexpr std::array<std::string_view, 7> restriction_words = {"some", "only",    "value", "min",
                                                               "max",  "exactly", "Self"};
constexpr std::size_t most_range_depth = 200;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// "5", "-5", "5.0", "5.0f", "5e3f": a number that stands for itself.
bool looks_like_number(std::string_view word) {
  const std::size_t sign = word.starts_with('+') || word.starts_with('-') ? 1 : 0;
  return word.size() > sign &&
         (is_digit(word[sign]) || (word[sign] == '.' && word.size() > sign + 1 && is_digit(word[sign + 1])));
}

}  // namespace

bool ManchesterExpressions::take_word(std::string_view word) {
  if (lexer_.next_word() != word) return false;
  lexer_.word();
  return true;
}

bool ManchesterExpressions::is_data_property(Iri property) const {
  return names_.kinds().has(EntityKind::DataProperty, property) &&
         !names_.kinds().has(EntityKind::ObjectProperty, property);
}

Iri ManchesterExpressions::name() {
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  const Iri out = any_name();
  if (names_.iris().text(out).starts_with("_:"))
    lexer_.fail(offset, "syntax", "an anonymous individual stands where a class or property is expected");
  return out;
}

Iri ManchesterExpressions::any_name() {
  const char c = lexer_.peek();
  const std::size_t offset = lexer_.offset();
  if (c == '<') return names_.full(lexer_.iri(), offset);
  const std::string_view word = lexer_.word();
  static constexpr std::array<std::string_view, 12> reserved = {
      "some", "only", "value", "min", "max", "exactly", "Self", "and", "or", "not", "that", "inverse"};
  const bool bad = word.empty() || looks_like_number(word) || is_manchester_keyword(word) ||
                   std::find(reserved.begin(), reserved.end(), word) != reserved.end();
  if (bad) {
    lexer_.go_back(offset);
    lexer_.fail(offset, "syntax", fmt::format("expected a name, found {}", lexer_.found()));
  }
  if (word.starts_with("_:")) return names_.anonymous(word.substr(2));
  return names_.abbreviated(word, offset);
}

Iri ManchesterExpressions::individual() {
  const Iri out = any_name();
  names_.use(EntityKind::NamedIndividual, out);
  return out;
}

ObjectProperty ManchesterExpressions::property() {
  bool inverse = false;
  std::size_t open = 0;
  for (;;) {
    if (take_word("inverse"))
      inverse = !inverse;
    else if (lexer_.take('('))
      ++open;
    else
      break;
  }
  const ObjectProperty out{name(), inverse};
  for (; open > 0; --open) lexer_.expect(')', "behind the property");
  names_.use(EntityKind::ObjectProperty, out.iri);
  return out;
}

bool ManchesterExpressions::at_literal() {
  if (lexer_.peek() == '"') return true;
  const std::string_view word = lexer_.next_word();
  return word == "true" || word == "false" || looks_like_number(word);
}

Literal ManchesterExpressions::literal() {
  if (lexer_.peek() == '"') {
    std::string text = lexer_.string();
    if (lexer_.ahead() == '@') return Names::literal(std::move(text), v::xsd_string, lexer_.language());
    if (lexer_.ahead() != '^') return {std::move(text), v::xsd_string, {}};
    lexer_.expect('^', "before a datatype");
    lexer_.expect('^', "before a datatype");
    return Names::literal(std::move(text), name(), {});
  }
  const std::size_t offset = lexer_.offset();
  const std::string_view word = lexer_.word();
  if (word == "true" || word == "false") return {std::string(word), v::xsd_boolean, {}};
  const std::size_t odd = word.find_first_not_of("+-0123456789");
  if (odd == std::string_view::npos) return {std::string(word), v::xsd_integer, {}};
  if (word.ends_with('f') || word.ends_with('F'))
    return {std::string(word.substr(0, word.size() - 1)), v::xsd_float, {}};
  if (word.find_first_not_of("+-.0123456789") != std::string_view::npos)
    lexer_.fail(offset, "syntax", fmt::format("'{}' is no number", word), "a float ends with 'f'");
  return {std::string(word), v::xsd_decimal, {}};
}

bool ManchesterExpressions::restriction_word_follows() {
  const std::string_view next = lexer_.next_word();
  return std::find(restriction_words.begin(), restriction_words.end(), next) != restriction_words.end();
}

bool ManchesterExpressions::operand_begins() {
  const char c = lexer_.peek();
  if (c == '<' || c == '(' || c == '{') return true;
  const std::string_view word = lexer_.next_word();
  return !word.empty() && word != "and" && word != "or" && word != "that" && !is_manchester_keyword(word);
}

bool ManchesterExpressions::wants_data(const Level& level) const {
  for (auto prefix = level.prefixes.rbegin(); prefix != level.prefixes.rend(); ++prefix)
    if (prefix->what != Prefix::What::Not) return is_data_property(prefix->property.iri);
  return level.data;
}

std::uint32_t ManchesterExpressions::number() {
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  const std::string_view word = lexer_.word();
  std::uint32_t n = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
  if (word.empty() || error != std::errc() || end != word.data() + word.size())
    lexer_.fail(offset, "bad-cardinality", fmt::format("'{}' is no cardinality", word),
                "write a natural number");
  return n;
}

ManchesterExpressions::Operand ManchesterExpressions::expression(bool data) {
  std::vector<Level> levels(1);
  levels.back().data = data;
  levels.back().offset = lexer_.offset();
  for (;;) {
    Level& level = levels.back();
    std::optional<Operand> operand = primary(level);
    if (!operand) {
      const std::size_t offset = lexer_.offset();
      if (!lexer_.take('(')) continue;
      const std::size_t most = names_.limits().nesting;
      if (most != 0 && levels.size() >= most)
        lexer_.fail(offset, "nesting", fmt::format("brackets nest more than {} deep", most));
      Level inner;
      inner.data = wants_data(level);
      inner.offset = offset;
      levels.push_back(std::move(inner));
      continue;
    }
    for (bool closed = true; closed;) {
      Level& top = levels.back();
      for (; !top.prefixes.empty(); top.prefixes.pop_back())
        operand = with_prefix(top.prefixes.back(), std::move(*operand));
      top.conjuncts.push_back(std::move(*operand));
      if (take_word("and") || take_word("that")) break;
      top.disjuncts.push_back(connect(std::move(top.conjuncts), true, top.offset));
      top.conjuncts.clear();
      if (take_word("or")) break;
      operand = connect(std::move(top.disjuncts), false, top.offset);
      if (levels.size() == 1) return std::move(*operand);
      lexer_.expect(')', "at the end of the bracket");
      levels.pop_back();
    }
  }
}

/// An operand that needs nothing more; nothing where a bracket opens or a prefix was taken.
std::optional<ManchesterExpressions::Operand> ManchesterExpressions::primary(Level& level) {
  const char c = lexer_.peek();
  const std::size_t offset = lexer_.offset();
  if (c == '(') return std::nullopt;
  if (c == '{') return braces(wants_data(level));
  const std::size_t most = names_.limits().nesting;
  if (most != 0 && level.prefixes.size() >= most)
    lexer_.fail(offset, "nesting", fmt::format("restrictions nest more than {} deep", most));
  if (take_word("not")) {
    level.prefixes.push_back({Prefix::What::Not, {}, 0, offset});
    return std::nullopt;
  }
  if (lexer_.next_word() == "inverse") return restriction_of(level, property(), offset);
  const Iri subject = name();
  if (restriction_word_follows()) return restriction_of(level, {subject, false}, offset);
  return named(level, subject);
}

std::optional<ManchesterExpressions::Operand> ManchesterExpressions::restriction_of(Level& level,
                                                                                    ObjectProperty property,
                                                                                    std::size_t offset) {
  lexer_.peek();
  const std::size_t place = lexer_.offset();
  const std::string_view word = lexer_.word();
  const bool data = !property.inverse && is_data_property(property.iri);
  if (word == "value") {
    if (!property.inverse && at_literal()) {
      names_.use(EntityKind::DataProperty, property.iri);
      return ClassExpression::data_has_value(property.iri, literal());
    }
    names_.use(EntityKind::ObjectProperty, property.iri);
    return ClassExpression::has_value(property, individual());
  }
  if (word == "Self") {
    names_.use(EntityKind::ObjectProperty, property.iri);
    return ClassExpression::has_self(property);
  }
  Prefix prefix{Prefix::What::Some, property, 0, offset};
  if (word == "only") prefix.what = Prefix::What::Only;
  if (word == "min") prefix.what = Prefix::What::Min;
  if (word == "max") prefix.what = Prefix::What::Max;
  if (word == "exactly") prefix.what = Prefix::What::Exactly;
  if (std::find(restriction_words.begin(), restriction_words.end(), word) == restriction_words.end())
    lexer_.fail(place, "syntax", "expected some, only, value, min, max, exactly or Self behind the property");
  if (prefix.what >= Prefix::What::Min) {
    prefix.n = number();
    if (!operand_begins())
      return with_prefix(
          prefix, data ? Operand(DataRange::datatype(v::rdfs_literal)) : Operand(ClassExpression::thing()));
  }
  level.prefixes.push_back(prefix);
  return std::nullopt;
}

std::optional<ManchesterExpressions::Operand> ManchesterExpressions::named(Level& level, Iri subject) {
  if (lexer_.peek() == '[') return facets(subject);
  const bool known_class = names_.kinds().has(EntityKind::Class, subject);
  if (wants_data(level) || (!known_class && is_datatype(subject, names_.kinds(), names_.iris()))) {
    names_.use(EntityKind::Datatype, subject);
    return DataRange::datatype(subject);
  }
  names_.use(EntityKind::Class, subject);
  return ClassExpression::named(subject);
}

ManchesterExpressions::Operand ManchesterExpressions::braces(bool data) {
  lexer_.take('{');
  std::vector<Literal> literals;
  std::vector<Iri> individuals;
  data |= at_literal();
  do {
    if (!data)
      individuals.push_back(individual());
    else if (at_literal())
      literals.push_back(literal());
    else
      lexer_.fail(lexer_.offset(), "syntax", fmt::format("expected a literal, found {}", lexer_.found()));
  } while (lexer_.take(','));
  lexer_.expect('}', "at the end of the enumeration");
  if (data) return DataRange::one_of(std::move(literals));
  return ClassExpression::one_of(std::move(individuals));
}

DataRange ManchesterExpressions::facets(Iri datatype) {
  names_.use(EntityKind::Datatype, datatype);
  lexer_.take('[');
  static constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"length", HEED_XSD "length"},
      {"minLength", HEED_XSD "minLength"},
      {"maxLength", HEED_XSD "maxLength"},
      {"pattern", HEED_XSD "pattern"},
      {"langRange", HEED_RDF "langRange"},
      {"totalDigits", HEED_XSD "totalDigits"},
      {"fractionDigits", HEED_XSD "fractionDigits"}};
  std::vector<Facet> out;
  do {
    const char c = lexer_.peek();
    const std::size_t offset = lexer_.offset();
    Iri facet{};
    if (c == '<' || c == '>') {
      lexer_.take(c);
      const bool inclusive = lexer_.ahead() == '=';
      if (inclusive) lexer_.take('=');
      facet = names_.full(
          fmt::format("{}{}{}", HEED_XSD, c == '<' ? "max" : "min", inclusive ? "Inclusive" : "Exclusive"),
          offset);
    } else {
      const std::string_view word = lexer_.word();
      for (const auto& [name, iri] : words)
        if (word == name) facet = names_.full(iri, offset);
      if (facet.id == 0)
        facet = word.find(':') == std::string_view::npos ? Iri{} : names_.abbreviated(word, offset);
      if (facet.id == 0)
        lexer_.fail(offset, "syntax", fmt::format("'{}' is no facet", word),
                    "known: length, minLength, maxLength, pattern, langRange, <=, <, >=, >");
    }
    if (!at_literal())
      lexer_.fail(lexer_.offset(), "syntax", fmt::format("expected a literal, found {}", lexer_.found()));
    out.push_back({facet, literal()});
  } while (lexer_.take(','));
  lexer_.expect(']', "at the end of the facets");
  return DataRange::restriction(datatype, std::move(out));
}

ManchesterExpressions::Operand ManchesterExpressions::with_prefix(const Prefix& prefix, Operand operand) {
  using What = Prefix::What;
  static constexpr std::array object_kinds = {Kind::Complement, Kind::Some, Kind::Only,
                                              Kind::Min,        Kind::Max,  Kind::Exactly};
  static constexpr std::array data_kinds = {Kind::Complement, Kind::DataSome, Kind::DataOnly,
                                            Kind::DataMin,    Kind::DataMax,  Kind::DataExactly};
  const auto which = static_cast<std::size_t>(prefix.what);
  const Iri iri = prefix.property.iri;
  if (auto* range = std::get_if<DataRange>(&operand)) {
    if (prefix.what == What::Not) return DataRange::complement(std::move(*range));
    if (prefix.property.inverse)
      lexer_.fail(prefix.offset, "wrong-argument", "an inverse property has a data range as its filler");
    check_depth(*range, prefix.offset);
    names_.use(EntityKind::DataProperty, iri);
    if (prefix.what < What::Min)
      return ClassExpression::data_quantified(data_kinds[which], {iri}, std::move(*range));
    return ClassExpression::data_cardinality(data_kinds[which], prefix.n, iri, std::move(*range));
  }
  ClassExpression filler = std::get<ClassExpression>(std::move(operand));
  if (prefix.what == What::Not) return ClassExpression::complement(std::move(filler));
  names_.use(EntityKind::ObjectProperty, iri);
  if (prefix.what == What::Some) return ClassExpression::some(prefix.property, std::move(filler));
  if (prefix.what == What::Only) return ClassExpression::only(prefix.property, std::move(filler));
  return ClassExpression::cardinality_of(object_kinds[which], prefix.n, prefix.property, std::move(filler));
}

ManchesterExpressions::Operand ManchesterExpressions::connect(std::vector<Operand> operands, bool all,
                                                              std::size_t offset) {
  if (operands.size() == 1) return std::move(operands.front());
  std::vector<ClassExpression> classes;
  std::vector<DataRange> ranges;
  for (Operand& operand : operands)
    if (auto* range = std::get_if<DataRange>(&operand))
      ranges.push_back(std::move(*range));
    else
      classes.push_back(std::get<ClassExpression>(std::move(operand)));
  if (!classes.empty() && !ranges.empty())
    lexer_.fail(offset, "wrong-argument", "classes and data ranges are connected with each other here",
                "declare the datatypes and data properties");
  if (classes.empty())
    return all ? DataRange::intersection(std::move(ranges)) : DataRange::union_of(std::move(ranges));
  return all ? ClassExpression::intersection(std::move(classes))
             : ClassExpression::union_of(std::move(classes));
}

ClassExpression ManchesterExpressions::class_expression() {
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  Operand out = expression(false);
  if (std::holds_alternative<DataRange>(out))
    lexer_.fail(offset, "wrong-argument", "a data range stands where a class is expected");
  ClassExpression found = std::get<ClassExpression>(std::move(out));
  const std::size_t most = names_.limits().nesting;
  if (most != 0 && found.depth() > most)
    lexer_.fail(offset, "nesting", fmt::format("class expressions nest more than {} deep", most));
  return found;
}

DataRange ManchesterExpressions::data_range() {
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  Operand out = expression(true);
  if (std::holds_alternative<ClassExpression>(out))
    lexer_.fail(offset, "wrong-argument", "a class expression stands where a data range is expected");
  check_depth(std::get<DataRange>(out), offset);
  return std::get<DataRange>(std::move(out));
}

void ManchesterExpressions::check_depth(const DataRange& range, std::size_t offset) const {
  std::vector<std::pair<const DataRange*, std::size_t>> open = {{&range, 1}};
  while (!open.empty()) {
    const auto [next, depth] = open.back();
    open.pop_back();
    if (depth > most_range_depth)
      lexer_.fail(offset, "nesting", fmt::format("data ranges nest more than {} deep", most_range_depth));
    for (const DataRange& operand : next->operands()) open.emplace_back(&operand, depth + 1);
  }
}

}  // namespace heed::owl
