#pragma once

#include <heed/dl/reasoner.h>
#include <heed/owl/ontology.h>
#include <heed/util/limits.h>

#include <memory>
#include <optional>
#include <vector>

namespace heed::dl {

/// Several sets of axioms, each of them minimal.
struct Justifications {
  std::vector<std::vector<owl::AxiomId>> sets;  ///< Ids ascending; in the order in which they were found.
  bool complete = true;                         ///< There are no others.
};

/// Subset-minimal sets of axioms from which something follows: the recorded inferences give a small set that
/// suffices, deletion makes it minimal. Everything returned entails the question and, without any one axiom,
/// no longer does (both as far as Reasoner sees). Deterministic. \cite kazakov.14.jar \cite kalyanpur.07.iswc
class Justifier {
 public:
  /// Saturates once with provenance, on the first question. \param budget  outlives this object
  Justifier(owl::Ontology ontology, util::Budget& budget);
  ~Justifier();
  Justifier(Justifier&&) noexcept;
  Justifier& operator=(Justifier&&) noexcept;

  /// Axiom ids ascending; an empty set for a tautology; nothing when it is not entailed.
  [[nodiscard]] std::optional<std::vector<owl::AxiomId>> subsumption(const owl::ClassExpression& sub,
                                                                     const owl::ClassExpression& super);
  [[nodiscard]] std::optional<std::vector<owl::AxiomId>> unsatisfiable(
      const owl::ClassExpression& expression);
  [[nodiscard]] std::optional<std::vector<owl::AxiomId>> type(owl::Iri individual,
                                                              const owl::ClassExpression& of);
  [[nodiscard]] std::optional<std::vector<owl::AxiomId>> inconsistent();
  /// The same of \p axioms alone: a minimal part of them, or nothing when they do not entail it.
  [[nodiscard]] std::optional<std::vector<owl::AxiomId>> subsumption_within(
      const std::vector<owl::AxiomId>& axioms, const owl::ClassExpression& sub,
      const owl::ClassExpression& super);

  /// Up to \p most of all justifications, found by leaving out an axiom of each one found; none when it is
  /// not entailed. Exponentially many may exist. \cite reiter.87.aij
  [[nodiscard]] Justifications all_subsumption(const owl::ClassExpression& sub,
                                               const owl::ClassExpression& super, std::size_t most);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heed::dl
