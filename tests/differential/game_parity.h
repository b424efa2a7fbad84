#pragma once

#include <cstdint>
#include <vector>

namespace heed::reference {

/// A parity game on a finite graph: player 0 (the system) wins when the greatest colour seen for ever is
/// even. Every position has a successor.
struct ParityGame {
  struct Position {
    bool system = false;
    int colour = 0;
    std::vector<std::uint32_t> successors{};
  };
  std::vector<Position> positions;
};

/// Positions from which the system wins, by Zielonka's recursive algorithm.
[[nodiscard]] std::vector<bool> winning(const ParityGame& game);

}  // namespace heed::reference
