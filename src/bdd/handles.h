#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "node.h"

namespace heed::bdd {

/// The roots of collection: one slot per handle made, shared by its copies and their complements.
class Handles {
 public:
  std::uint32_t open(Edge edge) {
    ++open_;
    if (free_ == none) {
      slots_.push_back({edge, 1});
      return static_cast<std::uint32_t>(slots_.size() - 1);
    }
    const std::uint32_t slot = free_;
    free_ = slots_[slot].edge;
    slots_[slot] = {edge, 1};
    return slot;
  }
  void share(std::uint32_t slot) { ++slots_[slot].count; }
  void close(std::uint32_t slot) {
    if (--slots_[slot].count != 0) return;
    slots_[slot].edge = free_;
    free_ = slot;
    --open_;
  }
  [[nodiscard]] std::size_t open_slots() const { return open_; }

  /// Edges that are roots without a handle each: \p words of \p length many, whose first letter is none.
  struct Vectors {
    const std::vector<Edge>* words;
    std::size_t length;
  };
  void attach(const Vectors& vectors) { attached_.push_back(vectors); }
  void detach(const std::vector<Edge>* words) {
    std::erase_if(attached_, [&](const Vectors& vectors) { return vectors.words == words; });
  }

  template <typename Visitor>
  void for_each(Visitor&& visit) const {
    for (const Slot& slot : slots_) {
      if (slot.count != 0) visit(slot.edge);
    }
    for (const auto& [words, length] : attached_)
      for (std::size_t word = 0; word < words->size(); word += length)
        for (std::size_t i = 1; i < length; ++i) visit((*words)[word + i]);
  }

 private:
  struct Slot {
    Edge edge;  ///< The next free slot where count is 0.
    std::uint32_t count;
  };
  static constexpr std::uint32_t none = UINT32_MAX;
  std::vector<Slot> slots_;
  std::vector<Vectors> attached_;
  std::uint32_t free_ = none;
  std::size_t open_ = 0;
};

}  // namespace heed::bdd
