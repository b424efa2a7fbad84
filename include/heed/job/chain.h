#pragma once

#include <heed/job/evaluate.h>
#include <heed/sim/product.h>
#include <heed/sim/rare.h>

namespace heed::job {

/// The chain that evaluate() adds up: \p machine on \p profile, with \p thing on the road.
/// \throws util::LimitExceeded  too many states to list
[[nodiscard]] sim::Product chain(const Scenario& scenario, const World& world, const ProfilePart& profile,
                                 const model::Mealy& machine, Thing thing, util::Budget& budget);

/// The probability of an outcome that hardly ever comes, estimated by splitting. \param options  Its category
/// is an index into the outcomes of [evaluate].
[[nodiscard]] sim::RareEstimate estimate_rare(const Scenario& scenario, const World& world,
                                              const ProfilePart& profile, const model::Mealy& machine,
                                              Thing thing, const sim::RareOptions& options,
                                              util::Budget& budget);

}  // namespace heed::job
