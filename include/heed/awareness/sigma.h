#pragma once

#include <heed/awareness/policy.h>

#include <string>
#include <string_view>
#include <vector>

namespace heed::awareness {

enum class SigmaKind { Subclass, Recognition, Prescription, Disjointness };
[[nodiscard]] std::string_view to_string(SigmaKind kind);  ///< "subclass", ...

/// One formula of the knowledge base in LTL.
struct SigmaFormula {
  std::string id;  ///< "k1", "k2", ... in order.
  logic::Formula formula;
  SigmaKind kind;
  std::vector<owl::AxiomId> axioms;
  std::string sentence;  ///< In words, with labels.
  /// Prescriptions: follows from other formulas of σ, which the sentence names; printed apart.
  bool inherited = false;
  /// Any of these asks a reasoner for it; none where it is the policy's choice. (A policy that recognises
  /// from less than the definition asks for what is not entailed.)
  std::vector<Inclusion> entailed{};
};

struct SigmaOptions {
  bool disjointness =
      false;  ///< Add G !(f & g) for features that exclude each other: an assumption on the environment.
};

/// σ: subclass formulas of entities and behaviours, recognition (one per minimal evidence), prescription.
/// Only entities that \p recognition knows and their behaviours occur; with `definition` over all entities
/// that is the whole knowledge base. Inherited prescriptions come at the end and are marked.
[[nodiscard]] std::vector<SigmaFormula> build_sigma(const Catalogue& catalogue, const Perception& perception,
                                                    const Recognition& recognition,
                                                    const SigmaOptions& options = {});

}  // namespace heed::awareness
