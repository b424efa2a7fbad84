#pragma once

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "node.h"

namespace heed::bdd {

/// Numbers keys (edges or node indices) densely in the order they are first seen. Its cost follows what is
/// visited, not the size of the manager; nothing is ever read in the order of its hash table.
class Numbering {
 public:
  static constexpr std::uint32_t absent = UINT32_MAX;

  /// \returns the key's number, and whether it is new
  std::pair<std::uint32_t, bool> insert(std::uint32_t key) {
    if (keys_.size() * 2 >= table_.size()) grow();
    std::uint32_t& place = table_[position(key)];
    if (place != absent) return {place, false};
    place = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return {place, true};
  }
  [[nodiscard]] std::uint32_t find(std::uint32_t key) const { return table_[position(key)]; }
  [[nodiscard]] const std::vector<std::uint32_t>& keys() const { return keys_; }

 private:
  [[nodiscard]] std::size_t position(std::uint32_t key) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = scatter(key) >> (64 - std::countr_zero(table_.size()));
    while (table_[at] != absent && keys_[table_[at]] != key) at = (at + 1) & mask;
    return at;
  }
  void grow() {
    table_.assign(table_.size() * 2, absent);
    for (std::uint32_t i = 0; i < keys_.size(); ++i) table_[position(keys_[i])] = i;
  }

  std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(32, absent);
  std::vector<std::uint32_t> keys_;
};

}  // namespace heed::bdd
