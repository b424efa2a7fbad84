#pragma once

#include "cofactors.h"

#include <heed/util/hash.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace heed::strategy {

/// A state of the machine to be: what the future can depend on. Plays with equal futures are one state from
/// the start.
struct StateKey {
  Cofactors::Id future = 0;  ///< The rule of the goal, put into the step just made.
  std::uint32_t goal = 0;
  /// The last observation, where an illegal one may follow and be answered by it; else 0. Counted from 1.
  std::uint64_t observation = 0;
  bool operator==(const StateKey&) const = default;
};

/// Numbers states in the order of their discovery.
class States {
 public:
  /// The number of \p key, and whether it is new.
  std::pair<std::uint32_t, bool> number(const StateKey& key) {
    const auto [found, added] = numbers_.emplace(key, static_cast<std::uint32_t>(keys_.size()));
    if (added) keys_.push_back(key);
    return {found->second, added};
  }
  /// Its number, if it has one.
  [[nodiscard]] std::optional<std::uint32_t> find(const StateKey& key) const {
    const auto found = numbers_.find(key);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }
  [[nodiscard]] const StateKey& operator[](std::size_t i) const { return keys_[i]; }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

 private:
  struct Hash {
    std::size_t operator()(const StateKey& key) const {
      return util::mix(util::mix(key.future, key.goal), key.observation);
    }
  };
  std::unordered_map<StateKey, std::uint32_t, Hash> numbers_;
  std::vector<StateKey> keys_;
};

}  // namespace heed::strategy
