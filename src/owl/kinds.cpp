#include "kinds.h"

#include <heed/owl/vocabulary.h>

#include <unordered_map>

namespace heed::owl {
namespace {

namespace v = vocabulary;
using Kind = EntityKind;

/// The properties of the restrictions of one graph, by blank node.
class Inference {
 public:
  Inference(const Graph& graph, KindTable& kinds, const IriTable& iris)
      : graph_(graph), kinds_(kinds), iris_(iris) {}
  bool run();

 private:
  void use_of(const Triple& t);
  void restriction(const Triple& t);
  void properties_alike(Term a, Term b);
  void list_members(Term head, Kind kind);
  void data_nodes();
  void note(Kind kind, Term term) {
    if (!term.is_iri() || (term.as_iri().id < v::size)) return;
    if (kinds_.add(kind, term.as_iri())) changed_ = true;
  }
  void note_class(Term term) {
    if (term.is_iri() && !is_datatype(term.as_iri(), kinds_, iris_)) note(Kind::Class, term);
  }
  void note_property(Kind kind, Term term) {
    if (term.is_iri() && !kinds_.is_property(term.as_iri())) note(kind, term);
  }
  [[nodiscard]] bool is_data(Term term) const {
    if (term.is_literal()) return true;
    if (term.is_blank()) return data_blank_[term.number()];
    return is_datatype(term.as_iri(), kinds_, iris_);
  }

  const Graph& graph_;
  KindTable& kinds_;
  const IriTable& iris_;
  std::unordered_map<std::uint32_t, Term> on_property_;
  std::vector<bool> data_blank_;
  std::unordered_map<std::uint32_t, std::pair<Term, Term>> cells_;
  bool changed_ = false;
};

void Inference::data_nodes() {
  data_blank_.assign(graph_.blank_count, false);
  for (const Triple& t : graph_.triples) {
    if (t.predicate == v::owl_on_property) on_property_.emplace(t.subject.bits(), t.object);
    if (t.predicate == v::rdf_first) cells_[t.subject.bits()].first = t.object;
    if (t.predicate == v::rdf_rest) cells_[t.subject.bits()].second = t.object;
    if (t.predicate == v::rdf_type && t.subject.is_blank() &&
        (t.object == v::rdfs_datatype || t.object == v::owl_data_range))
      data_blank_[t.subject.number()] = true;
  }
}

void Inference::list_members(Term head, Kind kind) {
  for (std::size_t steps = 0; steps <= cells_.size(); ++steps) {
    const auto cell = cells_.find(head.bits());
    if (cell == cells_.end()) return;
    if (kind == Kind::Class)
      note_class(cell->second.first);
    else if (kind == Kind::ObjectProperty)
      note_property(kind, cell->second.first);
    else
      note(kind, cell->second.first);
    head = cell->second.second;
  }
}

void Inference::restriction(const Triple& t) {
  const auto property = on_property_.find(t.subject.bits());
  if (property == on_property_.end()) return;
  const bool data =
      t.predicate == v::owl_on_data_range || (t.predicate != v::owl_on_class && is_data(t.object));
  note_property(data ? Kind::DataProperty : Kind::ObjectProperty, property->second);
  if (data) return;
  if (t.predicate == v::owl_has_value)
    note(Kind::NamedIndividual, t.object);
  else
    note_class(t.object);
}

void Inference::properties_alike(Term a, Term b) {
  if (!a.is_iri() || !b.is_iri()) return;
  for (const Kind kind : {Kind::ObjectProperty, Kind::DataProperty, Kind::AnnotationProperty}) {
    if (kinds_.has(kind, b.as_iri())) note_property(kind, a);
    if (kinds_.has(kind, a.as_iri())) note_property(kind, b);
  }
}

void Inference::use_of(const Triple& t) {
  switch (t.predicate.id) {
    case v::rdf_type.id:
      if (t.object.is_iri() && t.object.as_iri().id >= v::size) note_class(t.object);
      break;
    case v::rdfs_sub_class_of.id:
    case v::owl_disjoint_with.id:
      note_class(t.subject);
      note_class(t.object);
      break;
    case v::owl_equivalent_class.id:
      if (is_data(t.object) && t.subject.is_iri() && !kinds_.has(Kind::Class, t.subject.as_iri()))
        note(Kind::Datatype, t.subject);
      else
        note_class(t.subject), note_class(t.object);
      break;
    case v::owl_intersection_of.id:
    case v::owl_union_of.id:
    case v::owl_disjoint_union_of.id:
      if (!is_data(t.subject)) note_class(t.subject), list_members(t.object, Kind::Class);
      break;
    case v::owl_complement_of.id:
      note_class(t.object);
      break;
    case v::owl_on_class.id:
    case v::owl_on_data_range.id:
    case v::owl_some_values_from.id:
    case v::owl_all_values_from.id:
    case v::owl_has_value.id:
      restriction(t);
      break;
    case v::owl_inverse_of.id:
      note_property(Kind::ObjectProperty, t.subject);
      note_property(Kind::ObjectProperty, t.object);
      break;
    case v::owl_property_chain_axiom.id:
      note_property(Kind::ObjectProperty, t.subject);
      list_members(t.object, Kind::ObjectProperty);
      break;
    case v::rdfs_sub_property_of.id:
    case v::owl_equivalent_property.id:
    case v::owl_property_disjoint_with.id:
      properties_alike(t.subject, t.object);
      break;
    case v::rdfs_range.id:
      if (is_data(t.object)) note_property(Kind::DataProperty, t.subject);
      if (t.object.is_blank() && !is_data(t.object)) note_property(Kind::ObjectProperty, t.subject);
      if (t.subject.is_iri() && kinds_.has(Kind::ObjectProperty, t.subject.as_iri())) note_class(t.object);
      break;
    default:
      break;
  }
}

bool Inference::run() {
  data_nodes();
  for (const Triple& t : graph_.triples) use_of(t);
  return changed_;
}

void declare(const Triple& t, KindTable& kinds) {
  const Iri name = t.subject.as_iri();
  if (name.id < v::size) return;
  switch (t.object.bits()) {
    case v::owl_class.id:
    case v::rdfs_class.id:
    case v::owl_deprecated_class.id:
      kinds.add(Kind::Class, name);
      break;
    case v::rdfs_datatype.id:
    case v::owl_data_range.id:
      kinds.add(Kind::Datatype, name);
      break;
    case v::owl_object_property.id:
    case v::owl_inverse_functional_property.id:
    case v::owl_transitive_property.id:
    case v::owl_symmetric_property.id:
    case v::owl_asymmetric_property.id:
    case v::owl_reflexive_property.id:
    case v::owl_irreflexive_property.id:
      kinds.add(Kind::ObjectProperty, name);
      break;
    case v::owl_datatype_property.id:
      kinds.add(Kind::DataProperty, name);
      break;
    case v::owl_annotation_property.id:
    case v::owl_ontology_property.id:
      kinds.add(Kind::AnnotationProperty, name);
      break;
    case v::owl_named_individual.id:
      kinds.add(Kind::NamedIndividual, name);
      break;
    default:
      break;
  }
}

}  // namespace

bool is_datatype(Iri iri, const KindTable& kinds, const IriTable& iris) {
  if (kinds.has(Kind::Datatype, iri)) return !kinds.has(Kind::Class, iri);
  const std::string_view text = iris.text(iri);
  return text.starts_with(HEED_XSD) || text == HEED_OWL "real" || text == HEED_OWL "rational";
}

void add_builtin_kinds(KindTable& kinds, IriTable& iris) {
  kinds.add(Kind::Class, v::owl_thing);
  kinds.add(Kind::Class, v::owl_nothing);
  kinds.add(Kind::ObjectProperty, v::owl_top_object_property);
  kinds.add(Kind::ObjectProperty, v::owl_bottom_object_property);
  kinds.add(Kind::DataProperty, v::owl_top_data_property);
  kinds.add(Kind::DataProperty, v::owl_bottom_data_property);
  for (std::uint32_t id = v::rdfs_literal.id; id <= v::rdf_xml_literal.id; ++id)
    kinds.add(Kind::Datatype, Iri{id});
  for (std::uint32_t id = v::rdfs_label.id; id <= v::owl_deprecated.id; ++id)
    kinds.add(Kind::AnnotationProperty, Iri{id});
  for (const char* datatype : {HEED_OWL "real", HEED_OWL "rational"})
    kinds.add(Kind::Datatype, iris.intern(datatype));
}

void collect_declared(const Graph& graph, KindTable& kinds) {
  for (const Triple& t : graph.triples)
    if (t.predicate == v::rdf_type && t.subject.is_iri() && t.object.is_iri()) declare(t, kinds);
}

bool infer_from_use(const Graph& graph, KindTable& kinds, const IriTable& iris) {
  return Inference(graph, kinds, iris).run();
}

}  // namespace heed::owl
