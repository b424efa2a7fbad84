#include "rules.h"

namespace heed::strategy {
namespace {

using bdd::Bdd;

Bdd put_in_memories(const game::Game& game, const Bdd& relation) {
  const auto next = game.bits(game::Owner::Memory, true);
  std::vector<std::pair<bdd::Var, Bdd>> substitution;
  for (std::size_t i = 0; i < next.size(); ++i) substitution.emplace_back(next[i], game.updates[i]);
  return substitution.empty() ? relation : relation.compose(substitution);
}

/// Puts together the rule of one goal j. With k the least rank whose set holds the state, the steps are, in
/// this order of preference,
///
///     meet:      J_sys[j] & Z'
///     approach:  ranks[j][k-1]'
///     wait:      !J_env[i] & (waits[j][k][i]' | ranks[j][k-1]')   for the least i whose set holds the state
///
/// Mealy takes the best for each next input; Moore must choose its answer before, and takes `wait` only where
/// no single answer always meets or approaches.
class RuleMaker {
 public:
  /// \param safe  rho_s. \param legal  The legal next inputs.
  RuleMaker(const game::Game& game, const game::Region& region, util::Budget& budget, std::size_t goal,
            Bdd safe, const std::vector<Bdd>& legal)
      : game_(game),
        region_(region),
        budget_(budget),
        goal_(goal),
        never_(game.manager->constant(false)),
        safe_(std::move(safe)),
        legal_(legal) {
    meet_ = (safe_ & game.sys_justice[goal].relation).and_next(region.winning);
  }

  Rule mealy() {
    const game::Justice& J_sys = game_.sys_justice[goal_];
    // A goal of states is met from where it holds and from nowhere else, whatever the next input is.
    const Bdd unmet = J_sys.step ? !answered(meet_) : !J_sys.relation;
    Rule rule{meet_, never_};
    each_rank([&](std::size_t k, const Bdd& rank, const Bdd& below) {
      const Bdd open = rank & unmet;
      if (open.is_false()) return;
      const Bdd approach = (open & safe_).and_next(below);
      const Bdd stuck = open.minus(answered(approach));
      rule.moves |= approach;
      each_wait(k, stuck, [&](std::size_t i, const Bdd& here) {
        const Bdd waiting =
            (here & safe_ & !game_.env_justice[i].relation).and_next(region_.waits[goal_][k][i]);
        rule.moves |= waiting;
        rule.waits |= answered(waiting);
      });
    });
    return rule;
  }

  Rule moore() {
    Rule rule{never_, never_};
    each_rank([&](std::size_t k, const Bdd& rank, const Bdd& below) {
      const Bdd progress = meet_ | safe_.and_next(below);
      const Bdd sure = rank & always(progress);
      rule.moves |= sure;
      each_wait(k, rank.minus(sure.exists(game_.next_outputs)), [&](std::size_t i, const Bdd& here) {
        const Bdd waiting = (safe_ & !game_.env_justice[i].relation).and_next(region_.waits[goal_][k][i]);
        rule.moves |= here & always(progress | waiting);
        rule.waits |= here & waiting.minus(progress);
      });
    });
    return rule;
  }

 private:
  [[nodiscard]] Bdd answered(const Bdd& steps) const { return steps.exists(game_.next_outputs); }

  /// Answers Y' that end in \p steps whatever the next legal input.
  [[nodiscard]] Bdd always(const Bdd& steps) const {
    Bdd failing = put_in_memories(game_, !steps);
    for (const Bdd& part : legal_) failing &= part;
    return !failing.exists(game_.next_inputs);
  }

  /// Of winning states: the same as \p states, without what was seen where that is no news. Where the state
  /// after a step must fit what was seen before it, every set of winning states speaks of that, and relations
  /// between two steps would hold what is seen twice.
  [[nodiscard]] Bdd told_by_memory(const Bdd& states) const {
    const Bdd seen_or_not = states.exists(game_.inputs);
    return (seen_or_not & region_.winning) == states ? seen_or_not : states;
  }

  template <typename Visit>
  void each_rank(const Visit& visit) {
    Bdd below = never_;
    for (std::size_t k = 0; k < region_.ranks[goal_].size(); ++k) {
      budget_.check();
      const Bdd& upto = region_.ranks[goal_][k];
      visit(k, told_by_memory(upto.minus(below)), below);
      below = upto;
    }
  }

  template <typename Visit>
  void each_wait(std::size_t k, Bdd open, const Visit& visit) {
    const std::vector<Bdd>& sets = region_.waits[goal_][k];
    for (std::size_t i = 0; i < sets.size() && !open.is_false(); ++i) {
      const Bdd& set = sets[i];
      visit(i, open & set);
      open = open.minus(set);
    }
  }

  const game::Game& game_;
  const game::Region& region_;
  util::Budget& budget_;
  std::size_t goal_;
  Bdd never_;
  Bdd safe_;  ///< Where it starts is not said: together with where it ends that makes large diagrams.
  const std::vector<Bdd>& legal_;
  Bdd meet_;
};

}  // namespace

std::vector<Rule> make_rules(const game::Game& game, const game::Region& region, util::Budget& budget) {
  std::vector<Rule> rules;
  Bdd safe = game.manager->constant(true);
  for (const game::Part& part : game.sys_safety) safe &= part.relation;
  const std::vector<Bdd> legal =
      game.spec->timing == spec::Timing::Moore ? legal_inputs(game) : std::vector<Bdd>{};
  for (std::size_t goal = 0; goal < game.sys_justice.size(); ++goal) {
    RuleMaker maker(game, region, budget, goal, safe, legal);
    rules.push_back(game.spec->timing == spec::Timing::Moore ? maker.moore() : maker.mealy());
  }
  return rules;
}

void gather_assumptions(game::Game& game, std::size_t most_nodes) {
  std::vector<Bdd> gathered;
  for (const Bdd& part : game.env_safety) {
    if (part.is_true()) continue;
    const Bdd joined = gathered.empty() ? part : gathered.back() & part;
    if (!gathered.empty() && joined.node_count() <= most_nodes)
      gathered.back() = joined;
    else
      gathered.push_back(part);
  }
  game.env_safety = std::move(gathered);
}

std::vector<Bdd> legal_inputs(const game::Game& game) {
  std::vector<Bdd> parts;
  for (const Bdd& part : game.env_safety) parts.push_back(put_in_memories(game, part));
  return parts;
}

}  // namespace heed::strategy
