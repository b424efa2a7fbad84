#pragma once

#include <heed/game/game.h>

#include <cstdint>
#include <string>
#include <vector>

namespace heed::game {

/// Texts of a small set of the system's clauses that alone make \p game unrealizable, by deletion. None can
/// be left out, unless \p steps (controllable predecessors) ran out before. \pre \p game is unrealizable
[[nodiscard]] std::vector<std::string> unrealizable_core(const Game& game, util::Budget& budget,
                                                         std::uint64_t steps);

}  // namespace heed::game
