#pragma once

#include <heed/bdd/bdd.h>

#include <array>
#include <cstdint>
#include <unordered_map>
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

  explicit Cofactors(std::vector<bdd::Var> order) : order_(std::move(order)), index_(order_.size() + 1) {}

  /// The number of \p functions before any variable has its value.
  Id root(std::vector<bdd::Bdd> functions) { return intern(0, std::move(functions)); }
  /// What is left when the next variable gets \p value. \pre depth of \p id < number of variables
  Id step(Id id, bool value);
  [[nodiscard]] const std::vector<bdd::Bdd>& functions(Id id) const { return nodes_[id].functions; }
  [[nodiscard]] std::size_t depth() const { return order_.size(); }

 private:
  struct Node {
    std::vector<bdd::Bdd> functions;
    std::uint32_t depth;
    std::array<Id, 2> next{none, none};
    Id same_hash = none;  ///< Another one of this depth with the same hash.
  };
  Id intern(std::uint32_t depth, std::vector<bdd::Bdd> functions);

  std::vector<bdd::Var> order_;
  std::vector<Node> nodes_;
  std::vector<std::unordered_map<std::uint64_t, Id>> index_;  ///< By depth, then by hash: the last one added.
};

}  // namespace heed::strategy
