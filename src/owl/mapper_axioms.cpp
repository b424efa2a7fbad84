#include "kinds.h"
#include "mapper.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::owl {

namespace v = vocabulary;

void Mapper::declaration(std::uint32_t at, EntityKind kind) {
  const Term subject = triple(at).subject;
  if (subject.is_blank()) return;
  if (subject.as_iri().id < v::size) {
    used_[at] = true;
    return;
  }
  use(kind, subject.as_iri());
  emit(at, Declaration{kind, subject.as_iri()});
}

bool Mapper::characteristic(std::uint32_t at) {
  const Triple t = triple(at);
  Characteristic which{};
  switch (t.object.bits()) {
    case v::owl_functional_property.id:
      which = Characteristic::Functional;
      break;
    case v::owl_inverse_functional_property.id:
      which = Characteristic::InverseFunctional;
      break;
    case v::owl_reflexive_property.id:
      which = Characteristic::Reflexive;
      break;
    case v::owl_irreflexive_property.id:
      which = Characteristic::Irreflexive;
      break;
    case v::owl_symmetric_property.id:
      which = Characteristic::Symmetric;
      break;
    case v::owl_asymmetric_property.id:
      which = Characteristic::Asymmetric;
      break;
    case v::owl_transitive_property.id:
      which = Characteristic::Transitive;
      break;
    default:
      return false;
  }
  if (which == Characteristic::Functional && is_data_property(t.subject)) {
    emit(at, FunctionalDataProperty{t.subject.as_iri()});
  } else if (const auto property = property_of(t.subject, at)) {
    emit(at, ObjectPropertyCharacteristic{which, *property});
  }
  return true;
}

void Mapper::typed(std::uint32_t at) {
  const Triple t = triple(at);
  if (t.object.is_literal()) return;
  switch (t.object.bits()) {
    case v::owl_class.id:
    case v::rdfs_class.id:
      return declaration(at, EntityKind::Class);
    case v::rdfs_datatype.id:
      return declaration(at, EntityKind::Datatype);
    case v::owl_object_property.id:
      return declaration(at, EntityKind::ObjectProperty);
    case v::owl_datatype_property.id:
      return declaration(at, EntityKind::DataProperty);
    case v::owl_annotation_property.id:
    case v::owl_ontology_property.id:
      return declaration(at, EntityKind::AnnotationProperty);
    case v::owl_named_individual.id:
      return declaration(at, EntityKind::NamedIndividual);
    case v::owl_all_different.id:
    case v::owl_all_disjoint_classes.id:
    case v::owl_all_disjoint_properties.id:
      return all_disjoint(at);
    case v::owl_negative_property_assertion.id:
      return negative_assertion(at);
    case v::owl_deprecated_class.id:
      declaration(at, EntityKind::Class);
      break;
    case v::rdf_property.id:
      used_[at] = t.subject.is_iri() && data_.kinds.is_property(t.subject.as_iri());
      return;
    case v::owl_data_range.id:
    case v::owl_restriction.id:
    case v::rdf_list.id:
    case v::owl_axiom.id:
    case v::owl_annotation.id:
    case v::owl_deprecated_property.id:
      break;
    default:
      if (!characteristic(at)) class_assertion(at);
      return;
  }
  if ((t.object == v::owl_deprecated_class || t.object == v::owl_deprecated_property) && t.subject.is_iri())
    emit(at, AnnotationAssertion{v::owl_deprecated, t.subject.as_iri(), Literal{"true", v::xsd_boolean, {}}});
}

void Mapper::class_assertion(std::uint32_t at) {
  const Triple t = triple(at);
  if (t.object.is_iri()) {
    const std::string_view text = data_.iris.text(t.object.as_iri());
    if (text.starts_with("http://www.w3.org/2003/11/swrl")) {
      const bool rule = text.ends_with("#Imp");
      if (rule)
        report(at, "swrl", "a SWRL rule is no axiom of OWL 2 and is left out",
               "write it as class axioms where that is possible");
      return;
    }
    if (t.object.as_iri().id < v::size && !(t.object == v::owl_thing) && !(t.object == v::owl_nothing))
      return;
  }
  if (is_data_range(t.object)) return;
  const auto of = class_of(t.object, at);
  const auto individual = of ? individual_of(t.subject, at) : std::nullopt;
  if (individual) emit(at, ClassAssertion{*of, *individual});
}

void Mapper::class_axiom(std::uint32_t at) {
  const Triple t = triple(at);
  const auto left = class_of(t.subject, at);
  const auto right = left ? class_of(t.object, at) : std::nullopt;
  if (!right) return;
  if (t.predicate == v::rdfs_sub_class_of)
    emit(at, SubClassOf{*left, *right});
  else
    emit(at, DisjointClasses{{*left, *right}});
}

void Mapper::equivalent_class(std::uint32_t at) {
  const Triple t = triple(at);
  if (t.subject.is_iri() && is_data_range(t.subject)) {
    if (auto range = range_of(t.object, at))
      emit(at, DatatypeDefinition{t.subject.as_iri(), std::move(*range)});
    return;
  }
  const auto left = class_of(t.subject, at);
  const auto right = left ? class_of(t.object, at) : std::nullopt;
  if (right) emit(at, EquivalentClasses{{*left, *right}});
}

/// OWL 1 lets a named class carry owl:unionOf and the like itself: it is equivalent to that expression.
void Mapper::direct_definition(std::uint32_t at) {
  const Triple t = triple(at);
  if (!t.subject.is_iri()) return;
  if (is_data_range(t.subject)) {
    if (t.predicate != v::owl_one_of) return;
    const auto list = list_of(t.object, at);
    std::vector<Literal> literals;
    for (const Term member : list.value_or(std::vector<Term>{}))
      if (member.is_literal()) literals.push_back(graph_.literals[member.number()]);
    if (list && literals.size() == list->size())
      emit(at, DatatypeDefinition{t.subject.as_iri(), DataRange::one_of(std::move(literals))});
    return;
  }
  const Term self = t.subject;
  use(EntityKind::Class, self.as_iri());
  std::optional<ClassExpression> definition;
  if (t.predicate == v::owl_complement_of) {
    if (const auto inner = class_of(t.object, at)) definition = ClassExpression::complement(*inner);
  } else if (t.predicate == v::owl_one_of) {
    std::vector<Iri> individuals;
    const auto list = list_of(t.object, at);
    for (const Term member : list.value_or(std::vector<Term>{}))
      if (const auto individual = individual_of(member, at)) individuals.push_back(*individual);
    if (list && individuals.size() == list->size())
      definition = ClassExpression::one_of(std::move(individuals));
  } else if (auto parts = classes_of(t.object, at)) {
    definition = t.predicate == v::owl_union_of ? ClassExpression::union_of(std::move(*parts))
                                                : ClassExpression::intersection(std::move(*parts));
  }
  if (definition) emit(at, EquivalentClasses{{ClassExpression::named(self.as_iri()), *definition}});
}

void Mapper::disjoint_union(std::uint32_t at) {
  const Triple t = triple(at);
  if (!t.subject.is_iri()) return;
  use(EntityKind::Class, t.subject.as_iri());
  auto parts = classes_of(t.object, at);
  if (!parts) return;
  if (parts->size() < 2)
    emit(at, EquivalentClasses{
                 {ClassExpression::named(t.subject.as_iri()), ClassExpression::union_of(std::move(*parts))}});
  else
    emit(at, DisjointUnion{t.subject.as_iri(), std::move(*parts)});
}

void Mapper::has_key(std::uint32_t at) {
  const Triple t = triple(at);
  const auto of = class_of(t.subject, at);
  const auto members = of ? list_of(t.object, at) : std::nullopt;
  if (!members) return;
  HasKey key{*of, {}, {}};
  for (const Term member : *members) {
    if (is_data_property(member)) {
      key.data_properties.push_back(member.as_iri());
    } else {
      const auto property = property_of(member, at);
      if (!property) return;
      key.object_properties.push_back(*property);
    }
  }
  emit(at, std::move(key));
}

void Mapper::property_inclusion(std::uint32_t at) {
  const Triple t = triple(at);
  if (t.subject.is_blank() && find(t.subject, v::rdf_first) != none)
    return property_chain(at, t.subject, t.object);
  if (is_data_property(t.subject) || is_data_property(t.object)) {
    if (!t.subject.is_iri() || !t.object.is_iri()) return;
    use(EntityKind::DataProperty, t.subject.as_iri());
    use(EntityKind::DataProperty, t.object.as_iri());
    return emit(at, SubDataPropertyOf{t.subject.as_iri(), t.object.as_iri()});
  }
  const bool annotation = t.subject.is_iri() && t.object.is_iri() &&
                          (is_annotation(t.subject.as_iri()) || is_annotation(t.object.as_iri()));
  if (annotation) return emit(at, SubAnnotationPropertyOf{t.subject.as_iri(), t.object.as_iri()});
  const auto sub = property_of(t.subject, at);
  const auto super = sub ? property_of(t.object, at) : std::nullopt;
  if (super) emit(at, SubObjectPropertyOf{{*sub}, *super});
}

void Mapper::property_chain(std::uint32_t at, Term head, Term super_term) {
  const auto super = property_of(super_term, at);
  const auto members = super ? list_of(head, at) : std::nullopt;
  if (!members) return;
  std::vector<ObjectProperty> chain;
  for (const Term member : *members) {
    const auto property = property_of(member, at);
    if (!property) return;
    chain.push_back(*property);
  }
  if (chain.empty()) return report(at, "bad-chain", "the property chain is empty");
  emit(at, SubObjectPropertyOf{std::move(chain), *super});
}

void Mapper::property_pair(std::uint32_t at) {
  const Triple t = triple(at);
  const bool equivalent = t.predicate == v::owl_equivalent_property;
  if (is_data_property(t.subject) || is_data_property(t.object)) {
    if (!t.subject.is_iri() || !t.object.is_iri()) return;
    std::vector<Iri> both = {t.subject.as_iri(), t.object.as_iri()};
    for (const Iri property : both) use(EntityKind::DataProperty, property);
    if (equivalent) return emit(at, EquivalentDataProperties{std::move(both)});
    return emit(at, DisjointDataProperties{std::move(both)});
  }
  const auto first = property_of(t.subject, at);
  const auto second = first ? property_of(t.object, at) : std::nullopt;
  if (!second) return;
  if (equivalent)
    emit(at, EquivalentObjectProperties{{*first, *second}});
  else
    emit(at, DisjointObjectProperties{{*first, *second}});
}

void Mapper::inverse_pair(std::uint32_t at) {
  const Triple t = triple(at);
  if (!t.subject.is_iri()) return;
  const auto second = property_of(t.object, at);
  if (!second) return;
  use(EntityKind::ObjectProperty, t.subject.as_iri());
  emit(at, InverseObjectProperties{{t.subject.as_iri(), false}, *second});
}

void Mapper::domain_or_range(std::uint32_t at) {
  const Triple t = triple(at);
  const bool domain = t.predicate == v::rdfs_domain;
  if (t.subject.is_iri() && is_annotation(t.subject.as_iri()) && t.object.is_iri()) {
    if (domain) return emit(at, AnnotationPropertyDomain{t.subject.as_iri(), t.object.as_iri()});
    return emit(at, AnnotationPropertyRange{t.subject.as_iri(), t.object.as_iri()});
  }
  if (is_data_property(t.subject) && !domain) {
    if (auto range = range_of(t.object, at))
      emit(at, DataPropertyRange{t.subject.as_iri(), std::move(*range)});
    return;
  }
  const auto of = class_of(t.object, at);
  if (!of) return;
  if (is_data_property(t.subject)) return emit(at, DataPropertyDomain{t.subject.as_iri(), *of});
  const auto property = property_of(t.subject, at);
  if (!property) return;
  if (domain)
    emit(at, ObjectPropertyDomain{*property, *of});
  else
    emit(at, ObjectPropertyRange{*property, *of});
}

void Mapper::individuals_pair(std::uint32_t at) {
  const Triple t = triple(at);
  const auto first = individual_of(t.subject, at);
  const auto second = first ? individual_of(t.object, at) : std::nullopt;
  if (!second) return;
  if (t.predicate == v::owl_same_as)
    emit(at, SameIndividual{{*first, *second}});
  else
    emit(at, DifferentIndividuals{{*first, *second}});
}

void Mapper::assertion(std::uint32_t at) {
  const Triple t = triple(at);
  const Term property = Term::iri(t.predicate);
  const bool object = is(EntityKind::ObjectProperty, property);
  const bool data = is(EntityKind::DataProperty, property);
  if (object && !t.object.is_literal()) {
    const auto source = individual_of(t.subject, at);
    const auto target = source ? individual_of(t.object, at) : std::nullopt;
    if (target) emit(at, ObjectPropertyAssertion{{t.predicate, false}, *source, *target});
  } else if (data && t.object.is_literal()) {
    const auto source = individual_of(t.subject, at);
    if (source) emit(at, DataPropertyAssertion{t.predicate, *source, graph_.literals[t.object.number()]});
  } else if ((object || data) && !is(EntityKind::AnnotationProperty, property)) {
    report(at, "bad-value",
           object ? fmt::format("object property '{}' has a literal as its value", show(property))
                  : fmt::format("data property '{}' has an individual as its value", show(property)),
           "the statement was left out");
  } else {
    annotation_assertion(at);
  }
}

void Mapper::annotation_assertion(std::uint32_t at) {
  const Triple t = triple(at);
  if (t.subject.is_blank() && states_[t.subject.number()] != State::New) return;
  if (!data_.kinds.has(EntityKind::AnnotationProperty, t.predicate)) {
    const std::string_view text = data_.iris.text(t.predicate);
    if (t.predicate.id < v::size || text.starts_with(HEED_OWL) || text.starts_with(HEED_RDF) ||
        text.starts_with(HEED_RDFS) || text.starts_with("http://www.w3.org/2003/11/swrl"))
      return;
    util::Diagnostic note =
        warning_at(graph_.source, t.offset, "undeclared-property",
                   fmt::format("property '{}' is not declared and is read as an annotation",
                               show(Term::iri(t.predicate))),
                   "declare it as an object, data or annotation property");
    note.severity = util::Severity::Note;
    diagnostics_.push_back(std::move(note));
    use(EntityKind::AnnotationProperty, t.predicate);
  }
  const Iri subject = t.subject.is_iri() ? t.subject.as_iri() : std::get<Iri>(annotation_value(t.subject));
  if (t.predicate == v::rdfs_label && t.object.is_literal()) {
    const Literal& label = graph_.literals[t.object.number()];
    data_.labels[subject.id].push_back({label.value, label.language, graph_.source.at(t.offset)});
  }
  emit(at, AnnotationAssertion{t.predicate, subject, annotation_value(t.object)});
}

void Mapper::all_disjoint(std::uint32_t at) {
  const Triple t = triple(at);
  auto head = take(t.subject, v::owl_members);
  if (!head) head = take(t.subject, v::owl_distinct_members);
  if (!head) return report(at, "no-members", "the axiom has no owl:members");
  const auto members = list_of(*head, at);
  if (!members) return;
  used_[at] = true;
  if (members->size() < 2)
    return report(at, "too-few", "fewer than two members differ from nothing: the axiom is left out",
                  "list at least two");
  if (t.object == v::owl_all_different) {
    std::vector<Iri> individuals;
    for (const Term member : *members)
      if (const auto individual = individual_of(member, at)) individuals.push_back(*individual);
    if (individuals.size() == members->size())
      emit(at, DifferentIndividuals{std::move(individuals)}, annotations_of(t.subject));
  } else if (t.object == v::owl_all_disjoint_classes) {
    auto classes = classes_of(*head, at);
    if (classes) emit(at, DisjointClasses{std::move(*classes)}, annotations_of(t.subject));
  } else if (std::all_of(members->begin(), members->end(), [&](Term m) { return is_data_property(m); })) {
    std::vector<Iri> properties;
    for (const Term member : *members) properties.push_back(member.as_iri());
    emit(at, DisjointDataProperties{std::move(properties)}, annotations_of(t.subject));
  } else {
    std::vector<ObjectProperty> properties;
    for (const Term member : *members)
      if (const auto property = property_of(member, at)) properties.push_back(*property);
    if (properties.size() == members->size())
      emit(at, DisjointObjectProperties{std::move(properties)}, annotations_of(t.subject));
  }
}

void Mapper::negative_assertion(std::uint32_t at) {
  const Triple t = triple(at);
  const auto source = take(t.subject, v::owl_source_individual);
  const auto property = take(t.subject, v::owl_assertion_property);
  const auto target = take(t.subject, v::owl_target_individual);
  const auto value = target ? std::nullopt : take(t.subject, v::owl_target_value);
  if (!source || !property || (!target && !value) || (value && (!value->is_literal() || !property->is_iri())))
    return report(at, "bad-negative-assertion",
                  "a negative assertion needs a source, a property and a target");
  used_[at] = true;
  const auto from = individual_of(*source, at);
  if (value) {
    use(EntityKind::DataProperty, property->as_iri());
    if (from)
      emit(at, DataPropertyAssertion{property->as_iri(), *from, graph_.literals[value->number()], true},
           annotations_of(t.subject));
    return;
  }
  const auto role = property_of(*property, at);
  const auto to = individual_of(*target, at);
  if (from && role && to)
    emit(at, ObjectPropertyAssertion{*role, *from, *to, true}, annotations_of(t.subject));
}

}  // namespace heed::owl
