#include <heed/owl/print.h>

#include "pieces.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

namespace heed::owl {
namespace {

namespace v = vocabulary;
using Kind = ClassExpression::Kind;

class Text {
 public:
  explicit Text(const Ontology& ontology) : ontology_(ontology) {}

  std::string write(const Axiom& axiom) {
    std::visit(*this, axiom.content);
    return finish();
  }
  std::string write(const ClassExpression& expression) {
    add(expression);
    return finish();
  }

  void operator()(const Declaration& a) {
    static constexpr const char* kinds[] = {"Class",        "Datatype",           "ObjectProperty",
                                            "DataProperty", "AnnotationProperty", "Individual"};
    list(std::string(kinds[static_cast<std::size_t>(a.kind)]), ": ", a.entity);
  }
  void operator()(const SubClassOf& a) { list(a.sub, " SubClassOf ", a.super); }
  void operator()(const EquivalentClasses& a) { either(a.classes, " EquivalentTo ", "EquivalentClasses: "); }
  void operator()(const DisjointClasses& a) { either(a.classes, " DisjointWith ", "DisjointClasses: "); }
  void operator()(const DisjointUnion& a) { list(a.whole, " DisjointUnionOf "), all(a.parts, ", "); }
  void operator()(const SubObjectPropertyOf& a) { all(a.chain, " o "), list(" SubPropertyOf ", a.super); }
  void operator()(const EquivalentObjectProperties& a) {
    either(a.properties, " EquivalentTo ", "EquivalentProperties: ");
  }
  void operator()(const DisjointObjectProperties& a) {
    either(a.properties, " DisjointWith ", "DisjointProperties: ");
  }
  void operator()(const InverseObjectProperties& a) { list(a.first, " InverseOf ", a.second); }
  void operator()(const ObjectPropertyDomain& a) { list(a.property, " Domain ", a.domain); }
  void operator()(const ObjectPropertyRange& a) { list(a.property, " Range ", a.range); }
  void operator()(const ObjectPropertyCharacteristic& a) {
    static constexpr const char* names[] = {"Functional", "InverseFunctional", "Reflexive", "Irreflexive",
                                            "Symmetric",  "Asymmetric",        "Transitive"};
    list(a.property, " Characteristics ", std::string(names[static_cast<std::size_t>(a.characteristic)]));
  }
  void operator()(const SubDataPropertyOf& a) { list(a.sub, " SubPropertyOf ", a.super); }
  void operator()(const EquivalentDataProperties& a) {
    either(a.properties, " EquivalentTo ", "EquivalentProperties: ");
  }
  void operator()(const DisjointDataProperties& a) {
    either(a.properties, " DisjointWith ", "DisjointProperties: ");
  }
  void operator()(const DataPropertyDomain& a) { list(a.property, " Domain ", a.domain); }
  void operator()(const DataPropertyRange& a) { list(a.property, " Range ", a.range); }
  void operator()(const FunctionalDataProperty& a) { list(a.property, " Characteristics Functional"); }
  void operator()(const DatatypeDefinition& a) { list(a.datatype, " EquivalentTo ", a.range); }
  void operator()(const HasKey& a) {
    list(a.of, " HasKey "), all(a.object_properties, ", ");
    if (!a.object_properties.empty() && !a.data_properties.empty()) add(", ");
    all(a.data_properties, ", ");
  }
  void operator()(const SameIndividual& a) { either(a.individuals, " SameAs ", "SameIndividual: "); }
  void operator()(const DifferentIndividuals& a) {
    either(a.individuals, " DifferentFrom ", "DifferentIndividuals: ");
  }
  void operator()(const ClassAssertion& a) { list(a.individual, " Type ", a.of); }
  void operator()(const ObjectPropertyAssertion& a) {
    list(a.negative ? "not " : "", a.source, " ", a.property, " ", a.target);
  }
  void operator()(const DataPropertyAssertion& a) {
    list(a.negative ? "not " : "", a.source, " ", a.property, " ", a.value);
  }
  void operator()(const AnnotationAssertion& a) { list(a.subject, " ", a.property, " ", a.value); }
  void operator()(const SubAnnotationPropertyOf& a) { list(a.sub, " SubPropertyOf ", a.super); }
  void operator()(const AnnotationPropertyDomain& a) { list(a.property, " Domain ", a.domain); }
  void operator()(const AnnotationPropertyRange& a) { list(a.property, " Range ", a.range); }

 private:
  std::string finish() {
    return write_pieces(std::move(pieces_), [this](Nested nested) { return expand(nested); });
  }
  void add(const char* piece) { pieces_.emplace_back(std::string(piece)); }
  void add(std::string piece) { pieces_.emplace_back(std::move(piece)); }
  void add(const ClassExpression& e) { pieces_.emplace_back(Nested{&e, false}); }
  template <class T>
  void add(const T& part) {
    add(text(part));
  }
  template <class... Parts>
  void list(const Parts&... parts) {
    (add(parts), ...);
  }
  template <class T>
  void all(const std::vector<T>& parts, const char* between) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i > 0) add(between);
      add(parts[i]);
    }
  }
  /// "a WORD b" for two, "Words: a, b, c" for more.
  template <class T>
  void either(const std::vector<T>& parts, const char* between, const char* front) {
    if (parts.size() == 2) return all(parts, between);
    add(front);
    all(parts, ", ");
  }

  std::string text(Iri iri) const { return ontology_.name(iri); }
  std::string text(ObjectProperty p) const { return p.inverse ? "inverse " + text(p.iri) : text(p.iri); }
  std::string text(const Literal& l) const {
    if (!l.language.empty()) return quoted(l.value) + "@" + l.language;
    if (l.datatype == v::xsd_integer || l.datatype == v::xsd_decimal || l.datatype == v::xsd_boolean)
      return l.value;
    if (l.datatype == v::xsd_string) return quoted(l.value);
    return quoted(l.value) + "^^" + text(l.datatype);
  }
  std::string text(const AnnotationValue& value) const {
    return std::visit([this](const auto& part) { return text(part); }, value);
  }
  std::string text(const DataRange& range) const;
  std::string names(const std::vector<Iri>& iris) const;
  std::string flat(const ClassExpression& e) const;
  std::vector<Piece> expand(Nested nested) const;

  const Ontology& ontology_;
  std::vector<Piece> pieces_;
};

std::string Text::text(const DataRange& range) const {
  std::vector<std::string> parts;
  for (const DataRange& operand : range.operands())
    parts.push_back(operand.operands().empty() ? text(operand) : "(" + text(operand) + ")");
  for (const Literal& literal : range.literals()) parts.push_back(text(literal));
  for (const Facet& facet : range.facets()) parts.push_back(text(facet.facet) + " " + text(facet.value));
  switch (range.kind()) {
    case DataRange::Kind::Datatype:
      return text(range.iri());
    case DataRange::Kind::Intersection:
      return fmt::format("{}", fmt::join(parts, " and "));
    case DataRange::Kind::Union:
      return fmt::format("{}", fmt::join(parts, " or "));
    case DataRange::Kind::Complement:
      return "not " + parts.front();
    case DataRange::Kind::OneOf:
      return fmt::format("{{{}}}", fmt::join(parts, ", "));
    case DataRange::Kind::Restriction:
      break;
  }
  return fmt::format("{}[{}]", text(range.iri()), fmt::join(parts, ", "));
}

/// The word between property and filler of a quantified expression, its number included; empty for other
/// kinds.
std::string quantifier(const ClassExpression& e) {
  switch (e.kind()) {
    case Kind::Some:
    case Kind::DataSome:
      return "some";
    case Kind::Only:
    case Kind::DataOnly:
      return "only";
    case Kind::Min:
    case Kind::DataMin:
      return fmt::format("min {}", e.cardinality());
    case Kind::Max:
    case Kind::DataMax:
      return fmt::format("max {}", e.cardinality());
    case Kind::Exactly:
    case Kind::DataExactly:
      return fmt::format("exactly {}", e.cardinality());
    default:
      return {};
  }
}

std::string Text::names(const std::vector<Iri>& iris) const {
  std::vector<std::string> out;
  for (const Iri iri : iris) out.push_back(text(iri));
  return fmt::format("{}", fmt::join(out, ", "));
}

/// Kinds that nest no class expression.
std::string Text::flat(const ClassExpression& e) const {
  if (e.is_named()) return text(e.iri());
  if (e.kind() == Kind::OneOf) return fmt::format("{{{}}}", names(e.individuals()));
  if (e.kind() == Kind::HasValue)
    return fmt::format("{} value {}", text(e.property()), names(e.individuals()));
  if (e.kind() == Kind::HasSelf) return text(e.property()) + " Self";
  if (e.kind() == Kind::DataHasValue)
    return fmt::format("{} value {}", names(e.data_properties()), text(e.literal()));
  return fmt::format("{} {} {}", names(e.data_properties()), quantifier(e), text(e.range()));
}

std::vector<Piece> Text::expand(Nested nested) const {
  const ClassExpression& e = *nested.expression;
  std::vector<Piece> out;
  const bool bracketed = nested.bracketed && !e.is_named() && e.kind() != Kind::OneOf;
  if (bracketed) out.emplace_back("(");
  if (e.operands().empty()) out.emplace_back(flat(e));
  if (e.kind() == Kind::Complement) out.emplace_back("not ");
  if (const std::string word = quantifier(e); !word.empty() && !e.operands().empty())
    out.emplace_back(fmt::format("{} {} ", text(e.property()), word));
  for (std::size_t i = 0; i < e.operands().size(); ++i) {
    if (i > 0) out.emplace_back(e.kind() == Kind::Union ? " or " : " and ");
    out.emplace_back(Nested{&e.operands()[i], true});
  }
  if (bracketed) out.emplace_back(")");
  return out;
}

}  // namespace

std::string to_text(const Axiom& axiom, const Ontology& ontology) {
  return Text(ontology).write(axiom);
}
std::string to_text(const ClassExpression& expression, const Ontology& ontology) {
  return Text(ontology).write(expression);
}

}  // namespace heed::owl
