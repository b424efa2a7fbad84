#pragma once

#include <heed/owl/ontology.h>
#include <heed/util/limits.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace heed::dl {

/// An axiom of which the reasoner uses nothing or only a part. Entailments that need the rest are missed,
/// never invented.
struct Dropped {
  owl::AxiomId axiom;
  std::string why;                  ///< "union on the right of an inclusion"
  std::vector<owl::Iri> signature;  ///< Entities of the axiom, in the order of their ids.
};

/// A group of equivalent named classes and its neighbours in the hierarchy.
struct TaxonomyNode {
  std::vector<owl::Iri> classes;      ///< By id; never empty.
  std::vector<std::size_t> parents;   ///< Direct, ascending.
  std::vector<std::size_t> children;  ///< Direct, ascending.
};

/// The named classes by subsumption. Node 0 holds owl:Thing, node 1 owl:Nothing and the unsatisfiable
/// classes; the others follow in the order of their smallest id. (In an inconsistent ontology all are in node
/// 1 and node 0 has owl:Thing alone.)
struct Taxonomy {
  std::vector<TaxonomyNode> nodes;
  /// Index of the node that holds the class; npos for a name that is no class.
  [[nodiscard]] std::size_t node_of(owl::Iri iri) const;
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  std::vector<std::size_t> index;  ///< By Iri id.
};

/// Consequence-based reasoning over the Horn part of an ontology: EL++ with functional properties, ranges,
/// universal restrictions on the right and individuals as nominals; and, to a bounded depth, reasoning by
/// cases over unions and by refutation for complements, universals and minimum cardinalities on the left.
/// Sound for all of OWL 2; incomplete() says what it did not use in full. Classifies in its constructor;
/// immutable afterwards, so that threads may share it. \cite kazakov.14.jar
class Reasoner {
 public:
  /// \throws LimitExceeded
  explicit Reasoner(owl::Ontology ontology, util::Budget& budget);
  ~Reasoner();
  Reasoner(Reasoner&&) noexcept;
  Reasoner& operator=(Reasoner&&) noexcept;

  [[nodiscard]] const owl::Ontology& ontology() const;
  [[nodiscard]] bool consistent() const;
  [[nodiscard]] bool satisfiable(owl::Iri named_class) const;
  /// T entails sub SubClassOf super. O(1). A name that the ontology does not use is a class of which nothing
  /// is known.
  [[nodiscard]] bool subsumes(owl::Iri super, owl::Iri sub) const;
  [[nodiscard]] const Taxonomy& taxonomy() const;
  /// All named superclasses, itself included, owl:Thing excluded; by id.
  [[nodiscard]] std::vector<owl::Iri> superclasses(owl::Iri named_class) const;
  /// All named classes of an individual, owl:Thing excluded, by id; `direct` only the most specific ones.
  [[nodiscard]] std::vector<owl::Iri> types(owl::Iri individual, bool direct = false) const;

  [[nodiscard]] bool satisfiable(const owl::ClassExpression& expression) const;
  /// Any class expressions of the fragment; the base is not changed, only what is new is saturated.
  /// Parts outside the fragment make the answer `false` (never a wrong `true`).
  [[nodiscard]] bool entails_subsumption(const owl::ClassExpression& sub,
                                         const owl::ClassExpression& super) const;
  /// All named superclasses of an expression (by id, owl:Thing excluded): one saturation for many questions.
  /// Empty optional: the expression is unsatisfiable, so every class is one.
  [[nodiscard]] std::optional<std::vector<owl::Iri>> superclasses(
      const owl::ClassExpression& expression) const;
  [[nodiscard]] bool entails(const owl::AxiomContent& axiom) const;

  /// By axiom id, each axiom at most once per reason.
  [[nodiscard]] const std::vector<Dropped>& incomplete() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heed::dl
