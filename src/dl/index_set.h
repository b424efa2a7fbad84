#pragma once

#include <heed/util/hash.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace heed::dl {

/// Finds the place of a key in a list that its owner keeps; small lists are scanned, larger ones hashed (open
/// addressing). \tparam KeyOf  From a place to the key there.
class IndexSet {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  template <class KeyOf>
  [[nodiscard]] std::uint32_t find(std::uint64_t key, std::size_t size, KeyOf key_of) const {
    if (slots_.empty()) {
      for (std::uint32_t i = 0; i < size; ++i)
        if (key_of(i) == key) return i;
      return none;
    }
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = util::mix(key, 0) & mask;; slot = (slot + 1) & mask) {
      const std::uint32_t place = slots_[slot];
      if (place == none || key_of(place) == key) return place;
    }
  }

  /// The list has grown to \p size; its last key is new.
  template <class KeyOf>
  void added(std::size_t size, KeyOf key_of) {
    if (size <= small) return;
    if (size * 2 > slots_.size()) {
      slots_.assign(size <= 2 * small ? 8 * small : slots_.size() * 2, none);
      for (std::uint32_t i = 0; i < size; ++i) put(key_of(i), i);
    } else {
      put(key_of(static_cast<std::uint32_t>(size - 1)), static_cast<std::uint32_t>(size - 1));
    }
  }

 private:
  static constexpr std::size_t small = 8;
  void put(std::uint64_t key, std::uint32_t place) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = util::mix(key, 0) & mask;
    while (slots_[slot] != none) slot = (slot + 1) & mask;
    slots_[slot] = place;
  }
  std::vector<std::uint32_t> slots_;
};

}  // namespace heed::dl
