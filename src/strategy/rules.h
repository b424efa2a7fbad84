#pragma once

#include <heed/bdd/bdd.h>
#include <heed/game/solve.h>
#include <heed/util/limits.h>

#include <vector>

namespace heed::strategy {

/// What the system may do while it works towards one goal; every choice that it leaves is winning.
struct Rule {
  /// Mealy: the allowed steps (X, Y, M, X', Y', M'). Moore: the allowed answers (X, Y, M, Y').
  bdd::Bdd moves;
  /// Steps that only wait for an assumption to fail. Mealy: over (X, Y, M, X', M'), since all answers that
  /// moves leaves there wait, or none does.
  bdd::Bdd waits;
};

/// One rule per goal from the ranks of a solved game: the best of meeting the goal, getting a rank nearer,
/// waiting while an assumption fails, that the environment leaves open. \pre region.ranks are those of \p
/// game
[[nodiscard]] std::vector<Rule> make_rules(const game::Game& game, const game::Region& region,
                                           util::Budget& budget);

/// Makes of Game::env_safety few conjuncts, each of at most \p most_nodes nodes or one that was there; none
/// where all steps are legal.
void gather_assumptions(game::Game& game, std::size_t most_nodes);

/// Game::env_safety with the memories' next values put in: the legal next inputs. Over X, Y, M, X'.
[[nodiscard]] std::vector<bdd::Bdd> legal_inputs(const game::Game& game);

}  // namespace heed::strategy
