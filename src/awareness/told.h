#pragma once

#include <heed/owl/ontology.h>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace heed::awareness {

using Axioms = std::vector<owl::AxiomId>;

/// The sorted union.
[[nodiscard]] Axioms join(const Axioms& a, const Axioms& b);

/// Edges "is below" that single axioms state, and shortest derivations along them. A shortest path keeps
/// explanations short; what it derives is entailed, what it does not may still be.
class ToldGraph {
 public:
  void add(owl::Iri sub, owl::Iri super, owl::AxiomId axiom) { edges_[sub].push_back({super, axiom}); }
  /// Axioms of a shortest path, empty for sub == super.
  [[nodiscard]] std::optional<Axioms> path(owl::Iri sub, owl::Iri super) const;
  /// Everything above, with the axioms of a shortest path; \p sub included.
  [[nodiscard]] std::map<owl::Iri, Axioms> above(owl::Iri sub) const;

 private:
  struct Edge {
    owl::Iri super;
    owl::AxiomId axiom;
  };
  std::map<owl::Iri, std::vector<Edge>> edges_;
};

/// "Everything that is `holder` has a `filler` by `role`", as one axiom states it.
struct Binding {
  owl::Iri role;
  owl::Iri filler;
  bool value = false;  ///< The filler is an individual.
  owl::AxiomId axiom;
};

/// What the axioms of an ontology say one by one, in the form that the catalogue asks for.
struct Told {
  explicit Told(const owl::Ontology& ontology, std::optional<owl::Iri> subclass_role = {});

  ToldGraph concepts;  ///< Classes, and individuals below classes and (by the role) individuals.
  ToldGraph roles;
  std::map<owl::Iri, std::vector<Binding>> bindings;  ///< By holder: a class or an individual.
  std::map<owl::Iri, owl::AxiomId> functional;
  std::map<owl::Iri, std::vector<owl::Iri>> ranges;
  std::map<std::pair<owl::Iri, owl::Iri>, owl::AxiomId>
      disjoint;  ///< Both ways; classes, and individuals that differ.
  std::map<owl::Iri, util::Location> declared;
  /// Roles by which more may be bound than `bindings` and `roles` show: chains, transitivity, inclusions of
  /// complex classes.
  std::set<owl::Iri> derived;

  /// Why \p role has at most one value: the axioms, or nothing.
  [[nodiscard]] std::optional<Axioms> functional_because(owl::Iri role) const;
  /// Why what a thing has by either of two roles is one and the same; nothing says so of most.
  [[nodiscard]] std::optional<Axioms> functional_because(owl::Iri a, owl::Iri b) const;

 private:
  void read_axiom(const owl::Axiom& axiom, std::optional<owl::Iri> subclass_role);
  void read_class_axiom(const owl::Axiom& axiom);
  void read_role_axiom(const owl::Axiom& axiom);
  void read_assertion(const owl::Axiom& axiom, std::optional<owl::Iri> subclass_role);
  void read_inclusion(const owl::ClassExpression& sub, const owl::ClassExpression& super, owl::AxiomId axiom);
  void add_disjoint(owl::Iri a, owl::Iri b, owl::AxiomId axiom);
  void read_conjunct(owl::Iri holder, const owl::ClassExpression& conjunct, owl::AxiomId axiom);
};

/// Operands of nested intersections; the expression itself when it is none.
[[nodiscard]] std::vector<owl::ClassExpression> conjuncts(const owl::ClassExpression& expression);

}  // namespace heed::awareness
