#include "simplify.h"

#include <heed/game/solve.h>

#include <algorithm>
#include <utility>

namespace heed::game {
namespace {

using bdd::Bdd;

/// Thrown inside this file when SolveOptions::max_steps is reached; never leaves it.
struct OutOfSteps {};

///     nu Z . AND_j  mu Y . OR_i  nu X .
///         (J_sys[j] & cpre(Z))  |  cpre(Y)  |  (!J_env[i] & cpre(X))
///
/// Z shrinks as soon as one goal has lost states, not once per round, and then loses at once what safety
/// alone loses with it: inside a set Z that can be kept, J_sys[j] & cpre(Z) is J_sys[j] & Z. Where neither
/// J_sys[j] nor J_env[i] speaks of the step, cpre(X | Y) stands for cpre(X): the environment may leave open
/// whether it gives progress or breaks its assumption. All sets stay inside Z, which changes nothing at the
/// fixpoint and keeps each iteration monotone. Where one justice speaks of the step, the whole body is one
/// relation under one predecessor. X starts from what the same place reached under a larger Z, which is above
/// its new value since the body is monotone. \cite browne.97.tcs
class Solver {
 public:
  Solver(const Game& game, util::Budget& budget, const SolveOptions& options)
      : start_(game),
        simplified_(simplify(game, options.techniques)),
        game_(simplified_.game),
        budget_(budget),
        options_(options),
        cpre_(game_, options.techniques),
        goals_(game_.sys_justice.size()),
        never_(game.manager->constant(false)),
        stuck_(!cpre_.forced(!never_)),
        kept_(!never_) {
    region_.winning = game_.valid;
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
    put_back_invariant();
    return std::move(region_);
  }

 private:
  /// nu Z . cpre(Z): states from which the environment can force a step without answer. Goals then need not
  /// find them one by one, and a defeat by safety alone is explained as one.
  bool stay_safe() {
    while (true) {
      Bdd next = survivors(region_.winning, region_.winning, kept_);
      if (next == region_.winning) return true;
      if (!shrink(std::move(next), Part::no_clause)) return false;
    }
  }

  /// False: some start is lost, and nobody asks for more.
  bool shrink(Bdd next, std::size_t goal) {
    region_.winning = std::move(next);
    if (options_.iterates) region_.iterates.push_back({region_.winning, goal});
    return !options_.stop_early || wins_initially(start_, region_.winning);
  }

  void outermost() {
    if (cpre_.doomed().intersects(region_.winning) &&
        !shrink(region_.winning.minus(cpre_.doomed()), Part::no_clause))
      return;
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
      if (!shrink(std::move(next), goal) || !stay_safe()) return;
    }
    region_.realizable = wins_initially(start_, region_.winning);
  }

  /// What an increasing set was when it was last looked at, and the pairs that can be answered into it.
  struct Growth {
    Bdd set, answered;
  };

  /// mu Y for one goal. What progress alone wins comes first: only where it ends may a state wait for an
  /// assumption to fail, so that no strategy waits where it could go on.
  Bdd reach(std::size_t goal) {
    region_.ranks[goal].clear();
    region_.waits[goal].clear();
    Bdd Y = never_;
    Growth growth{never_, never_};
    for (std::size_t pass = 0;; ++pass) {
      Bdd more = progress(goal, Y, growth);
      while (!more.is_false()) {
        add_rank(goal, Y |= more, {});
        if (Y == region_.winning) return Y;
        more = progress(goal, Y, growth);
      }
      if (never_waits()) return Y;
      std::vector<Bdd> sets = wait_all(goal, pass, Y, growth);
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

  /// States of (J_sys[j] & cpre(Z)) | cpre(Y) that are not in Y.
  Bdd progress(std::size_t goal, const Bdd& Y, Growth& growth) {
    const Bdd& Z = region_.winning;
    const Justice& J_sys = game_.sys_justice[goal];
    if (J_sys.step) return (Z & relation_predecessor(J_sys.relation.and_next(Z) | Y.next())).minus(Y);
    const Bdd open = Z.minus(Y);
    return Y.is_false() ? open & (J_sys.relation | stuck_) : winners(open, Y, growth);
  }

  /// The states of \p open in cpre(target). \pre \p target includes growth.set
  Bdd winners(const Bdd& open, const Bdd& target, Growth& growth) {
    step();
    const Bdd news = frontier() ? smallest(target, growth.set) : target;
    const Bdd answered = cpre_.answered(news);
    growth.answered = frontier() ? growth.answered | answered : answered;
    growth.set = target;
    if (moore())
      return open.minus(cpre_.doomed()) & (!cpre_.forced(!growth.answered)).exists(game_.next_outputs);
    return open.minus(cpre_.forced(!growth.answered));
  }

  /// The states of \p within from which the environment cannot force the play out of \p target.
  /// \param answered  Pairs that could be answered into a larger target at the call before, which has taken
  /// the other ones' states out of \p within; those of this target afterwards.
  Bdd survivors(const Bdd& within, const Bdd& target, Bdd& answered) {
    step();
    Bdd now = cpre_.answered(target);
    if (moore()) return within & (!cpre_.forced(!now)).exists(game_.next_outputs);
    const Bdd lost = frontier() ? (!now).minimise(answered) : !now;
    answered = std::move(now);
    return within.minus(cpre_.forced(lost));
  }

  /// A set between set \ known and set, with few nodes.
  static Bdd smallest(const Bdd& set, const Bdd& known) {
    const Bdd between = set.restrict(!known);
    const Bdd news = set.minus(known);
    return between.node_count() < news.node_count() ? between : news;
  }

  /// The sets X, one for each assumption; kept as starting points for the next round.
  std::vector<Bdd> wait_all(std::size_t goal, std::size_t pass, const Bdd& Y, const Growth& growth) {
    const Bdd base = whole_progress(goal, Y, growth);
    auto& known = known_[goal];
    if (known.size() <= pass) known.emplace_back(game_.env_justice.size(), region_.winning);
    for (std::size_t i = 0; i < game_.env_justice.size(); ++i)
      known[pass][i] = wait(goal, i, base, Y, known[pass][i] & region_.winning);
    return known[pass];
  }

  /// (J_sys[j] & cpre(Z)) | cpre(Y)
  Bdd whole_progress(std::size_t goal, const Bdd& Y, const Growth& growth) {
    const Bdd& Z = region_.winning;
    const Justice& J_sys = game_.sys_justice[goal];
    if (J_sys.step) return Z & relation_predecessor(J_sys.relation.and_next(Z) | Y.next());
    Bdd again = !cpre_.forced(!growth.answered);
    if (moore()) again = again.exists(game_.next_outputs);
    return Z & (J_sys.relation | again);
  }

  /// nu X for one goal, rank and assumption.
  Bdd wait(std::size_t goal, std::size_t assumption, const Bdd& base, const Bdd& Y, Bdd X) {
    const Justice& J_sys = game_.sys_justice[goal];
    const Justice& J_env = game_.env_justice[assumption];
    if (J_env.relation.is_true()) return base;
    if (J_sys.step || J_env.step) return wait_in_steps(J_sys, J_env, Y, std::move(X));
    X &= base | !J_env.relation;
    Bdd answered = game_.manager->constant(true);
    while (true) {
      Bdd next = base | survivors(X, X | Y, answered);
      if (next == X) return X;
      X = std::move(next);
    }
  }

  Bdd wait_in_steps(const Justice& J_sys, const Justice& J_env, const Bdd& Y, Bdd X) {
    const Bdd& Z = region_.winning;
    const Bdd progress = J_sys.relation.and_next(Z) | Y.next();
    while (true) {
      Bdd next = Z & relation_predecessor(progress | (!J_env.relation).and_next(X));
      if (next == X) return X;
      X = std::move(next);
    }
  }

  /// Every assumption is kept for ever, so that waiting for one to fail never helps.
  [[nodiscard]] bool never_waits() const {
    return std::all_of(game_.env_justice.begin(), game_.env_justice.end(),
                       [](const Justice& justice) { return justice.relation.is_true(); });
  }

  [[nodiscard]] bool moore() const { return game_.spec->timing == spec::Timing::Moore; }
  [[nodiscard]] bool frontier() const { return options_.techniques.frontier_sets; }

  void step() {
    budget_.check();
    if (options_.max_steps != 0 && cpre_.computed() >= options_.max_steps) throw OutOfSteps();
    cpre_.count();
  }

  Bdd relation_predecessor(const Bdd& target) {
    budget_.check();
    if (options_.max_steps != 0 && cpre_.computed() >= options_.max_steps) throw OutOfSteps();
    return cpre_.of_relation(target);
  }

  /// What was put in or left unsaid, so that every set is one of the game that was asked about.
  void put_back_invariant() {
    region_.invariant = simplified_.invariant;
    region_.winning &= simplified_.invariant;
    for (Iterate& iterate : region_.iterates) iterate.region &= simplified_.invariant;
    for (auto& sets : region_.ranks)
      for (Bdd& set : sets) set &= simplified_.invariant;
    for (auto& ranks : region_.waits)
      for (auto& sets : ranks)
        for (Bdd& set : sets) set &= simplified_.invariant;
  }

  const Game& start_;
  Simplified simplified_;
  const Game& game_;
  util::Budget& budget_;
  SolveOptions options_;
  Predecessor cpre_;
  std::size_t goals_;
  Bdd never_;
  Bdd stuck_;  ///< The environment cannot move.
  Bdd kept_;   ///< Pairs of state and next inputs that can be answered into Z, at the last look.
  Region region_;
  std::vector<std::vector<std::vector<Bdd>>> known_;  ///< X by goal, pass and assumption, of the last round.
};

}  // namespace

Region solve(const Game& game, util::Budget& budget, const SolveOptions& options) {
  if (!options.techniques.work_reordering) game.manager->set_steps_per_reordering(0);
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
