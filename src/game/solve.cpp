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
      : game_(game), budget_(budget), options_(options), cpre_(game), goals_(game.sys_justice.size()) {
    region_.winning = game.valid;
    stuck_ = cpre_.of_set(game.manager->constant(false));
    region_.ranks.resize(goals_);
    region_.waits.resize(goals_);
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
  void outermost() {
    std::size_t unchanged = 0;
    for (std::size_t goal = 0; unchanged < goals_; goal = (goal + 1) % goals_) {
      if (goal == 0) ++region_.outer_iterations;
      Bdd next = region_.winning & reach(goal);
      if (next == region_.winning) {
        ++unchanged;
        continue;
      }
      unchanged = 0;
      region_.winning = std::move(next);
      if (options_.iterates) region_.iterates.push_back({region_.winning, goal});
      if (options_.stop_early && !wins_initially(game_, region_.winning)) return;
    }
    region_.realizable = wins_initially(game_, region_.winning);
  }

  /// mu Y for one goal.
  Bdd reach(std::size_t goal) {
    const Justice& justice = game_.sys_justice[goal];
    const Bdd& Z = region_.winning;
    const Bdd stay = justice.step ? Bdd() : justice.relation & Z & predecessor(Z);
    std::vector<Bdd>& ranks = region_.ranks[goal];
    auto& waits = region_.waits[goal];
    ranks.clear();
    Bdd Y = game_.manager->constant(false);
    for (std::size_t k = 0;; ++k) {
      if (waits.size() <= k) waits.emplace_back();
      Bdd grown = Y;
      const Bdd base = justice.step ? Bdd() : stay | (Z & (k == 0 ? stuck_ : predecessor(Y)));
      for (std::size_t i = 0; i < game_.env_justice.size(); ++i) {
        Bdd start = Z;
        if (waits[k].size() > i) start &= waits[k][i];
        Bdd X = wait(goal, i, base, Y, std::move(start));
        grown |= X;
        if (waits[k].size() <= i) waits[k].push_back(X);
        waits[k][i] = std::move(X);
      }
      if (grown == Y) break;
      Y = std::move(grown);
      if (options_.ranks) ranks.push_back(Y);
      if (Y == Z) break;
    }
    return Y;
  }

  /// nu X for one goal, rank and assumption.
  Bdd wait(std::size_t goal, std::size_t assumption, const Bdd& base, const Bdd& Y, Bdd X) {
    const Justice& J_sys = game_.sys_justice[goal];
    const Justice& J_env = game_.env_justice[assumption];
    const Bdd& Z = region_.winning;
    if (!J_sys.step && J_env.relation.is_true()) return base;
    const Bdd progress = J_sys.step || J_env.step ? J_sys.relation.and_next(Z) | Y.next() : Bdd();
    while (true) {
      Bdd next;
      if (progress.valid())
        next = Z & relation_predecessor(progress | (!J_env.relation).and_next(X));
      else
        next = base | (Z & !J_env.relation & predecessor(X | Y));
      if (next == X) return X;
      if (J_env.relation.is_true()) return next;
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
};

}  // namespace

Region solve(const Game& game, util::Budget& budget, const SolveOptions& options) {
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
