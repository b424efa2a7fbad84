#pragma once

#include <heed/sim/rational.h>
#include <heed/util/limits.h>

#include <cstddef>
#include <vector>

namespace heed::sim {

/// A row per state; each adds up to 1.
using TransitionMatrix = std::vector<std::vector<Rational>>;

/// The share of time that the chain spends in each state in the long run, when it begins in state 0: the
/// limit of the averages, whether or not the chain has a period. O(n^3) operations. \cite grassmann.85.or
[[nodiscard]] std::vector<Rational> long_run_shares(TransitionMatrix matrix, util::Budget& budget);

}  // namespace heed::sim
