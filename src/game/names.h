#pragma once

#include <heed/game/explain.h>
#include <heed/game/game.h>

#include <string>
#include <vector>

namespace heed::game {

/// As the user wrote it, or printed where nobody wrote it.
[[nodiscard]] std::string clause_text(const spec::Clause& clause);
/// The same, said to hold infinitely often.
[[nodiscard]] std::string goal_text(const spec::Clause& clause);
/// The values of \p owner's variables in \p assignment, indexed by diagram variable; current ones.
[[nodiscard]] Values values_of(const Game& game, Owner owner, const std::vector<bool>& assignment);
/// "a = true, n = 3": the same as one text.
[[nodiscard]] std::string values_text(const Game& game, Owner owner, const std::vector<bool>& assignment);

}  // namespace heed::game
