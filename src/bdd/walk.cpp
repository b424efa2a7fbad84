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

/// Depth is bounded by the number of variables. The terminal is there from the start.
void Walk::visit(std::uint32_t index) {
  Node& node = nodes_[index];
  add(node.low);
  add(node.high);
  number_next(index);
}

}  // namespace heed::bdd
