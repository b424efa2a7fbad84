#include "describe.h"

#include <fmt/format.h>

namespace heed::job {

report::Tuning describe_tuning(const Scenario& scenario, const Tuning& tuning, const TuneOptions& options) {
  report::Tuning out;
  if (options.most_needless) out.bound = sim::fraction(*options.most_needless);
  if (tuning.best) out.best = tuning.policies[*tuning.best];
  out.things = tuning.things;
  out.whole = !options.simple;
  for (const LeftOut& one : tuning.left_out) out.left_out.push_back(one.policy + ": " + one.reason);
  for (const TuneFigure& figure : tuning.figures) {
    report::TunedPolicy one;
    one.policy = tuning.policies[figure.policy];
    one.profile = scenario.profiles[figure.profile].spec.name;
    one.noise = sim::fraction(tuning.noise[figure.noise]);
    for (const OwnPolicy& own : tuning.own)
      if (own.policy == figure.policy) one.controller = scenario.controllers[own.controller].name.text;
    one.miss = number(figure.miss);
    one.needless = number(figure.needless);
    one.distance = number(figure.distance);
    if (figure.braking) one.braking = number(*figure.braking);
    if (figure.hardest) one.hardest = number(*figure.hardest);
    one.on_front = figure.on_front;
    out.figures.push_back(std::move(one));
  }
  return out;
}

}  // namespace heed::job
