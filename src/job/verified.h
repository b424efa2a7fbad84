#pragma once

#include <heed/job/controller.h>
#include <heed/model/mealy.h>
#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>

#include <optional>

namespace heed::job {

/// The verified machine of \p part, whose specification is \p design. Where there is none it says so in \p
/// warnings. \throws util::InputError  "conflicting-behaviours"; util::LimitExceeded; std::logic_error  The
/// check refuses it, a defect of heed
[[nodiscard]] std::optional<model::Mealy> verified_machine(const Scenario& scenario, const World& world,
                                                           const ControllerPart& part, const Design& design,
                                                           util::Budget& budget, util::Diagnostics& warnings);

}  // namespace heed::job
