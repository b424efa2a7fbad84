#pragma once

#include <heed/awareness/sigma.h>
#include <heed/dl/justifier.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace heed::awareness {

/// An axiom as the ontology states it.
struct AxiomText {
  owl::AxiomId id;
  std::string text;
  util::Location location;
};

/// One of several justifications: alone it entails the step, without any one axiom no longer.
struct Justification {
  std::vector<AxiomText> axioms;
  /// What nobody wrote either and follows from a part of these axioms: there lies the cause. Empty: here.
  std::string derived_from{};
};

struct ExplanationStep {
  std::string sentence;
  std::vector<AxiomText> axioms;
  /// Any of these asks a reasoner for the step; none where a policy decides it, or nothing does.
  std::vector<Inclusion> entailed{};
  std::vector<Justification>
      all{};               ///< Filled by justify_all(): causes before what is derived, short ones first.
  bool all_listed = true;  ///< There are no others.
};

/// Why something is so, step by step.
struct Explanation {
  std::string subject;  ///< One sentence.
  bool holds = true;
  std::vector<ExplanationStep> steps;
};

[[nodiscard]] std::vector<AxiomText> axiom_texts(const Catalogue& catalogue,
                                                 const std::vector<owl::AxiomId>& axioms);

[[nodiscard]] Explanation explain_formula(const Catalogue& catalogue, const SigmaFormula& formula);
/// What it is, looks like and prescribes.
[[nodiscard]] Explanation explain_entity(const Catalogue& catalogue, std::size_t entity);
/// Which entities prescribe it, and what it is a special way of.
[[nodiscard]] Explanation explain_behaviour(const Catalogue& catalogue, std::size_t behaviour);
[[nodiscard]] Explanation explain_warning(const Catalogue& catalogue, const Warning& warning);

/// Why \p entity is recognised when exactly \p seen (symbols and levels) is true, or what is missing.
[[nodiscard]] Explanation explain_recognition(const Catalogue& catalogue, const Recognition& recognition,
                                              std::size_t entity, const std::set<std::string>& seen);
/// Why \p behaviour is prescribed when exactly \p seen is true.
[[nodiscard]] Explanation explain_reaction(const Catalogue& catalogue, const Recognition& recognition,
                                           std::size_t behaviour, const std::set<std::string>& seen);

/// Why \p entity is no candidate when exactly \p seen is true; nothing when it is one still, or the policy
/// asks for no candidates, or the evidence against it was not listed (evidence_cap).
[[nodiscard]] std::optional<ExplanationStep> why_impossible(const Catalogue& catalogue,
                                                            const Recognition& recognition,
                                                            std::size_t entity,
                                                            const std::set<std::string>& seen);
/// The same for all that fell away.
[[nodiscard]] Explanation explain_excluded(const Catalogue& catalogue, const Recognition& recognition,
                                           const std::set<std::string>& seen);

/// Lists up to \p most of all justifications of each step that is entailed; the others keep their one reason.
/// \pre \p justifier is over the catalogue's ontology. Exponentially many may exist. \throws LimitExceeded
void justify_all(const Catalogue& catalogue, dl::Justifier& justifier, std::size_t most,
                 Explanation& explanation);

/// "because" and one line per axiom, for the excerpt of a diagnostic; empty without axioms.
[[nodiscard]] std::string because_text(const Catalogue& catalogue, const std::vector<owl::AxiomId>& axioms);

/// Indented text, one line per step and axiom: `  a12 Stop sign SubClassOf ... (traffic-signs.owl:2599:5)`.
[[nodiscard]] std::string to_text(const Explanation& explanation);

}  // namespace heed::awareness
