#pragma once

#include <heed/logic/formula.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace heed::logic {

/// The distinct nodes of a formula (by identity), operands before what uses them and the root last, with
/// operands as places in this order: what a pass keeps of each node then lies in a vector.
class Nodes {
 public:
  /// O(nodes).
  explicit Nodes(const Formula& root);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Formula& operator[](std::size_t i) const { return nodes_[i]; }
  /// The places of the operands of node \p i, each below \p i.
  [[nodiscard]] std::span<const std::uint32_t> operands(std::size_t i) const {
    return {operands_.data() + (i == 0 ? 0 : end_[i - 1]), operands_.data() + end_[i]};
  }
  [[nodiscard]] const std::vector<Formula>& formulas() const& { return nodes_; }
  [[nodiscard]] std::vector<Formula> formulas() && { return std::move(nodes_); }

 private:
  std::vector<Formula> nodes_;
  std::vector<std::uint32_t> operands_, end_;
};

}  // namespace heed::logic
