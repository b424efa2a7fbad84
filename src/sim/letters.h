#pragma once

#include <heed/sim/run.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <map>
#include <optional>

namespace heed::sim {

/// The observation that the machine gets when \p seen is reported.
[[nodiscard]] inline model::Valuation observation(const Binding& binding, std::uint64_t seen) {
  model::Valuation result = binding.blank;
  for (const Binding::Wire& wire : binding.wires)
    if (seen >> wire.feature & 1) result[wire.input] = wire.value;
  return result;
}

/// The machine's letter for what is reported, looked up once.
class LetterCache {
 public:
  explicit LetterCache(const Run& run) : run_(run) {}

  /// Nothing where the machine does not know it.
  std::optional<std::uint32_t> letter(std::uint64_t seen) {
    const auto [found, added] = letters_.try_emplace(seen);
    if (added) found->second = run_.machine.input_letter(observation(run_.binding, seen));
    return found->second;
  }

 private:
  const Run& run_;
  std::map<std::uint64_t, std::optional<std::uint32_t>> letters_;
};

inline void assert_fits([[maybe_unused]] const Run& run) {
  assert(run.judge.event.size() == run.machine.transitions.size());
  assert(run.judge.never < run.judge.categories.size());
  assert(run.binding.blank.size() == run.machine.inputs.size());
  assert(std::all_of(run.binding.wires.begin(), run.binding.wires.end(), [&](const Binding::Wire& wire) {
    return wire.feature < run.chain.features.size() && wire.input < run.machine.inputs.size();
  }));
}

}  // namespace heed::sim
