#pragma once

#include <span>
#include <vector>

#include "kernel.h"

namespace heed::bdd {

/// The nodes below some roots, numbered from 0 with children before parents and the terminal first.
///
/// While it lives, the links of these nodes hold their numbers instead of the chains of the unique tables, so
/// that a node is visited without a search; nothing may make nodes or look for them meanwhile. Linear in the
/// nodes visited, whatever else the manager holds.
class Walk {
 public:
  explicit Walk(Kernel& kernel) : nodes_(kernel.nodes_.get()) {
    visited_.reserve(usual);
    number_next(0);
  }
  Walk(Kernel& kernel, std::span<const Edge> roots);
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;
  ~Walk();

  /// In the order of a depth-first search, low children first.
  void add(Edge root) {
    if ((nodes_[root >> 1].next & lent) == 0) visit(root >> 1);
  }
  [[nodiscard]] std::size_t size() const { return visited_.size(); }
  [[nodiscard]] const Node& node(std::size_t number) const { return nodes_[visited_[number].index]; }
  /// \pre the edge is to a node that was visited
  [[nodiscard]] std::uint32_t number(Edge edge) const { return nodes_[edge >> 1].next ^ lent; }
  /// 2 * number + complement bit.
  [[nodiscard]] std::uint32_t reference(Edge edge) const { return (number(edge) << 1) | (edge & 1U); }

 private:
  struct Visit {
    std::uint32_t index;
    std::uint32_t link;
  };
  /// Set in a link that holds a number; indices stay far below it.
  static constexpr std::uint32_t lent = std::uint32_t{1} << 31;
  static_assert(node_limit <= lent);
  static constexpr std::size_t usual = 64;  ///< Most diagrams are small.

  /// \pre not yet visited
  void visit(std::uint32_t index);
  void number_next(std::uint32_t index) {
    visited_.push_back({index, nodes_[index].next});
    nodes_[index].next = lent | static_cast<std::uint32_t>(visited_.size() - 1);
  }

  Node* nodes_;
  std::vector<Visit> visited_;
};

}  // namespace heed::bdd
