#pragma once

#include <heed/dl/reasoner.h>
#include <heed/util/limits.h>

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

namespace heed::dl {

/// Between named classes; `super` is owl:Nothing where `sub` can have no instance.
struct Subsumption {
  owl::Iri sub, super;
  friend auto operator<=>(const Subsumption&, const Subsumption&) = default;
};

struct KoncludeOptions {
  std::string program = "Konclude";                 ///< A path, or a name that PATH knows.
  double seconds = 60;                              ///< Wall clock, from 0.01.
  std::size_t memory_bytes = std::size_t{4} << 30;  ///< Of its address space.
};

/// What Konclude says of the named classes, beside what Reasoner says.
struct KoncludeAnswer {
  bool consistent = true;
  /// Of its direct subsumptions those that Reasoner lacks; empty when inconsistent. In the order of ids.
  std::vector<Subsumption> added;
  /// All that Reasoner has and it lacks. One of the two is wrong there; expected to be empty.
  std::vector<Subsumption> missing;
  std::vector<std::string> remarks;  ///< Warnings of its log.
};

/// Classifies the axioms of `ours.ontology()` with Konclude (a reasoner for full OWL 2 that runs as a process
/// of its own) and compares. It gets one document without imports and annotations, so that it fetches
/// nothing, and runs within limits; its answer counts only when it ended by itself without an error in its
/// log and holds every class.
/// \throws util::InputError     "no-reasoner": not installed; "reasoner-failed": crash, an error in its log,
///                              an answer that lacks classes
/// \throws util::LimitExceeded  `options` or \p budget
[[nodiscard]] KoncludeAnswer ask_konclude(const Reasoner& ours, const KoncludeOptions& options,
                                          util::Budget& budget);

}  // namespace heed::dl
