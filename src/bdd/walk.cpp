#include "walk.h"

namespace heed::bdd {

// The first constructor has ended before a node is lent, so that the destructor restores the links whatever
// follows.
Walk::Walk(Kernel& kernel, std::span<const Edge> roots) : Walk(kernel) {
  for (const Edge root : roots) add(root);
}

Walk::~Walk() {
  for (const Visit& visit : visited_) nodes_[visit.index].next = visit.link;
}

/// Depth is bounded by the number of variables.
void Walk::visit(std::uint32_t index) {
  Node& node = nodes_[index];
  if ((node.next & lent) != 0) return;
  if (index != 0) {
    visit(node.low >> 1);
    visit(node.high >> 1);
  }
  visited_.push_back({index, node.next});
  node.next = lent | static_cast<std::uint32_t>(visited_.size() - 1);
}

}  // namespace heed::bdd
