#include <heed/job/chain.h>

namespace heed::job {

sim::Product chain(const Scenario& scenario, const World& world, const ProfilePart& profile,
                   const model::Mealy& machine, Thing thing, util::Budget& budget) {
  const Approach way = approach(profile, world, machine, thing, budget);
  const sim::Judge judge = make_judge(scenario, world, machine, false);
  return sim::product({way.chain, machine, way.binding, judge}, budget);
}

sim::RareEstimate estimate_rare(const Scenario& scenario, const World& world, const ProfilePart& profile,
                                const model::Mealy& machine, Thing thing, const sim::RareOptions& options,
                                util::Budget& budget) {
  const Approach way = approach(profile, world, machine, thing, budget);
  const sim::Judge judge = make_judge(scenario, world, machine, false);
  return sim::estimate_rare({way.chain, machine, way.binding, judge}, options, budget);
}

}  // namespace heed::job
