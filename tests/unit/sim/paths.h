#pragma once

#include <heed/sim/profile.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace heed::sim {

/// What is reported in each cell, and how likely that sequence is.
using SequenceLaw = std::map<std::vector<std::uint64_t>, Rational>;

/// All paths of a chain.
inline SequenceLaw sequences(const Chain& chain) {
  std::map<std::pair<std::vector<std::uint64_t>, std::uint32_t>, Rational> layer{{{{}, 0}, 1}};
  for (std::uint32_t cell = 0; cell < chain.cells; ++cell) {
    auto before = std::exchange(layer, {});
    for (const auto& [standing, probability] : before) {
      for (std::uint32_t i = chain.first[standing.second]; i < chain.first[standing.second + 1]; ++i) {
        auto sequence = standing.first;
        sequence.push_back(chain.steps[i].seen);
        layer[{std::move(sequence), chain.steps[i].next}] += probability * chain.steps[i].probability;
      }
    }
  }
  SequenceLaw result;
  for (const auto& [standing, probability] : layer) result[standing.first] += probability;
  return result;
}

}  // namespace heed::sim
