#pragma once

#include <heed/game/game.h>

namespace heed::game {

/// The same game for a solver. Where a state keeps what `invariant` says, it is won in one if and only if it
/// is won in the other, and with the same ranks; plays never leave it.
struct Simplified {
  /// `valid` is the invariant without the variables that were put in; nothing says again what it says.
  Game game;
  /// What holds at the start and is kept by every step of the system, over X, Y, M.
  bdd::Bdd invariant;
};

[[nodiscard]] Simplified simplify(const Game& game, const Techniques& techniques);

}  // namespace heed::game
