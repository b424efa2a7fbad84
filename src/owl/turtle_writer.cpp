#include "pieces.h"

#include <heed/owl/vocabulary.h>
#include <heed/owl/write.h>

#include <fmt/format.h>

#include <array>
#include <map>
#include <set>

// "OWL 2 Mapping to RDF Graphs", section 2, as Turtle. Expressions stand in brackets where they are used;
// only those that an annotated axiom mentions twice get a name.

namespace heed::owl {
namespace {

namespace v = vocabulary;
using Kind = ClassExpression::Kind;
using Pieces = std::vector<Piece>;

constexpr std::array<const char*, 6> kind_names = {"owl:Class",
                                                   "rdfs:Datatype",
                                                   "owl:ObjectProperty",
                                                   "owl:DatatypeProperty",
                                                   "owl:AnnotationProperty",
                                                   "owl:NamedIndividual"};

bool is_plain(std::string_view text, bool may_be_empty) {
  if (text.empty()) return may_be_empty;
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (!letter(text[0])) return false;
  for (const char c : text)
    if (!letter(c) && !(c >= '0' && c <= '9') && c != '_' && c != '-') return false;
  return true;
}

std::string escaped(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text)
    if (static_cast<unsigned char>(c) <= (special.empty() ? 0x1F : 0x20) ||
        special.find(c) != std::string::npos)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else if (special.empty() && (c == '"' || c == '\\'))
      (out += '\\') += c;
    else
      out += c;
  return out;
}

/// A node that is still to be written: a name, or "[ parts ]", or "( parts )" with one part per member.
struct Node {
  enum class Form { Name, Blank, List } form = Form::Name;
  std::vector<Pieces> parts;
};

class TurtleWriter {
 public:
  explicit TurtleWriter(const Ontology& ontology) : ontology_(ontology) {}
  std::string write();

  void operator()(const Declaration& a) {
    state(name(a.entity), "rdf:type", name(kind_names[static_cast<std::size_t>(a.kind)]));
  }
  void operator()(const SubClassOf& a) { state(node(a.sub), "rdfs:subClassOf", node(a.super)); }
  void operator()(const EquivalentClasses& a) { pairs(a.classes, "owl:equivalentClass"); }
  void operator()(const DisjointClasses& a) {
    disjoint(a.classes, "owl:disjointWith", "owl:AllDisjointClasses");
  }
  void operator()(const DisjointUnion& a) { state(name(a.whole), "owl:disjointUnionOf", list(a.parts)); }
  void operator()(const SubObjectPropertyOf& a) {
    if (a.chain.size() == 1) return state(node(a.chain[0]), "rdfs:subPropertyOf", node(a.super));
    state(node(a.super), "owl:propertyChainAxiom", list(a.chain));
  }
  void operator()(const EquivalentObjectProperties& a) { pairs(a.properties, "owl:equivalentProperty"); }
  void operator()(const DisjointObjectProperties& a) {
    disjoint(a.properties, "owl:propertyDisjointWith", "owl:AllDisjointProperties");
  }
  void operator()(const InverseObjectProperties& a) {
    ObjectProperty first = a.first, second = a.second;
    if (first.inverse && second.inverse) first.inverse = second.inverse = false;
    if (first.inverse) std::swap(first, second);
    state(node(first), "owl:inverseOf", node(second));
  }
  void operator()(const ObjectPropertyDomain& a) { state(node(a.property), "rdfs:domain", node(a.domain)); }
  void operator()(const ObjectPropertyRange& a) { state(node(a.property), "rdfs:range", node(a.range)); }
  void operator()(const ObjectPropertyCharacteristic& a) {
    static constexpr const char* words[] = {"Functional", "InverseFunctional", "Reflexive", "Irreflexive",
                                            "Symmetric",  "Asymmetric",        "Transitive"};
    state(node(a.property), "rdf:type",
          name(fmt::format("owl:{}Property", words[static_cast<std::size_t>(a.characteristic)])));
  }
  void operator()(const SubDataPropertyOf& a) { state(name(a.sub), "rdfs:subPropertyOf", name(a.super)); }
  void operator()(const EquivalentDataProperties& a) { pairs(a.properties, "owl:equivalentProperty"); }
  void operator()(const DisjointDataProperties& a) {
    disjoint(a.properties, "owl:propertyDisjointWith", "owl:AllDisjointProperties");
  }
  void operator()(const DataPropertyDomain& a) { state(name(a.property), "rdfs:domain", node(a.domain)); }
  void operator()(const DataPropertyRange& a) { state(name(a.property), "rdfs:range", node(a.range)); }
  void operator()(const FunctionalDataProperty& a) {
    state(name(a.property), "rdf:type", name("owl:FunctionalProperty"));
  }
  void operator()(const DatatypeDefinition& a) {
    state(name(a.datatype), "owl:equivalentClass", node(a.range));
  }
  void operator()(const HasKey& a) {
    Node keys = list(a.object_properties);
    for (const Iri property : a.data_properties) keys.parts.push_back(inlined(name(property)));
    state(node(a.of), "owl:hasKey", std::move(keys));
  }
  void operator()(const SameIndividual& a) { pairs(a.individuals, "owl:sameAs"); }
  void operator()(const DifferentIndividuals& a) {
    disjoint(a.individuals, "owl:differentFrom", "owl:AllDifferent");
  }
  void operator()(const ClassAssertion& a) { state(name(a.individual), "rdf:type", node(a.of)); }
  void operator()(const ObjectPropertyAssertion& a) {
    if (a.negative)
      return own({"owl:NegativePropertyAssertion", "owl:sourceIndividual " + text(a.source),
                  "owl:assertionProperty " + text(a.property), "owl:targetIndividual " + text(a.target)});
    if (a.property.inverse) return state(name(a.target), text(a.property.iri), name(a.source));
    state(name(a.source), text(a.property.iri), name(a.target));
  }
  void operator()(const DataPropertyAssertion& a) {
    if (a.negative)
      return own({"owl:NegativePropertyAssertion", "owl:sourceIndividual " + text(a.source),
                  "owl:assertionProperty " + text(a.property), "owl:targetValue " + text(a.value)});
    state(name(a.source), text(a.property), name(text(a.value)));
  }
  void operator()(const AnnotationAssertion& a) {
    state(name(a.subject), text(a.property), name(text(a.value)));
  }
  void operator()(const SubAnnotationPropertyOf& a) {
    state(name(a.sub), "rdfs:subPropertyOf", name(a.super));
  }
  void operator()(const AnnotationPropertyDomain& a) {
    state(name(a.property), "rdfs:domain", name(a.domain));
  }
  void operator()(const AnnotationPropertyRange& a) { state(name(a.property), "rdfs:range", name(a.range)); }

 private:
  void prefixes();
  void undeclared();
  void state(Node subject, const std::string& predicate, Node object);
  void own(const std::vector<std::string>& parts);
  void annotate(const std::string& node, const std::vector<Annotation>& annotations);
  std::string named(Node& node, std::string& description);
  std::string fresh() { return fmt::format("_:e{}", ++fresh_); }

  template <class T>
  void pairs(const std::vector<T>& parts, const std::string& predicate) {
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) state(node(parts[i]), predicate, node(parts[i + 1]));
  }
  template <class T>
  void disjoint(const std::vector<T>& parts, const std::string& pair, const std::string& several) {
    if (parts.size() == 2) return state(node(parts[0]), pair, node(parts[1]));
    const std::string members = several == "owl:AllDifferent" ? "owl:distinctMembers " : "owl:members ";
    own({several, members + flat(inlined(list(parts)))});
  }
  template <class T>
  Node list(const std::vector<T>& parts) {
    Node out{Node::Form::List, {}};
    for (const T& part : parts) out.parts.push_back(inlined(node(part)));
    return out;
  }

  Node name(std::string text) const { return {Node::Form::Name, {{std::move(text)}}}; }
  Node name(const char* text) const { return name(std::string(text)); }
  Node name(Iri iri) const { return name(text(iri)); }
  Node node(Iri iri) const { return name(iri); }
  Node node(ObjectProperty p) const {
    if (!p.inverse) return name(p.iri);
    return {Node::Form::Blank, {{"owl:inverseOf " + text(p.iri)}}};
  }
  Node node(const ClassExpression& e) {
    if (e.is_named()) return name(e.iri());
    return {Node::Form::Blank, {body(e)}};
  }
  Node node(const DataRange& range) const {
    if (range.kind() == DataRange::Kind::Datatype) return name(range.iri());
    return {Node::Form::Blank, {{body(range)}}};
  }
  static Pieces inlined(Node node);
  std::string flat(Pieces pieces) {
    return write_pieces(std::move(pieces),
                        [this](Nested nested) { return inlined(node(*nested.expression)); });
  }

  Pieces body(const ClassExpression& e);
  Pieces restriction(const ClassExpression& e);
  std::string body(const DataRange& range) const;
  std::string text(Iri iri) const;
  std::string text(ObjectProperty p) const {
    return p.inverse ? fmt::format("[ owl:inverseOf {} ]", text(p.iri)) : text(p.iri);
  }
  std::string text(const DataRange& range) const {
    return range.kind() == DataRange::Kind::Datatype ? text(range.iri()) : fmt::format("[ {} ]", body(range));
  }
  std::string text(const Literal& l) const {
    const std::string quoted = '"' + escaped(l.value, {}) + '"';
    if (!l.language.empty()) return quoted + "@" + l.language;
    return l.datatype == v::xsd_string ? quoted : quoted + "^^" + text(l.datatype);
  }
  std::string text(const AnnotationValue& value) const {
    return std::visit([this](const auto& part) { return text(part); }, value);
  }

  const Ontology& ontology_;
  std::string out_;
  std::map<std::string, std::string, std::less<>> by_namespace_;
  const std::vector<Annotation>* annotations_ = nullptr;  ///< Of the axiom being written.
  std::size_t fresh_ = 0;
};

std::string TurtleWriter::text(Iri iri) const {
  const std::string_view full = ontology_.text(iri);
  if (full.starts_with("_:")) return std::string(full);
  const std::size_t cut = full.find_last_of("#/:") + 1;
  const auto found = by_namespace_.find(full.substr(0, cut));
  if (found != by_namespace_.end() && is_plain(full.substr(cut), false))
    return fmt::format("{}:{}", found->second, full.substr(cut));
  return fmt::format("<{}>", escaped(full, "<>\"{}|^`\\"));
}

Pieces TurtleWriter::inlined(Node node) {
  if (node.form == Node::Form::Name) return std::move(node.parts[0]);
  Pieces out = {std::string(node.form == Node::Form::Blank ? "[ " : "( ")};
  for (Pieces& part : node.parts) {
    std::move(part.begin(), part.end(), std::back_inserter(out));
    out.emplace_back(std::string(" "));
  }
  out.emplace_back(std::string(node.form == Node::Form::Blank ? "]" : ")"));
  return out;
}

/// The name of \p node; what it stands for goes to \p description where it had no name.
std::string TurtleWriter::named(Node& node, std::string& description) {
  if (node.form == Node::Form::Name) return flat(std::move(node.parts[0]));
  const std::string label = fresh();
  if (node.form == Node::Form::Blank) {
    description += label + " " + flat(std::move(node.parts[0])) + " .\n";
    return label;
  }
  const std::string first = flat(std::move(node.parts[0]));
  node.parts.erase(node.parts.begin());
  description +=
      fmt::format("{} rdf:first {} ; rdf:rest {} .\n", label, first, flat(inlined(std::move(node))));
  return label;
}

void TurtleWriter::state(Node subject, const std::string& predicate, Node object) {
  if (annotations_ == nullptr || annotations_->empty()) {
    out_ +=
        flat(inlined(std::move(subject))) + " " + predicate + " " + flat(inlined(std::move(object))) + " .\n";
    return;
  }
  std::string descriptions;
  const std::string from = named(subject, descriptions);
  const std::string to = named(object, descriptions);
  const std::string axiom = fresh();
  out_ += fmt::format("{} {} {} .\n{}", from, predicate, to, descriptions);
  out_ += fmt::format(
      "{} a owl:Axiom ; owl:annotatedSource {} ; owl:annotatedProperty {} ; owl:annotatedTarget {} .\n",
      axiom, from, predicate, to);
  annotate(axiom, *annotations_);
}

/// An axiom that is a node of its own.
void TurtleWriter::own(const std::vector<std::string>& parts) {
  const std::string label = fresh();
  out_ += fmt::format("{} a {} .\n", label, fmt::join(parts, " ; "));
  annotate(label, *annotations_);
}

/// Readers bound the nesting of annotations by 32.
void TurtleWriter::annotate(const std::string& node, const std::vector<Annotation>& annotations) {
  for (const Annotation& a : annotations) {
    const std::string property = text(a.property), value = text(a.value);
    out_ += fmt::format("{} {} {} .\n", node, property, value);
    if (a.annotations.empty()) continue;
    const std::string inner = fresh();
    out_ += fmt::format(
        "{} a owl:Annotation ; owl:annotatedSource {} ; owl:annotatedProperty {} ; owl:annotatedTarget {} "
        ".\n",
        inner, node, property, value);
    annotate(inner, a.annotations);
  }
}

std::string TurtleWriter::body(const DataRange& range) const {
  static constexpr const char* words[] = {"", "owl:intersectionOf", "owl:unionOf", "owl:datatypeComplementOf",
                                          "owl:oneOf"};
  std::string parts;
  for (const DataRange& operand : range.operands()) parts += " " + text(operand);
  for (const Literal& literal : range.literals()) parts += " " + text(literal);
  for (const Facet& facet : range.facets())
    parts += fmt::format(" [ {} {} ]", text(facet.facet), text(facet.value));
  if (range.kind() == DataRange::Kind::Restriction)
    return fmt::format("a rdfs:Datatype ; owl:onDatatype {} ; owl:withRestrictions ({} )", text(range.iri()),
                       parts);
  const char* word = words[static_cast<std::size_t>(range.kind())];
  if (range.kind() == DataRange::Kind::Complement) return fmt::format("a rdfs:Datatype ; {}{}", word, parts);
  return fmt::format("a rdfs:Datatype ; {} ({} )", word, parts);
}

Pieces TurtleWriter::body(const ClassExpression& e) {
  Pieces out;
  switch (e.kind()) {
    case Kind::Intersection:
    case Kind::Union:
      out.emplace_back(std::string("a owl:Class ; ") +
                       (e.kind() == Kind::Union ? "owl:unionOf (" : "owl:intersectionOf ("));
      for (const ClassExpression& operand : e.operands()) {
        out.emplace_back(std::string(" "));
        out.emplace_back(Nested{&operand, false});
      }
      out.emplace_back(std::string(" )"));
      return out;
    case Kind::Complement:
      return {std::string("a owl:Class ; owl:complementOf "), Nested{&e.filler(), false}};
    case Kind::OneOf: {
      std::string parts;
      for (const Iri individual : e.individuals()) parts += " " + text(individual);
      return {fmt::format("a owl:Class ; owl:oneOf ({} )", parts)};
    }
    default:
      return restriction(e);
  }
}

Pieces TurtleWriter::restriction(const ClassExpression& e) {
  const Kind kind = e.kind();
  const bool data = kind >= Kind::DataSome;
  std::string head = "a owl:Restriction ; owl:onProperty ";
  if (data && e.data_properties().size() > 1) {
    head = "a owl:Restriction ; owl:onProperties (";
    for (const Iri property : e.data_properties()) head += " " + text(property);
    head += " )";
  } else {
    head += data ? text(e.data_properties().front()) : text(e.property());
  }
  if (kind == Kind::HasSelf) return {head + " ; owl:hasSelf true"};
  if (kind == Kind::HasValue) return {head + " ; owl:hasValue " + text(e.individuals().front())};
  if (kind == Kind::DataHasValue) return {head + " ; owl:hasValue " + text(e.literal())};
  const bool some = kind == Kind::Some || kind == Kind::DataSome;
  if (some || kind == Kind::Only || kind == Kind::DataOnly) {
    head += some ? " ; owl:someValuesFrom " : " ; owl:allValuesFrom ";
    if (data) return {head + text(e.range())};
    return {head, Nested{&e.filler(), false}};
  }
  const bool min = kind == Kind::Min || kind == Kind::DataMin,
             max = kind == Kind::Max || kind == Kind::DataMax;
  const bool plain = data
                         ? e.range().kind() == DataRange::Kind::Datatype && e.range().iri() == v::rdfs_literal
                         : e.filler().is_thing();
  std::string word = min ? "owl:min" : max ? "owl:max" : "owl:";
  if (!plain) word += word.ends_with(':') ? "qualified" : "Qualified";
  word += word.ends_with(':') ? "cardinality" : "Cardinality";
  head += fmt::format(" ; {} \"{}\"^^xsd:nonNegativeInteger", word, e.cardinality());
  if (plain) return {head};
  if (data) return {head + " ; owl:onDataRange " + text(e.range())};
  return {head + " ; owl:onClass ", Nested{&e.filler(), false}};
}

void TurtleWriter::prefixes() {
  std::set<std::string> taken;
  const auto add = [&](const std::string& prefix, const std::string& uri) {
    const bool usable = is_plain(prefix, true) && !uri.empty() &&
                        std::string_view("#/:").find(uri.back()) != std::string::npos;
    if (!usable || by_namespace_.contains(uri) || !taken.insert(prefix).second) return;
    by_namespace_.emplace(uri, prefix);
    out_ += fmt::format("@prefix {}: <{}> .\n", prefix, escaped(uri, "<>\"{}|^`\\"));
  };
  add("owl", HEED_OWL), add("rdf", HEED_RDF), add("rdfs", HEED_RDFS), add("xsd", HEED_XSD);
  for (const auto& [prefix, uri] : ontology_.prefixes()) add(prefix, uri);
}

/// A graph says what a name is only where it is declared.
void TurtleWriter::undeclared() {
  std::set<std::pair<EntityKind, Iri>> declared;
  for (const Axiom& axiom : ontology_.axioms())
    if (const auto* a = axiom.as<Declaration>()) declared.emplace(a->kind, a->entity);
  for (const EntityKind kind : {EntityKind::Class, EntityKind::Datatype, EntityKind::ObjectProperty,
                                EntityKind::DataProperty, EntityKind::AnnotationProperty})
    for (const Iri entity : ontology_.entities(kind)) {
      const bool builtin =
          ontology_.text(entity).starts_with(HEED_XSD) || ontology_.text(entity).starts_with(HEED_OWL);
      if (builtin || declared.contains({kind, entity})) continue;
      state(name(entity), "rdf:type", name(kind_names[static_cast<std::size_t>(kind)]));
    }
}

std::string TurtleWriter::write() {
  prefixes();
  const std::string self =
      ontology_.iri().empty() ? fresh() : fmt::format("<{}>", escaped(ontology_.iri(), "<>\"{}|^`\\"));
  out_ += self + " a owl:Ontology";
  if (!ontology_.version_iri().empty())
    out_ += fmt::format(" ; owl:versionIRI <{}>", escaped(ontology_.version_iri(), "<>\"{}|^`\\"));
  out_ += " .\n";
  annotate(self, ontology_.annotations());
  undeclared();
  for (const Axiom& axiom : ontology_.axioms()) {
    annotations_ = &axiom.annotations;
    std::visit([this](const auto& content) { (*this)(content); }, axiom.content);
  }
  return std::move(out_);
}

}  // namespace

std::string write_turtle(const Ontology& ontology) {
  return TurtleWriter(ontology).write();
}

}  // namespace heed::owl
