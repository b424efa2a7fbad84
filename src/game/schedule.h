#pragma once

#include <heed/game/solve.h>

#include <vector>

namespace heed::game {

/// exists cube . target & parts  as stages to be gone through in order, starting from the target; never
/// empty. A variable is quantified at the last stage that mentions it, or at the first.
[[nodiscard]] std::vector<Stage> schedule(std::vector<bdd::Bdd> parts, const bdd::Bdd& cube,
                                          const Techniques& techniques);

/// Quantifies variables of \p cube that no target mentions out of \p parts, those that stand in one part
/// only. \returns \p parts without those that became true
[[nodiscard]] std::vector<bdd::Bdd> without_unread(std::vector<bdd::Bdd> parts, const bdd::Bdd& cube);

}  // namespace heed::game
