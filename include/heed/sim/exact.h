#pragma once

#include <heed/sim/rational.h>
#include <heed/sim/run.h>
#include <heed/util/limits.h>

#include <vector>

namespace heed::sim {

/// The exact distribution of outcomes. `probability` and `undefined` add up to 1.
struct ExactOutcome {
  std::vector<Rational> probability;  ///< Per category of the judge.
  Rational undefined = 0;             ///< A row was missing before the run had a category.
  Rational missing = 0;               ///< A row was missing at any time of the run, after its event included.
  Rational fallback = 0;              ///< At least one row marked as fallback was taken.
  /// P(the run gets its category from this observation): the blank one, then that of each cell.
  std::vector<Rational> event_at;
};

/// Forward dynamic programming over the product of chain and machine, with exact rationals. The result
/// depends on the values only. Cost: reachable (chain state, machine state, category) triples x branches per
/// cell. \throws util::LimitExceeded
[[nodiscard]] ExactOutcome exact_outcome(const Run& run, util::Budget& budget);

}  // namespace heed::sim
