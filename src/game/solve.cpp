#include <heed/game/solve.h>

#include <utility>

namespace heed::game {
namespace {

using bdd::Bdd;

/// Thrown inside this file when SolveOptions::max_steps is reached; never leaves it.
struct OutOfSteps {};

///     nu Z . AND_j  mu Y . OR_i  nu X .
///         (J_sys[j] & cpre(Z))  |  cpre(Y)  |  (!J_env[i] & cpre(X))
///
/// Z shrinks as soon as one goal has lost states, not once per round. Where neither J_sys[j] nor J_env[i]
/// speaks of the step, the first two predecessors are computed once and cpre(X | Y) stands for cpre(X): the
/// environment may leave open whether it gives progress or breaks its assumption. All sets stay inside Z,
/// which changes nothing at the fixpoint and keeps each iteration monotone. Where one justice speaks of the
/// step, the whole body is one relation under one predecessor. X starts from what the same place reached
/// under a larger Z, which is above its new value since the body is monotone. \cite browne.97.tcs
class Solver {
 public:
  Solver(const Game& game, util::Budget& budget, const SolveOptions& options)
      : game_(game),
        budget_(budget),
        options_(options),
        cpre_(game, options.greedy_schedule),
        goals_(game.sys_justice.size()) {
    region_.winning = game.valid;
    stuck_ = cpre_.of_set(game.manager->constant(false));
    region_.ranks.resize(goals_);
    region_.waits.resize(goals_);
    known_.resize(goals_);
  }

  Region run() {
    try {
      outermost();
    } catch (const OutOfSteps&) {
      region_.complete = false;
    }
    region_.steps = cpre_.computed();
    if (!options_.ranks) region_.ranks.clear();
    if (!options_.ranks) region_.waits.clear();
    return std::move(region_);
  }

 private:
  /// nu Z . cpre(Z): states from which the environment can force a step without answer go first. Goals then
  /// need not find them one by one, and a defeat by safety alone is explained as one.
  bool stay_safe() {
    while (true) {
      Bdd next = region_.winning & predecessor(region_.winning);
      if (next == region_.winning) return true;
      if (!shrink(std::move(next), Part::no_clause)) return false;
    }
  }

  /// False: some start is lost, and nobody asks for more.
  bool shrink(Bdd next, std::size_t goal) {
    region_.winning = std::move(next);
    if (options_.iterates) region_.iterates.push_back({region_.winning, goal});
    return !options_.stop_early || wins_initially(game_, region_.winning);
  }

  void outermost() {
    if (!stay_safe()) return;
    std::size_t unchanged = 0;
    for (std::size_t goal = 0; unchanged < goals_; goal = (goal + 1) % goals_) {
      if (goal == 0) ++region_.outer_iterations;
      Bdd next = region_.winning & reach(goal);
      if (next == region_.winning) {
        ++unchanged;
        continue;
      }
      unchanged = 0;
      if (!shrink(std::move(next), goal)) return;
    }
    region_.realizable = wins_initially(game_, region_.winning);
  }

  /// mu Y for one goal. What progress alone wins comes first: only where it ends may a state wait for an
  /// assumption to fail, so that no strategy waits where it could go on.
  Bdd reach(std::size_t goal) {
    region_.ranks[goal].clear();
    region_.waits[goal].clear();
    const Bdd stay = stays(goal);
    Bdd Y = game_.manager->constant(false);
    for (std::size_t pass = 0;; ++pass) {
      Bdd base = progress(goal, stay, Y);
      while (!base.entails(Y)) {
        add_rank(goal, Y |= base, {});
        if (Y == region_.winning) return Y;
        base = progress(goal, stay, Y);
      }
      std::vector<Bdd> sets = wait_all(goal, pass, base, Y);
      Bdd grown = Y;
      for (const Bdd& X : sets) grown |= X;
      if (grown == Y) return Y;
      add_rank(goal, Y = std::move(grown), std::move(sets));
    }
  }

  void add_rank(std::size_t goal, const Bdd& Y, std::vector<Bdd> sets) {
    if (!options_.ranks) return;
    region_.ranks[goal].push_back(Y);
    region_.waits[goal].push_back(std::move(sets));
  }

  /// J_sys[j] & cpre(Z), where the goal speaks of one state.
  Bdd stays(std::size_t goal) {
    const Justice& justice = game_.sys_justice[goal];
    if (justice.step) return {};
    return justice.relation & region_.winning & predecessor(region_.winning);
  }

  /// (J_sys[j] & cpre(Z)) | cpre(Y)
  Bdd progress(std::size_t goal, const Bdd& stay, const Bdd& Y) {
    const Bdd& Z = region_.winning;
    if (game_.sys_justice[goal].step)
      return Z & relation_predecessor(game_.sys_justice[goal].relation.and_next(Z) | Y.next());
    return stay | (Z & (Y.is_false() ? stuck_ : predecessor(Y)));
  }

  /// The sets X, one for each assumption; kept as starting points for the next round.
  std::vector<Bdd> wait_all(std::size_t goal, std::size_t pass, const Bdd& base, const Bdd& Y) {
    auto& known = known_[goal];
    if (known.size() <= pass) known.emplace_back(game_.env_justice.size(), region_.winning);
    for (std::size_t i = 0; i < game_.env_justice.size(); ++i)
      known[pass][i] = wait(goal, i, base, Y, known[pass][i] & region_.winning);
    return known[pass];
  }

  /// nu X for one goal, rank and assumption.
  Bdd wait(std::size_t goal, std::size_t assumption, const Bdd& base, const Bdd& Y, Bdd X) {
    const Justice& J_sys = game_.sys_justice[goal];
    const Justice& J_env = game_.env_justice[assumption];
    const Bdd& Z = region_.winning;
    if (J_env.relation.is_true()) return base;
    const bool fused = J_sys.step || J_env.step;
    const Bdd progress = fused ? J_sys.relation.and_next(Z) | Y.next() : Bdd();
    while (true) {
      Bdd next = fused ? Z & relation_predecessor(progress | (!J_env.relation).and_next(X))
                       : base | (Z & !J_env.relation & predecessor(X | Y));
      if (next == X) return X;
      X = std::move(next);
    }
  }

  void step() {
    budget_.check();
    if (options_.max_steps != 0 && cpre_.computed() >= options_.max_steps) throw OutOfSteps();
  }

  Bdd predecessor(const Bdd& target) {
    step();
    return cpre_.of_set(target);
  }

  Bdd relation_predecessor(const Bdd& target) {
    step();
    return cpre_.of_relation(target);
  }

  const Game& game_;
  util::Budget& budget_;
  SolveOptions options_;
  Predecessor cpre_;
  std::size_t goals_;
  Bdd stuck_;  ///< cpre(false): the environment cannot move.
  Region region_;
  std::vector<std::vector<std::vector<Bdd>>> known_;  ///< X by goal, pass and assumption, of the last round.
};

}  // namespace

Region solve(const Game& game, util::Budget& budget, const SolveOptions& options) {
  if (!options.work_reordering) game.manager->set_steps_per_reordering(0);
  return Solver(game, budget, options).run();
}

bool wins_initially(const Game& game, const Bdd& winning) {
  const Bdd legal = game.initial_inputs();
  const Bdd possible = game.initial_answer();
  const Bdd chosen = game.outputs & game.memories;
  const Bdd wins = possible.and_exists(winning, chosen);
  switch (game.spec->initial) {
    case spec::InitialQuantifiers::ForallExists:
      return legal.entails(wins);
    case spec::InitialQuantifiers::ExistsForall:
      return !legal.implies(possible & winning).forall(game.inputs).is_false();
    case spec::InitialQuantifiers::ForallForall:
      return legal.entails(possible.exists(chosen)) && (legal & possible).entails(winning);
    default:
      return legal.intersects(wins);
  }
}

}  // namespace heed::game
