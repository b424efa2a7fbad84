#pragma once

#include <heed/sim/profile.h>

#include <vector>

namespace heed::sim {

/// [feature][cell]: P(the feature is reported in that cell). Exact; O(steps * features).
[[nodiscard]] std::vector<std::vector<Rational>> reported_in_cell(const Chain& chain);

}  // namespace heed::sim
