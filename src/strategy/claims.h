#pragma once

#include "diagrams.h"

#include <heed/game/solve.h>
#include <heed/model/symbolic.h>
#include <heed/util/limits.h>

#include <vector>

namespace heed::strategy {

/// The ranks of one goal as levels, waiting states by the assumption that they wait for.
[[nodiscard]] std::vector<model::Level> levels_of(const game::Region& region, std::size_t goal,
                                                  DiagramWriter& writer);

/// What a solved game comes to, with its proof: ranks where the system wins, and where it loses, round by
/// round, how the environment meets each assumption again while the goal stays unmet.
/// \pre region.realizable and its ranks were kept, or not and its iterates were
[[nodiscard]] model::Claim make_claim(const game::Game& game, const game::Region& region,
                                      util::Budget& budget);

}  // namespace heed::strategy
