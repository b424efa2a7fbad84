#pragma once

#include <heed/sim/profile.h>
#include <heed/util/limits.h>

#include <vector>

namespace heed::sim {

/// The smallest chain with the same future as the one that \p steps lists, state by state: states with the
/// same future become one. `first` and `steps` of \p frame are filled, the rest is kept. \pre state 0 is the
/// start, every step leads to a state with a higher number
[[nodiscard]] Chain join_states(std::vector<std::vector<Chain::Step>> steps, Chain frame,
                                util::Budget& budget);

}  // namespace heed::sim
