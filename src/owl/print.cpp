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

std::vector<Piece> Text::expand(Nested nested) const {
  const ClassExpression& e = *nested.expression;
  if (e.is_named()) return {text(e.iri())};
  std::vector<Piece> out;
  const bool bracketed = nested.bracketed && e.kind() != Kind::OneOf;
  if (bracketed) out.emplace_back("(");
  const auto join = [&](const char* word) {
    for (std::size_t i = 0; i < e.operands().size(); ++i) {
      if (i > 0) out.emplace_back(fmt::format(" {} ", word));
      out.emplace_back(Nested{&e.operands()[i], true});
    }
  };
  const auto quantified = [&](const std::string& word) {
    out.emplace_back(fmt::format("{} {} ", text(e.property()), word));
    out.emplace_back(Nested{&e.filler(), true});
  };
  const auto data = [&](const std::string& word) {
    std::vector<std::string> names;
    for (const Iri property : e.data_properties()) names.push_back(text(property));
    out.emplace_back(fmt::format("{} {} {}", fmt::join(names, ", "), word, text(e.range())));
  };
  switch (e.kind()) {
    case Kind::Class:
      break;
    case Kind::Intersection:
      join("and");
      break;
    case Kind::Union:
      join("or");
      break;
    case Kind::Complement:
      out.emplace_back("not "), out.emplace_back(Nested{&e.filler(), true});
      break;
    case Kind::OneOf: {
      std::vector<std::string> names;
      for (const Iri individual : e.individuals()) names.push_back(text(individual));
      out.emplace_back(fmt::format("{{{}}}", fmt::join(names, ", ")));
      break;
    }
    case Kind::Some:
      quantified("some");
      break;
    case Kind::Only:
      quantified("only");
      break;
    case Kind::HasValue:
      out.emplace_back(fmt::format("{} value {}", text(e.property()), text(e.individuals().front())));
      break;
    case Kind::HasSelf:
      out.emplace_back(text(e.property()) + " Self");
      break;
    case Kind::Min:
      quantified(fmt::format("min {}", e.cardinality()));
      break;
    case Kind::Max:
      quantified(fmt::format("max {}", e.cardinality()));
      break;
    case Kind::Exactly:
      quantified(fmt::format("exactly {}", e.cardinality()));
      break;
    case Kind::DataSome:
      data("some");
      break;
    case Kind::DataOnly:
      data("only");
      break;
    case Kind::DataHasValue:
      out.emplace_back(fmt::format("{} value {}", text(e.data_properties().front()), text(e.literal())));
      break;
    case Kind::DataMin:
      data(fmt::format("min {}", e.cardinality()));
      break;
    case Kind::DataMax:
      data(fmt::format("max {}", e.cardinality()));
      break;
    case Kind::DataExactly:
      data(fmt::format("exactly {}", e.cardinality()));
      break;
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
