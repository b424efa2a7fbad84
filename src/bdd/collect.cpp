#include <algorithm>

#include "kernel.h"

/// Mark-and-sweep collection. Marks stand in a bitmap of their own: at one bit per node it stays in the
/// processor's cache while the marking jumps about, and the computed cache is swept against it without
/// touching a node.
namespace heed::bdd {

/// Depth is bounded by the number of variables.
void Kernel::mark(Edge edge) {
  std::uint32_t index = edge >> 1;
  while (!marked(index)) {
    marks_[index >> 6] |= std::uint64_t{1} << (index & 63U);
    mark(nodes_.get()[index].high);
    index = nodes_.get()[index].low >> 1;
  }
}

void Kernel::mark_roots() {
  marks_.assign((used_ >> 6) + 1, 0);
  marks_[0] = 1;
  handles.for_each([this](Edge edge) { mark(edge); });
  for (std::size_t i = 0; i < stack_top_; ++i) mark(stack_[i]);
}

/// One pass in the order of memory; a table that lost most of its nodes shrinks.
void Kernel::rebuild_tables() {
  std::vector<std::uint32_t> counts(tables_.size(), 0);
  for (std::uint32_t i = 1; i < used_; ++i) {
    if (marked(i)) ++counts[nodes_.get()[i].variable];
  }
  for (std::size_t v = 1; v < tables_.size(); ++v) {
    UniqueTable& table = tables_[v];
    const bool keep = table.buckets.size() / 8 <= counts[v] && counts[v] <= table.limit;
    table.reset(keep ? static_cast<std::uint32_t>(table.buckets.size()) : counts[v]);
    table.count = counts[v];
  }
  free_ = 0;
  free_count_ = 0;
  while (used_ > 1 && !marked(used_ - 1)) --used_;
  for (std::uint32_t i = used_; i-- > 1;) {
    Node& node = nodes_.get()[i];
    std::uint32_t& chain = marked(i) ? tables_[node.variable].bucket(children(node)) : free_;
    if (!marked(i)) {
      node.variable = free_variable;
      ++free_count_;
    }
    node.next = chain;
    chain = i;
  }
}

void Kernel::collect() {
  mark_roots();
  cache.sweep(marks_);
  rebuild_tables();
  ++counts_.collections;
}

bool Kernel::consistent_node(std::uint32_t index) const {
  const Node& here = nodes_.get()[index];
  const std::uint32_t place = level_of_[here.variable];
  if (here.low == here.high || (here.high & 1U) != 0) return false;
  if (level(here.low) <= place || level(here.high) <= place) return false;
  std::size_t found = 0;
  for (std::uint32_t i = tables_[here.variable].bucket(children(here)); i != 0; i = nodes_.get()[i].next)
    found += children(nodes_.get()[i]) == children(here) ? 1U : 0U;
  return found == 1;
}

bool Kernel::consistent() const {
  for (std::uint32_t v = 1; v < level_of_.size(); ++v) {
    if (level_of_[v] >= at_level_.size() || at_level_[level_of_[v]] != v) return false;
    if (v > group_of_[v] && level_of_[v] != level_of_[v - 1] + 1) return false;
  }
  std::vector<std::uint32_t> counts(tables_.size(), 0);
  for (std::uint32_t i = 1; i < used_; ++i) {
    const std::uint32_t v = nodes_.get()[i].variable;
    if (v == free_variable) continue;
    if (v == 0 || v >= tables_.size() || !consistent_node(i)) return false;
    ++counts[v];
  }
  for (std::size_t v = 1; v < tables_.size(); ++v) {
    if (tables_[v].count != counts[v]) return false;
  }
  return true;
}

}  // namespace heed::bdd
