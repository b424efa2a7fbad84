#pragma once

#include "atoms.h"
#include "concepts.h"
#include "horn.h"
#include "told.h"

#include <heed/awareness/catalogue.h>
#include <heed/dl/justifier.h>

#include <map>
#include <set>
#include <vector>

namespace heed::awareness {

/// Everything above a concept, each with axioms from which it follows.
using Above = std::map<owl::Iri, Axioms>;

/// Concepts of one kind: the roots and what is below them.
struct Scope {
  std::vector<owl::Iri> roots;
  std::vector<owl::Iri> members;  ///< In the order of the ontology's table; roots included.
  std::set<owl::Iri> set;
  [[nodiscard]] bool contains(owl::Iri iri) const { return set.contains(iri); }
};

/// Builds a Catalogue pass by pass; each pass is one file. Told derivations come first, since they explain
/// themselves; the reasoner adds what they miss.
class Builder {
 public:
  Builder(const dl::Reasoner& reasoner, const CatalogueOptions& options, util::Budget& budget);
  [[nodiscard]] Catalogue build();

 private:
  // scopes.cpp
  [[nodiscard]] Scope resolve_scope(const std::vector<Name>& roots) const;
  [[nodiscard]] Scope entity_scope() const;
  [[nodiscard]] std::vector<owl::Iri> resolve_roles(const std::vector<Name>& names) const;
  [[nodiscard]] bool role_counts(owl::Iri role, const std::vector<owl::Iri>& listed) const;
  void resolve_options();
  void refuse_empty() const;

  // entities.cpp
  void add_entities();
  void add_ancestors();
  void add_parents();
  void add_entity_features();
  void note_individuals();
  [[nodiscard]] Above above(owl::Iri concept_iri, bool individual);
  [[nodiscard]] Axioms because(owl::Iri sub, owl::Iri super);
  [[nodiscard]] bool is_individual(owl::Iri iri) const;

  // features.cpp
  struct Bound {
    std::size_t entity;
    Binding binding;
    Axioms axioms;
  };
  [[nodiscard]] std::vector<Bound> bindings_of(std::size_t entity) const;
  [[nodiscard]] bool informative(owl::Iri role, owl::Iri filler) const;
  void collect_features();
  void add_feature(owl::Iri role, owl::Iri filler, bool value);
  void order_features();
  void relate_features();
  void assign_features();
  void search_features();
  void find_exclusive();
  [[nodiscard]] std::optional<Axioms> feature_implies(const Feature& special, const Feature& general);
  [[nodiscard]] std::optional<Axioms> concepts_apart(owl::Iri a, owl::Iri b);
  [[nodiscard]] const Above& above_filler(owl::Iri iri);

  // behaviours.cpp
  void add_behaviours();
  void relate_behaviours();
  void assign_behaviours();
  void search_behaviours();
  [[nodiscard]] std::vector<owl::Iri> derived_action_roles() const;

  // sufficiency.cpp
  void judge_sufficiency();
  [[nodiscard]] bool description_suffices(std::size_t entity) const;
  [[nodiscard]] bool refused(std::size_t entity);
  void judge_groups();

  // implications.cpp
  void add_implications();
  void imply_told(const owl::Axiom& axiom);
  void imply(const owl::ClassExpression& sub, const owl::ClassExpression& super, owl::AxiomId axiom);
  void imply_disjoint(const owl::ClassExpression& a, const owl::ClassExpression& b, owl::AxiomId axiom);
  void imply_single_features();
  void imply_definitions();
  [[nodiscard]] std::vector<std::size_t> underived() const;
  void imply_minimal_parts(std::size_t entity);
  [[nodiscard]] bool suffices(const std::vector<std::size_t>& features, std::size_t entity) const;
  [[nodiscard]] std::optional<Implication> named_head(const owl::ClassExpression& part) const;
  [[nodiscard]] std::optional<Implication> conditions(const owl::ClassExpression& sub) const;

  // warnings.cpp
  void warn_subsumptions();
  void warn_unsatisfiable();
  [[nodiscard]] std::optional<std::size_t> impossible_because_of(std::size_t entity) const;
  void warn_indistinguishable();
  void warn_unused();
  void warn_excludes_nothing();
  [[nodiscard]] Axioms half_exclusive(const std::set<std::size_t>& members);
  void warn_conflicts();
  void warn_no_prescription(std::size_t entity);
  void warn_never_recognised();
  void warn(std::string code, std::string message, Axioms axioms, std::vector<std::size_t> entities);
  [[nodiscard]] std::string label(std::size_t entity) const { return catalogue_.entities[entity].label; }
  [[nodiscard]] std::string gained_behaviours(std::size_t entity, std::size_t ancestor) const;
  [[nodiscard]] std::set<std::size_t> told_behaviours(std::size_t entity) const;

  [[nodiscard]] const owl::Ontology& ontology() const { return reasoner_.ontology(); }
  [[nodiscard]] std::string label_of(owl::Iri iri) const { return ontology().name(iri, options_.language); }

  const dl::Reasoner& reasoner_;
  const CatalogueOptions& options_;
  util::Budget& budget_;
  Told told_;
  dl::Justifier justifier_;
  Scope entities_, features_, behaviours_;
  std::vector<owl::Iri> feature_roles_, action_roles_;
  std::map<owl::Iri, std::size_t> entity_index_, behaviour_index_;
  std::map<std::pair<owl::Iri, owl::Iri>, std::size_t>
      feature_index_;                       ///< (role, filler); role is Iri{} for classes.
  std::vector<Above> above_;                ///< Per entity.
  std::map<owl::Iri, Above> filler_above_;  ///< Memo of above() for fillers.
  Catalogue catalogue_;
};

}  // namespace heed::awareness
