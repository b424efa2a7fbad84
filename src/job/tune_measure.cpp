#include "tune_measure.h"

#include <heed/job/road.h>

#include <algorithm>

namespace heed::job {
namespace {

/// Everything of a machine that the figures depend on.
std::vector<std::uint64_t> reactions_of(const model::Mealy& machine, const sim::Judge& judge) {
  std::vector<std::uint64_t> numbers{machine.input_letters.size()};
  for (const model::Valuation& letter : machine.input_letters)
    for (const std::int32_t value : letter) numbers.push_back(static_cast<std::uint32_t>(value));
  numbers.insert(numbers.end(), machine.first.begin(), machine.first.end());
  for (std::size_t t = 0; t < machine.transitions.size(); ++t) {
    const model::Mealy::Transition& row = machine.transitions[t];
    numbers.push_back(std::uint64_t{row.input} << 32 | row.next);
    numbers.push_back(std::uint64_t{judge.event[t]} << 1 | (row.fallback ? 1U : 0U));
  }
  return numbers;
}

ProfilePart noisy(const ProfilePart& profile, const sim::Rational& level) {
  ProfilePart result = profile;
  const auto missed = [&](sim::Rational& rate) { rate *= 1 - level; };
  const auto false_too = [&](sim::Rational& rate) { rate = 1 - (1 - rate) * (1 - level); };
  for (sim::FeatureSpec& feature : result.spec.features) {
    missed(feature.detection);
    false_too(feature.false_detection);
    if (feature.detection_at_end) missed(*feature.detection_at_end);
    if (feature.false_detection_at_end) false_too(*feature.false_detection_at_end);
  }
  return result;
}

}  // namespace

TuneMeasure::TuneMeasure(const Scenario& scenario, const World& world, util::Budget& budget)
    : scenario_(scenario), world_(world), budget_(budget), needless_{std::nullopt} {
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e)
    if (catalogue.entities[e].is_leaf() && catalogue.entities[e].satisfiable &&
        !prescribes(world, e, scenario.evaluate->must_react) &&
        !prescribes(world, e, scenario.evaluate->may_react))
      needless_.emplace_back(e);
}

void TuneMeasure::add(model::Mealy machine) {
  sim::Judge judge = make_judge(scenario_, world_, machine, true);
  std::vector<std::uint64_t> reactions = reactions_of(machine, judge);
  const auto same = std::find_if(machines_.begin(), machines_.end(),
                                 [&](const Machine& other) { return other.reactions == reactions; });
  of_.push_back(static_cast<std::size_t>(same - machines_.begin()));
  if (same == machines_.end())
    machines_.push_back({std::move(machine), std::move(judge), std::move(reactions)});
}

std::vector<TuneMeasure::Look> TuneMeasure::looks(const ProfilePart& profile) const {
  std::vector<Look> found;
  std::map<std::string, std::size_t> known;
  for (const Thing thing : needless_) {
    const auto [place, added] = known.try_emplace(appearance(profile, world_, thing), found.size());
    if (added) found.push_back({thing, 0});
    ++found[place->second].count;
  }
  return found;
}

void TuneMeasure::measure(const Place& place, Tuning& tuning) {
  const ProfilePart profile = noisy(scenario_.profiles[place.profile], tuning.noise[place.noise]);
  const model::Mealy& any = machines_.front().mealy;
  const auto ready = [&](Thing thing) {
    return ready_approach(profile, world_, any.inputs, any.name, thing, budget_);
  };
  std::vector<TuneFigure> figures;
  const ReadyApproach own = ready(place.thing);
  for (const Machine& machine : machines_)
    figures.push_back(figure(exact_figures(own, machine.mealy, machine.judge, budget_)));
  for (const Look& look : looks(profile)) {
    const ReadyApproach passed = ready(look.first);
    for (std::size_t m = 0; m < machines_.size(); ++m) {
      const auto one = exact_figures(passed, machines_[m].mealy, machines_[m].judge, budget_);
      const sim::Figure reacts = complement(one.probability.back() + one.undefined);
      figures[m].needless = figures[m].needless + sim::scaled(reacts, static_cast<unsigned>(look.count));
    }
  }
  tuning.things = needless_.size();
  const sim::Figure things = sim::known(sim::Rational(static_cast<unsigned long>(needless_.size())));
  for (TuneFigure& one : figures) one.needless = ratio(one.needless, things);
  for (std::size_t policy = 0; policy < of_.size(); ++policy) {
    tuning.figures.push_back(figures[of_[policy]]);
    TuneFigure& added = tuning.figures.back();
    added.policy = policy, added.profile = place.profile, added.noise = place.noise;
  }
}

TuneFigure TuneMeasure::figure(const sim::LumpedOutcome& own) const {
  TuneFigure figure;
  figure.miss = own.probability[scenario_.evaluate->miss] + own.probability.back();
  figure.distance = sim::reaction_distance(own).mean;
  figure.needless = sim::known(0);
  if (scenario_.evaluate->speed_wanted) add_braking(own, figure);
  return figure;
}

void TuneMeasure::add_braking(const sim::LumpedOutcome& own, TuneFigure& figure) const {
  const sim::Rational speed = sim::Rational(scenario_.evaluate->speed_kmh) * 5 / 18;
  // Braking from there to rest within one cell; within n cells it is an n-th of that.
  const sim::Rational hardest = speed * speed / (2 * sim::Rational(scenario_.evaluate->cell_metres));
  const auto cells = static_cast<unsigned>(own.event_at.size() - 1);
  sim::Figure brakes = sim::known(0), sum = sim::known(0);
  unsigned shortest = 0;
  for (unsigned left = cells; left > 0; --left) {
    const sim::Figure& here = own.event_at[cells - left];
    if (here.exact ? *here.exact == 0 : here.value <= 0) continue;
    shortest = left;
    brakes = brakes + here;
    sum = sum + ratio(here, sim::known(sim::Rational(left)));
  }
  if (brakes.exact ? *brakes.exact == 0 : brakes.value <= 2 * brakes.error) return;
  figure.braking = ratio(ratio(sum, brakes), sim::known(1 / hardest));
  figure.hardest = sim::known(hardest / sim::Rational(shortest));
}

}  // namespace heed::job
