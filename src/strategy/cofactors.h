#pragma once

#include <heed/bdd/bdd.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace heed::strategy {

/// Vectors of functions and what is left of them as variables get their values, one after the other in a
/// fixed order. A vector is a number: equal vectors at the same depth are equal numbers, and each step is
/// computed once, so that thousands of assignments with common beginnings, or with equal rests, share their
/// work.
class Cofactors {
 public:
  using Id = std::uint32_t;
  static constexpr Id none = static_cast<Id>(-1);

  /// \param width  How many functions a vector has.
  Cofactors(bdd::Manager& manager, const std::vector<bdd::Var>& order, std::size_t width);

  /// The number of \p functions before any variable has its value. \pre width many
  Id root(std::span<const bdd::Bdd> functions) { return intern(0, functions); }
  /// What is left when the next variable gets \p value. \pre depth of \p id < number of variables
  Id step(Id id, bool value) {
    const Id known = nodes_[id].next[value ? 1 : 0];
    return known != none ? known : make_step(id, value);
  }
  [[nodiscard]] std::span<const bdd::Bdd> functions(Id id) const {
    return {&chunks_[id / chunk_vectors][id % chunk_vectors * width_], width_};
  }

 private:
  struct Node {
    std::array<Id, 2> next{none, none};
    std::uint32_t depth = 0;
  };
  /// Handles stay where they are: moving a million of them costs more than finding them.
  static constexpr std::size_t chunk_vectors = 256;

  Id make_step(Id id, bool value);
  Id intern(std::uint32_t depth, std::span<const bdd::Bdd> functions);
  [[nodiscard]] std::uint64_t hash_of(std::uint32_t depth, std::span<const bdd::Bdd> functions) const;
  void grow();

  std::vector<std::array<bdd::Bdd, 2>> literals_;  ///< By depth and value.
  std::size_t width_;
  std::vector<Node> nodes_;
  std::vector<std::unique_ptr<bdd::Bdd[]>> chunks_;
  std::vector<Id> table_;  ///< Open addressing, a power of two, at most half full.
  std::vector<bdd::Bdd> rest_;
};

}  // namespace heed::strategy
