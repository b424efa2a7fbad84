#pragma once

#include <heed/job/scenario.h>
#include <heed/model/fts.h>
#include <heed/util/diagnostic.h>

namespace heed::job {

/// Comparisons in the scenario that no state of \p plant can meet, such as `location = 7` on a way of five
/// cells: allowed, and hardly meant. One warning each, at its place.
[[nodiscard]] util::Diagnostics impossible_values(const Scenario& scenario, const model::Fts& plant);

}  // namespace heed::job
