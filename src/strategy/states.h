#pragma once

#include <heed/bdd/cofactor_table.h>
#include <heed/util/word_table.h>

#include <array>
#include <cstdint>

namespace heed::strategy {

/// A state of the machine to be: what the future can depend on. Plays with equal futures are one state from
/// the start.
struct StateKey {
  bdd::CofactorTable::Id legal = 0;   ///< The inputs that may come, and
  bdd::CofactorTable::Id future = 0;  ///< the rule of the goal, both after the step just made.
  std::uint32_t goal = 0;
  /// The last observation, where an illegal one may follow and be answered by it; else 0. Counted from 1.
  std::uint64_t observation = 0;
};

/// Numbers states in the order of their discovery.
class States {
 public:
  static constexpr std::uint32_t none = util::WordTable::none;

  /// The number of \p key, and whether it is new.
  std::pair<std::uint32_t, bool> number(const StateKey& key) { return words_.number(word_of(key)); }
  /// Its number, or none.
  [[nodiscard]] std::uint32_t find(const StateKey& key) const { return words_.find(word_of(key)); }
  [[nodiscard]] StateKey operator[](std::uint32_t state) const {
    const auto word = words_[state];
    return {word[0], word[1], word[2], std::uint64_t{word[3]} << 32 | word[4]};
  }
  [[nodiscard]] std::size_t size() const { return words_.size(); }
  [[nodiscard]] std::size_t bytes_to_grow(std::size_t more) const { return words_.bytes_to_grow(more); }

 private:
  static std::array<std::uint32_t, 5> word_of(const StateKey& key) {
    return {key.legal, key.future, key.goal, static_cast<std::uint32_t>(key.observation >> 32),
            static_cast<std::uint32_t>(key.observation)};
  }
  util::WordTable words_{5};
};

}  // namespace heed::strategy
