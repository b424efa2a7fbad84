#pragma once

#include "translate.h"

#include <optional>
#include <set>

namespace heed::dl {

/// Fills a Theory from axioms, one visitor per kind of axiom.
class TheoryBuilder : public ConceptSink {
 public:
  TheoryBuilder(Theory& theory, const owl::Ontology& ontology);
  void add(const owl::Axiom& axiom);
  void finish();

  Concept intern(ConceptNode node) override;
  Role role_of(owl::Iri iri, bool data) override;
  using ConceptSink::role_of;
  Concept literal(const owl::Literal& literal) override;
  Concept data_range(const owl::DataRange& range) override;

  void operator()(const owl::SubClassOf& a) { include(translate(a.sub), translate(a.super)); }
  void operator()(const owl::EquivalentClasses& a);
  void operator()(const owl::DisjointClasses& a);
  void operator()(const owl::DisjointUnion& a);
  void operator()(const owl::SubObjectPropertyOf& a);
  void operator()(const owl::EquivalentObjectProperties& a);
  void operator()(const owl::InverseObjectProperties& a);
  void operator()(const owl::ObjectPropertyDomain& a) { domain(role_of(a.property), translate(a.domain)); }
  void operator()(const owl::ObjectPropertyRange& a) { range(role_of(a.property), translate(a.range)); }
  void operator()(const owl::ObjectPropertyCharacteristic& a);
  void operator()(const owl::SubDataPropertyOf& a) {
    role_edge(role_of(a.sub, true), role_of(a.super, true));
  }
  void operator()(const owl::EquivalentDataProperties& a);
  void operator()(const owl::DataPropertyDomain& a) {
    domain(role_of(a.property, true), translate(a.domain));
  }
  void operator()(const owl::DataPropertyRange& a) { range(role_of(a.property, true), data_range(a.range)); }
  void operator()(const owl::FunctionalDataProperty& a) {
    theory_.functional_[role_of(a.property, true)] = reason_;
  }
  void operator()(const owl::DatatypeDefinition&) { drop("a datatype definition is not used"); }
  void operator()(const owl::DisjointObjectProperties&) { drop("disjoint properties are not used"); }
  void operator()(const owl::DisjointDataProperties&) { drop("disjoint properties are not used"); }
  void operator()(const owl::HasKey&) { drop("a key is not used"); }
  void operator()(const owl::SameIndividual& a);
  void operator()(const owl::DifferentIndividuals& a);
  void operator()(const owl::ClassAssertion& a) { include(individual(a.individual), translate(a.of)); }
  void operator()(const owl::ObjectPropertyAssertion& a);
  void operator()(const owl::DataPropertyAssertion& a);
  void operator()(const owl::Declaration& a);
  void operator()(const owl::AnnotationAssertion&) {}
  void operator()(const owl::SubAnnotationPropertyOf&) {}
  void operator()(const owl::AnnotationPropertyDomain&) {}
  void operator()(const owl::AnnotationPropertyRange&) {}

 protected:
  [[nodiscard]] const ConceptNode& node_of(Concept c) const override { return theory_.concepts_[c]; }

 private:
  void place_datatype(Concept c, owl::Iri datatype);
  void losses(ConceptNode& node) const;
  void include(Concept sub, Concept super);
  void disjoint(const std::vector<Concept>& members);
  void domain(Role role, Concept c);
  void range(Role role, Concept c);
  void role_edge(Role sub, Role super);
  void chain(Role first, Role second, Role super);
  Role new_role();
  Concept individual(owl::Iri iri) { return intern({ConceptKind::Individual, iri.id, 0}); }
  void deny(Concept goal);
  void place_right(Concept c);
  void place_left(Concept c);
  void place();
  void drop(const std::string& why);
  void drop_losses(unsigned loss);

  void close_roles();
  void spread_chains();
  void check_chains();
  void spread_functional();
  void use_inverses();
  void transitive_universals();
  void literal_families();

  Theory& theory_;
  const owl::Ontology& ontology_;
  const owl::Axiom* axiom_ = nullptr;
  Reason reason_ = 0;
  std::vector<std::pair<Concept, bool>> pending_;  ///< To place; true: right.
  std::vector<Chain> chains_;
  std::map<std::string, std::vector<Concept>> families_;  ///< Literals that differ from each other.
  std::vector<bool> right_roles_;                         ///< Of existentials on the right.
  std::vector<std::pair<const owl::Axiom*, Role>> functional_axioms_;
  std::uint32_t group_count_ = 0;
};

}  // namespace heed::dl
