#include <heed/job/road.h>

#include <heed/logic/parse.h>
#include <heed/sim/road.h>
#include <heed/spec/compose.h>
#include <heed/util/diagnostic.h>

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

namespace heed::job {
namespace {

constexpr const char* own_conflict = "observation_conflict";

/// Things that look alike and are judged alike are one kind.
class Kinds {
 public:
  Kinds(const Scenario& scenario, const World& world, const ProfilePart& profile, const model::Mealy& machine,
        Approaches& shared, util::Budget& budget)
      : scenario_(scenario),
        world_(world),
        profile_(profile),
        machine_(machine),
        shared_(shared),
        budget_(budget) {}

  std::size_t number(Thing thing) {
    const EvaluatePart& part = *scenario_.evaluate;
    const bool must = prescribes(world_, thing, part.must_react);
    const bool needless = !must && !prescribes(world_, thing, part.may_react);
    const std::string key = appearance(profile_, world_, thing) + (must ? "must" : needless ? "not" : "may");
    const auto [found, added] = numbers_.try_emplace(key, passages_.size());
    if (added) {
      add(shared_.ready(profile_, machine_, thing));
      must_.push_back(must);
      needless_.push_back(needless);
    }
    return found->second;
  }

  [[nodiscard]] const std::vector<sim::Passage>& passages() const { return passages_; }
  [[nodiscard]] bool must(std::size_t kind) const { return must_[kind]; }
  [[nodiscard]] bool needless(std::size_t kind) const { return needless_[kind]; }

 private:
  void add(const ReadyApproach& ready) {
    if (!ready.chain)
      whole_.push_back(std::make_unique<sim::Chain>(sim::compile(ready.plan.profile, budget_)));
    passages_.push_back({ready.chain ? &*ready.chain : whole_.back().get(), &ready.plan.binding});
  }

  const Scenario& scenario_;
  const World& world_;
  const ProfilePart& profile_;
  const model::Mealy& machine_;
  Approaches& shared_;
  util::Budget& budget_;
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::unique_ptr<sim::Chain>> whole_;  ///< Where it is not small.
  std::vector<sim::Passage> passages_;
  std::vector<bool> must_, needless_;
};

bool has_entity(const World& world, const Word& word) {
  try {
    (void)world.knowledge.catalogue.entity(awareness::Name(word.text, word.location));
    return true;
  } catch (const util::InputError&) {
    return false;
  }
}

/// The things that a word of a road stands for, each as likely as the others.
std::vector<Thing> things_of(const World& world, const Word& word) {
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  const bool own = (word.text == "none" || word.text == "any") && has_entity(world, word);
  if (word.text == "none" && !own) return {std::nullopt};
  if (word.text != "any" || own) return {catalogue.entity(awareness::Name(word.text, word.location))};
  std::vector<Thing> leaves;
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e)
    if (catalogue.entities[e].is_leaf() && catalogue.entities[e].satisfiable) leaves.emplace_back(e);
  return leaves;
}

std::vector<sim::Draw> draws_of(const RoadPart& road, const World& world, Kinds& kinds) {
  std::vector<std::map<std::size_t, sim::Rational>> sums;
  for (const auto& place : road.places) {
    sums.emplace_back();
    for (const RoadShare& share : place) {
      const std::vector<Thing> things = things_of(world, share.thing);
      for (const Thing thing : things)
        sums.back()[kinds.number(thing)] += share.probability / static_cast<unsigned long>(things.size());
    }
  }
  const std::size_t count = kinds.passages().size();
  std::vector<sim::Draw> draws;
  for (const auto& sum : sums) {
    draws.emplace_back(count, 0);
    for (const auto& [kind, probability] : sum) draws.back()[kind] = probability;
  }
  return draws;
}

/// Expected needless reactions, and misses. The last category is that of runs without an event.
std::pair<sim::Rational, sim::Rational> count_errors(const sim::RoadOutcome& outcome, const Kinds& kinds,
                                                     std::size_t miss) {
  sim::Rational needless = 0, misses = 0;
  for (std::size_t kind = 0; kind < outcome.expected.size(); ++kind) {
    const auto& expected = outcome.expected[kind];
    if (kinds.must(kind)) misses += expected[miss] + expected.back();
    for (std::size_t c = 0; kinds.needless(kind) && c + 1 < expected.size(); ++c) needless += expected[c];
  }
  return {needless, misses};
}

}  // namespace

bool prescribes(const World& world, Thing thing, const std::vector<Word>& behaviours) {
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  return thing && std::any_of(behaviours.begin(), behaviours.end(), [&](const Word& word) {
           const auto behaviour = catalogue.behaviour(awareness::Name(word.text, word.location));
           return catalogue.prescribes(*thing, behaviour) != nullptr;
         });
}

std::optional<std::vector<bool>> conflicts_of(const Scenario& scenario, const World& world,
                                              const model::Mealy& machine) {
  if (scenario.evaluate->conflict) {
    const auto formula =
        spec::expand_plant(world.perception.over_inputs(scenario.evaluate->conflict->formula), world.plant);
    return hold_at_transitions({formula}, machine).front();
  }
  const bool own = std::any_of(machine.outputs.begin(), machine.outputs.end(),
                               [](const model::Output& o) { return o.variable.name == own_conflict; });
  if (!own) return std::nullopt;
  return hold_at_transitions({logic::name(own_conflict)}, machine).front();
}

std::optional<sim::Rational> conflict_probability(const Scenario& scenario, const World& world,
                                                  const ProfilePart& profile, const model::Mealy& machine,
                                                  Thing thing, util::Budget& budget) {
  const auto conflicts = conflicts_of(scenario, world, machine);
  if (!conflicts) return std::nullopt;
  const Approach way = approach(profile, world, machine, thing, budget);
  const sim::Judge judge = make_judge(scenario, world, machine, true);
  sim::RoadAnalysis analysis({machine, {{&way.chain, &way.binding}}, judge, *conflicts}, budget);
  return analysis.over({{1}}).conflict;
}

void check_roads(const Scenario& scenario, const World& world) {
  for (const RoadPart& road : scenario.roads)
    for (const auto& place : road.places)
      for (const RoadShare& share : place) (void)things_of(world, share.thing);
}

RoadEvaluation evaluate_road(const Scenario& scenario, const World& world, const ProfilePart& profile,
                             const RoadPart& road, const model::Mealy& machine, Approaches& approaches,
                             util::Budget& budget) {
  Kinds kinds(scenario, world, profile, machine, approaches, budget);
  const std::vector<sim::Draw> round = draws_of(road, world, kinds);
  const sim::Judge judge = make_judge(scenario, world, machine, true);
  const auto conflicts = conflicts_of(scenario, world, machine);
  sim::RoadAnalysis analysis({machine, kinds.passages(), judge, conflicts.value_or(std::vector<bool>())},
                             budget);
  std::vector<sim::Draw> places;
  while (places.size() < road.length) places.push_back(round[places.size() % round.size()]);
  const sim::RoadOutcome whole = analysis.over(places);
  RoadEvaluation found;
  const std::size_t miss = scenario.evaluate->miss;
  std::tie(found.needless, found.misses) = count_errors(whole, kinds, miss);
  found.missing = whole.missing;
  if (conflicts) found.conflict = whole.conflict;
  const auto forever = analysis.in_the_long_run(round);
  if (!forever) return found;
  found.long_run = RoadEvaluation::PerThing{};
  const sim::Rational things = static_cast<unsigned long>(round.size());
  std::tie(found.long_run->needless, found.long_run->misses) = count_errors(*forever, kinds, miss);
  found.long_run->needless /= things;
  found.long_run->misses /= things;
  if (conflicts) found.long_run->conflicts = forever->conflicts / things;
  return found;
}

}  // namespace heed::job
