#include "pieces.h"
#include "resolve.h"

#include <heed/owl/print.h>
#include <heed/owl/vocabulary.h>
#include <heed/owl/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

// The functional-style syntax of "OWL 2 Structural Specification", with full IRIs.

namespace heed::owl {
namespace {

namespace v = vocabulary;
using Kind = ClassExpression::Kind;

class Functional {
 public:
  explicit Functional(const Ontology& ontology) : ontology_(ontology) {}

  std::string write(const Axiom& axiom) {
    pieces_.clear();
    add(kind_name(axiom) + "(");
    for (const Annotation& annotation : axiom.annotations) add(text(annotation, 0) + " ");
    std::visit(*this, axiom.content);
    add(")");
    return write_pieces(std::move(pieces_), [this](Nested nested) { return expand(*nested.expression); });
  }

  void operator()(const Declaration& a) {
    static constexpr const char* kinds[] = {"Class",        "Datatype",           "ObjectProperty",
                                            "DataProperty", "AnnotationProperty", "NamedIndividual"};
    add(fmt::format("{}({})", kinds[static_cast<std::size_t>(a.kind)], text(a.entity)));
  }
  void operator()(const SubClassOf& a) { list(a.sub, a.super); }
  void operator()(const EquivalentClasses& a) { all(a.classes); }
  void operator()(const DisjointClasses& a) { all(a.classes); }
  void operator()(const DisjointUnion& a) { list(a.whole), add(" "), all(a.parts); }
  void operator()(const SubObjectPropertyOf& a) {
    if (a.chain.size() == 1) return list(a.chain.front(), a.super);
    add("ObjectPropertyChain("), all(a.chain), add(") "), list(a.super);
  }
  void operator()(const EquivalentObjectProperties& a) { all(a.properties); }
  void operator()(const DisjointObjectProperties& a) { all(a.properties); }
  void operator()(const InverseObjectProperties& a) { list(a.first, a.second); }
  void operator()(const ObjectPropertyDomain& a) { list(a.property, a.domain); }
  void operator()(const ObjectPropertyRange& a) { list(a.property, a.range); }
  void operator()(const ObjectPropertyCharacteristic& a) { list(a.property); }
  void operator()(const SubDataPropertyOf& a) { list(a.sub, a.super); }
  void operator()(const EquivalentDataProperties& a) { all(a.properties); }
  void operator()(const DisjointDataProperties& a) { all(a.properties); }
  void operator()(const DataPropertyDomain& a) { list(a.property, a.domain); }
  void operator()(const DataPropertyRange& a) { list(a.property, a.range); }
  void operator()(const FunctionalDataProperty& a) { list(a.property); }
  void operator()(const DatatypeDefinition& a) { list(a.datatype, a.range); }
  void operator()(const HasKey& a) {
    list(a.of), add(" ("), all(a.object_properties), add(") ("), all(a.data_properties), add(")");
  }
  void operator()(const SameIndividual& a) { all(a.individuals); }
  void operator()(const DifferentIndividuals& a) { all(a.individuals); }
  void operator()(const ClassAssertion& a) { list(a.of, a.individual); }
  void operator()(const ObjectPropertyAssertion& a) { list(a.property, a.source, a.target); }
  void operator()(const DataPropertyAssertion& a) { list(a.property, a.source, a.value); }
  void operator()(const AnnotationAssertion& a) { list(a.property, a.subject, a.value); }
  void operator()(const SubAnnotationPropertyOf& a) { list(a.sub, a.super); }
  void operator()(const AnnotationPropertyDomain& a) { list(a.property, a.domain); }
  void operator()(const AnnotationPropertyRange& a) { list(a.property, a.range); }

  std::string text(Iri iri) const {
    const std::string_view full = ontology_.text(iri);
    return full.starts_with("_:") ? std::string(full) : fmt::format("<{}>", full);
  }

  std::string write(const Annotation& annotation) const { return text(annotation, 0); }

 private:
  void add(const char* piece) { pieces_.emplace_back(std::string(piece)); }
  void add(std::string piece) { pieces_.emplace_back(std::move(piece)); }
  void add(const ClassExpression& e) { pieces_.emplace_back(Nested{&e, false}); }
  template <class T>
  void add(const T& part) {
    add(text(part));
  }
  template <class First, class... Rest>
  void list(const First& first, const Rest&... rest) {
    add(first);
    ((add(std::string(" ")), add(rest)), ...);
  }
  template <class T>
  void all(const std::vector<T>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i > 0) add(std::string(" "));
      add(parts[i]);
    }
  }

  std::string text(ObjectProperty p) const {
    return p.inverse ? fmt::format("ObjectInverseOf({})", text(p.iri)) : text(p.iri);
  }
  std::string text(const Literal& l) const {
    if (!l.language.empty()) return quoted(l.value) + "@" + l.language;
    if (l.datatype == v::xsd_string) return quoted(l.value);
    return quoted(l.value) + "^^" + text(l.datatype);
  }
  std::string text(const AnnotationValue& value) const {
    return std::visit([this](const auto& part) { return text(part); }, value);
  }
  std::string text(const Annotation& a, unsigned depth) const {
    std::string inner;
    for (const Annotation& more : a.annotations) inner += text(more, depth + 1) + " ";
    return fmt::format("Annotation({}{} {})", inner, text(a.property), text(a.value));
  }
  std::string text(const DataRange& range) const;
  std::vector<Piece> expand(const ClassExpression& e);

  const Ontology& ontology_;
  std::vector<Piece> pieces_;
};

/// Readers bound the nesting of data ranges by 200.
std::string Functional::text(const DataRange& range) const {
  static constexpr const char* names[] = {
      "", "DataIntersectionOf", "DataUnionOf", "DataComplementOf", "DataOneOf", "DatatypeRestriction"};
  if (range.kind() == DataRange::Kind::Datatype) return text(range.iri());
  std::vector<std::string> parts;
  if (range.kind() == DataRange::Kind::Restriction) parts.push_back(text(range.iri()));
  for (const DataRange& operand : range.operands()) parts.push_back(text(operand));
  for (const Literal& literal : range.literals()) parts.push_back(text(literal));
  for (const Facet& facet : range.facets()) parts.push_back(text(facet.facet) + " " + text(facet.value));
  return fmt::format("{}({})", names[static_cast<std::size_t>(range.kind())], fmt::join(parts, " "));
}

std::vector<Piece> Functional::expand(const ClassExpression& e) {
  static constexpr const char* names[] = {"",
                                          "ObjectIntersectionOf",
                                          "ObjectUnionOf",
                                          "ObjectComplementOf",
                                          "ObjectOneOf",
                                          "ObjectSomeValuesFrom",
                                          "ObjectAllValuesFrom",
                                          "ObjectHasValue",
                                          "ObjectHasSelf",
                                          "ObjectMinCardinality",
                                          "ObjectMaxCardinality",
                                          "ObjectExactCardinality",
                                          "DataSomeValuesFrom",
                                          "DataAllValuesFrom",
                                          "DataHasValue",
                                          "DataMinCardinality",
                                          "DataMaxCardinality",
                                          "DataExactCardinality"};
  if (e.is_named()) return {text(e.iri())};
  std::vector<Piece> saved;
  std::swap(saved, pieces_);
  add(names[static_cast<std::size_t>(e.kind())] + std::string("("));
  const bool counted = (e.kind() >= Kind::Min && e.kind() <= Kind::Exactly) || e.kind() >= Kind::DataMin;
  if (counted) add(fmt::format("{} ", e.cardinality()));
  switch (e.kind()) {
    case Kind::OneOf:
      all(e.individuals());
      break;
    case Kind::HasValue:
      list(e.property(), e.individuals().front());
      break;
    case Kind::HasSelf:
      list(e.property());
      break;
    case Kind::Some:
    case Kind::Only:
    case Kind::Min:
    case Kind::Max:
    case Kind::Exactly:
      list(e.property(), e.filler());
      break;
    case Kind::DataHasValue:
      list(e.data_properties().front(), e.literal());
      break;
    case Kind::DataSome:
    case Kind::DataOnly:
    case Kind::DataMin:
    case Kind::DataMax:
    case Kind::DataExactly:
      all(e.data_properties()), add(std::string(" ")), list(e.range());
      break;
    default:
      all(e.operands());
      break;
  }
  add(std::string(")"));
  std::swap(saved, pieces_);
  return saved;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string to_functional(const Axiom& axiom, const Ontology& ontology) {
  return Functional(ontology).write(axiom);
}

std::string to_functional(const std::vector<AxiomId>& ids, const Ontology& ontology) {
  std::string body;
  std::set<AxiomId> written;
  for (const AxiomId id : ids)
    if (written.insert(id).second) body += to_functional(ontology.axiom(id), ontology) + "\n";
  std::string head = "Ontology(";
  if (!ontology.iri().empty()) head += fmt::format("<{}>", ontology.iri());
  head += '\n';
  Functional writer(ontology);
  static constexpr std::pair<EntityKind, const char*> kinds[] = {
      {EntityKind::Class, "Class"},
      {EntityKind::Datatype, "Datatype"},
      {EntityKind::ObjectProperty, "ObjectProperty"},
      {EntityKind::DataProperty, "DataProperty"},
      {EntityKind::AnnotationProperty, "AnnotationProperty"},
      {EntityKind::NamedIndividual, "NamedIndividual"}};
  for (std::uint32_t id = v::size; id < ontology.iri_count(); ++id) {
    const std::string name = writer.text(Iri{id});
    if (name.front() != '<' || body.find(name) == std::string::npos) continue;
    for (const auto& [kind, word] : kinds)
      if (ontology.is(kind, Iri{id})) head += fmt::format("Declaration({}({}))\n", word, name);
  }
  return head + body + ")\n";
}

namespace {

/// XML lets a prefix stand for anything; nothing is lost without it, since names are written in full.
bool can_be_written(std::string_view prefix, std::string_view uri) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return std::all_of(prefix.begin(), prefix.end(), plain) &&
         first_bad_character(uri) == std::string_view::npos;
}

}  // namespace

std::string write_functional(const Ontology& ontology) {
  Functional writer(ontology);
  std::string out;
  for (const auto& [prefix, uri] : ontology.prefixes())
    if (can_be_written(prefix, uri)) out += fmt::format("Prefix({}:=<{}>)\n", prefix, uri);
  out += "Ontology(";
  if (!ontology.iri().empty()) out += fmt::format("<{}>", ontology.iri());
  if (!ontology.version_iri().empty()) out += fmt::format(" <{}>", ontology.version_iri());
  out += '\n';
  for (const Annotation& annotation : ontology.annotations()) out += writer.write(annotation) + "\n";
  for (const Axiom& axiom : ontology.axioms()) out += writer.write(axiom) + "\n";
  return out + ")\n";
}

}  // namespace heed::owl
