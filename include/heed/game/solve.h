#pragma once

#include <heed/game/game.h>
#include <heed/game/techniques.h>

#include <cstdint>
#include <vector>

namespace heed::game {

struct SolveOptions {
  bool ranks = false;           ///< Keep what a strategy follows.
  bool iterates = false;        ///< Keep how the region shrank, for explaining a defeat.
  bool stop_early = false;      ///< Stop as soon as some initial state is known to be lost.
  std::uint64_t max_steps = 0;  ///< Controllable predecessors to compute; 0: no bound.
  Techniques techniques{};
};

/// One round of the outermost fixpoint: what was lost when goal `goal` was looked at; Part::no_clause: by
/// safety alone.
struct Iterate {
  bdd::Bdd region;  ///< After the round.
  std::size_t goal = 0;
};

/// States from which the system wins, and the ranks that a strategy follows.
struct Region {
  bool realizable = false;
  bool complete = true;  ///< False: `max_steps` was reached and nothing is known.
  bdd::Bdd winning;      ///< Over current variables. Stopped early: a superset of the winning states.
  /// What holds at the start and whatever the system rightly answers; all other sets are parts of it.
  bdd::Bdd invariant;
  /// ranks[j][k]: the system can force goal j, or a broken assumption, in at most k + 1 rounds.
  std::vector<std::vector<bdd::Bdd>> ranks;
  /// waits[j][k][i]: part of ranks[j][k]; from here it may wait while assumption i fails. Empty for ranks
  /// that progress alone gives.
  std::vector<std::vector<std::vector<bdd::Bdd>>> waits;
  std::vector<Iterate> iterates;  ///< In order; each region is smaller than the one before.
  std::uint64_t outer_iterations = 0;
  std::uint64_t steps = 0;  ///< Controllable predecessors computed.
};

/// Solves the game (docs/semantics.md): generalised Streett(1) by a triple fixpoint,
///
///     nu Z . AND_j  mu Y . OR_i  nu X .
///         (J_sys[j] & cpre(Z))  |  cpre(Y)  |  (!J_env[i] & cpre(X))
///
/// where a justice over a step is evaluated inside the predecessor.
/// \returns An unrealizable game is a result, not an error.
/// \throws util::LimitExceeded  the game and its manager stay usable. \cite bloem.12.jcss
[[nodiscard]] Region solve(const Game& game, util::Budget& budget, const SolveOptions& options = {});

/// Whether the start is won when \p winning is: by the specification's InitialQuantifiers.
[[nodiscard]] bool wins_initially(const Game& game, const bdd::Bdd& winning);

/// One step of a relational product: conjoin `relation`, then quantify `cube`, which no later stage mentions.
struct Stage {
  bdd::Bdd relation;
  bdd::Bdd cube;
};

/// Controllable predecessors with the relation partitioned and each variable quantified as early as possible:
///
///     Mealy:  cpre(T) = forall X' . exists M' . M' = update & (rho_e -> exists Y' . rho_s & T)
///     Moore:  cpre(T) = exists Y' . forall X' . exists M' . M' = update & (rho_e -> rho_s & T)
class Predecessor {
 public:
  explicit Predecessor(const Game& game, const Techniques& techniques = {});
  /// \param target  A set of states, over current variables.
  [[nodiscard]] bdd::Bdd of_set(const bdd::Bdd& target) const;
  /// \param target  A relation over current and next variables.
  [[nodiscard]] bdd::Bdd of_relation(const bdd::Bdd& target) const;
  /// The pairs (state, next inputs) that some answer takes into \p target, memories still primed. Mealy only.
  [[nodiscard]] bdd::Bdd answers(const bdd::Bdd& target) const;

  /// exists Y' . rho_s & T', as far as rho_s mentions Y'; distributes over unions. Moore: without quantifier.
  [[nodiscard]] bdd::Bdd answered(const bdd::Bdd& target) const;
  /// exists X' M' . rho_e & M' = update & \p steps; distributes over unions.
  [[nodiscard]] bdd::Bdd forced(bdd::Bdd steps) const;
  /// States from which the environment can force a break of rho_s, whatever the answer.
  [[nodiscard]] const bdd::Bdd& doomed() const { return doomed_; }
  /// Predecessors computed.
  [[nodiscard]] std::uint64_t computed() const { return computed_; }
  /// Another one is put together from its pieces.
  void count() const { ++computed_; }

 private:
  [[nodiscard]] bdd::Bdd answered_in(bdd::Bdd target) const;
  [[nodiscard]] bdd::Bdd close(const bdd::Bdd& answered) const;

  const Game& game_;
  bool moore_;
  std::vector<Stage> outputs_;  ///< rho_s where it mentions Y'.
  std::vector<Stage> moves_;    ///< rho_e and M' = update.
  bdd::Bdd rest_;               ///< rho_s where it does not mention Y'.
  bdd::Bdd doomed_;
  mutable std::uint64_t computed_ = 0;
};

}  // namespace heed::game
