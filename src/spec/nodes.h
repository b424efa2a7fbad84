#pragma once

#include <heed/logic/formula.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace heed::spec {

/// A formula's distinct nodes, operands first, with operands as indices: what the passes of this room run
/// over.
class Nodes {
 public:
  explicit Nodes(const logic::Formula& root) : order_(logic::postorder(root)) {
    std::unordered_map<const void*, std::uint32_t> index;
    for (const logic::Formula& node : order_) {
      std::vector<std::uint32_t> operands;
      for (const logic::Formula& operand : node.operands()) operands.push_back(index.at(operand.identity()));
      index.emplace(node.identity(), static_cast<std::uint32_t>(operands_.size()));
      operands_.push_back(std::move(operands));
    }
  }
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] const logic::Formula& operator[](std::size_t i) const { return order_[i]; }
  [[nodiscard]] const std::vector<std::uint32_t>& operands(std::size_t i) const { return operands_[i]; }

 private:
  std::vector<logic::Formula> order_;
  std::vector<std::vector<std::uint32_t>> operands_;
};

[[nodiscard]] inline bool is_comparison(logic::Op op) {
  return op >= logic::Op::Eq && op <= logic::Op::Ge;
}

/// Always, Eventually, ... and the past: what a clause of GR(1) cannot hold.
[[nodiscard]] inline bool is_temporal_beyond_next(logic::Op op) {
  return op > logic::Op::Next;
}

}  // namespace heed::spec
