#include "verified.h"

#include <heed/job/clashes.h>

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace heed::job {

std::optional<model::Mealy> verified_machine(const Scenario& scenario, const World& world,
                                             const ControllerPart& part, const Design& design,
                                             util::Budget& budget, util::Diagnostics& warnings) {
  (void)settle_clashes(scenario, world, design, budget);
  Synthesized made = synthesize(design, scenario.perception.on_violation, budget);
  if (!made.result.realizable) {
    warnings.push_back({util::Severity::Warning,
                        part.name.location,
                        "unrealizable",
                        fmt::format("there is no controller '{}': it is left out", part.name.text),
                        "heed run says why",
                        {}});
    return std::nullopt;
  }
  if (!made.verdict->verified)
    throw std::logic_error(fmt::format("the check refuses the controller '{}'", part.name.text));
  return std::move(*made.result.machine);
}

}  // namespace heed::job
