// Whether two behaviours clash is decided by a small game: the plant moves freely, nothing is asked of it but
// that the two are never prescribed at once. Where the environment wins that, no controller can keep both
// bindings, and the last step of the lost play is the example. A pair that the assumptions keep apart is no
// clash.

#include "defeat.h"

#include <heed/game/explain.h>
#include <heed/game/game.h>
#include <heed/game/solve.h>
#include <heed/job/clashes.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace heed::job {
namespace {

struct Pair {
  std::size_t winner, loser;  ///< Indices of bindings; without a priority as in the scenario.
  bool settled;
};

/// Place in `priority`; those that it does not name come last.
std::vector<std::size_t> ranks(const Scenario& scenario, const awareness::Catalogue& catalogue) {
  std::vector<std::size_t> order;
  for (const Word& word : scenario.priority)
    order.push_back(catalogue.behaviour(awareness::Name(word.text, word.location)));
  std::vector<std::size_t> ranks;
  for (const BindingPart& binding : scenario.bindings) {
    const std::size_t behaviour =
        catalogue.behaviour(awareness::Name(binding.behaviour.text, binding.behaviour.location));
    ranks.push_back(
        static_cast<std::size_t>(std::find(order.begin(), order.end(), behaviour) - order.begin()));
  }
  return ranks;
}

bool exclude_each_other(const BindingPart& a, const BindingPart& b, const model::Fts& plant) {
  const auto impossible = [&](const logic::Formula& f) { return spec::expand_plant(f, plant).is_false(); };
  return !impossible(a.effect.formula) && !impossible(b.effect.formula) &&
         impossible(a.effect.formula && b.effect.formula);
}

std::vector<Pair> excluding_pairs(const Scenario& scenario, const World& world) {
  const std::vector<std::size_t> rank = ranks(scenario, world.knowledge.catalogue);
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < scenario.bindings.size(); ++a)
    for (std::size_t b = a + 1; b < scenario.bindings.size(); ++b)
      if (exclude_each_other(scenario.bindings[a], scenario.bindings[b], world.plant))
        pairs.push_back({rank[b] < rank[a] ? b : a, rank[b] < rank[a] ? a : b, rank[a] != rank[b]});
  return pairs;
}

/// The last step of a play in which both come to be prescribed; nothing when that can be avoided.
std::optional<game::Turn> together(const spec::Gr1& whole, const logic::Formula& both, util::Budget& budget) {
  spec::Gr1 spec = whole;
  std::erase_if(spec.sys_safety, [](const spec::Clause& c) { return c.origin != spec::Origin::Plant; });
  spec.sys_init.clear();
  spec.sys_justice.clear();
  spec.env_justice.clear();
  spec.sys_safety.push_back({!both, spec::Origin::Binding, {}});
  const game::Game game = game::build_game(spec, budget);
  game::SolveOptions solving;
  solving.iterates = true;
  const game::Region region = game::solve(game, budget, solving);
  if (region.realizable) return std::nullopt;
  game::ExplainOptions explaining;
  explaining.core_factor = explaining.core_steps = 0;
  explaining.most_moves = 1000;
  const game::Defeat defeat = game::explain(game, region, budget, explaining);
  return defeat.turns.empty() ? game::Turn{} : defeat.turns.back();
}

util::Diagnostic describe(const Scenario& scenario, const Pair& pair, const game::Turn& example,
                          const std::string& controller) {
  const BindingPart& winner = scenario.bindings[pair.winner];
  const BindingPart& loser = scenario.bindings[pair.loser];
  const std::string state = state_of(example);
  const std::string when = fmt::format("for instance{} with {} in view", state.empty() ? "" : " in " + state,
                                       seen_words(example.observation));
  if (pair.settled)
    return {util::Severity::Note,
            loser.behaviour.location,
            "behaviours-by-priority",
            fmt::format("'{}' and '{}' can be prescribed together by '{}', {}: '{}' comes first",
                        winner.behaviour.text, loser.behaviour.text, controller, when, winner.behaviour.text),
            {},
            {}};
  return {
      util::Severity::Error,
      loser.behaviour.location,
      "conflicting-behaviours",
      fmt::format("'{}' and '{}' can be prescribed together by '{}', {}, but no state of the plant is both "
                  "'{}' and '{}'",
                  winner.behaviour.text, loser.behaviour.text, controller, when, winner.effect.text,
                  loser.effect.text),
      fmt::format("say which comes first: priority = [\"{}\", \"{}\"] in [bind]", winner.behaviour.text,
                  loser.behaviour.text),
      {}};
}

}  // namespace

std::vector<Precedence> precedences(const Scenario& scenario, const World& world,
                                    const awareness::Recognition& recognition) {
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  std::vector<Precedence> found(scenario.bindings.size());
  for (std::size_t b = 0; b < scenario.bindings.size(); ++b) {
    const BindingPart& binding = scenario.bindings[b];
    const std::size_t behaviour =
        catalogue.behaviour(awareness::Name(binding.behaviour.text, binding.behaviour.location));
    const awareness::PrescribedBehaviour* known = recognition.find_behaviour(behaviour);
    found[b].prescribed = known != nullptr;
    found[b].name = known != nullptr ? known->name : "prescribed_" + catalogue.behaviours[behaviour].atom;
  }
  std::vector<Pair> pairs = excluding_pairs(scenario, world);
  const std::vector<std::size_t> rank = ranks(scenario, catalogue);
  // Whoever gives way to a behaviour must know first what that one gives way to.
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const Pair& a, const Pair& b) { return rank[a.loser] < rank[b.loser]; });
  for (const Pair& pair : pairs)
    if (pair.settled && found[pair.winner].prescribed && found[pair.loser].prescribed)
      found[pair.loser].unless =
          found[pair.loser].unless || (logic::name(found[pair.winner].name) && !found[pair.winner].unless);
  return found;
}

util::Diagnostics settle_clashes(const Scenario& scenario, const World& world, const Design& design,
                                 util::Budget& budget) {
  const std::vector<Precedence> all = precedences(scenario, world, design.recognition);
  const spec::Gr1& spec = design.composed.spec;
  util::Diagnostics notes;
  for (const Pair& pair : excluding_pairs(scenario, world)) {
    const Precedence &winner = all[pair.winner], &loser = all[pair.loser];
    if (!winner.prescribed || !loser.prescribed) continue;
    logic::Formula both = logic::name(winner.name) && logic::name(loser.name);
    if (!pair.settled) both = both && !winner.unless && !loser.unless;
    const auto example = together(spec, both, budget);
    if (!example) continue;
    util::Diagnostic found = describe(scenario, pair, *example, spec.name);
    if (!pair.settled) throw util::InputError(std::move(found));
    notes.push_back(std::move(found));
  }
  return notes;
}

}  // namespace heed::job
