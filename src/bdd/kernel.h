#pragma once

#include <heed/bdd/bdd.h>

#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "cache.h"
#include "handles.h"
#include "node.h"

namespace heed::bdd {

/// Thrown inside an operation when the diagrams outgrew the order; Kernel::run reorders and starts the
/// operation anew.
struct Restart {};

/// The nodes of one manager with their tables, cache and order. The operations (operations.h) are functions
/// over it.
///
/// Collection marks from the handles and from a stack of intermediate results, so that inner nodes need no
/// counters. It runs only inside make(): an operation pushes what it still needs before it calls anything
/// that may make nodes, and pops it afterwards; its own operands are held by whoever called it.
class Kernel {
 public:
  Kernel(Manager* owner, const ManagerOptions& options, util::Budget* budget);
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;

  [[nodiscard]] const Node& node(Edge edge) const { return nodes_.get()[edge >> 1]; }
  [[nodiscard]] std::uint32_t variable(Edge edge) const { return node(edge).variable; }
  [[nodiscard]] std::uint32_t level(Edge edge) const { return level_of_[variable(edge)]; }
  [[nodiscard]] std::uint32_t level_of(std::uint32_t variable) const { return level_of_[variable]; }
  [[nodiscard]] Edge low(Edge edge) const { return node(edge).low ^ (edge & 1U); }
  [[nodiscard]] Edge high(Edge edge) const { return node(edge).high ^ (edge & 1U); }
  [[nodiscard]] std::uint32_t next_of(std::uint32_t variable) const { return next_of_[variable]; }
  [[nodiscard]] std::uint32_t current_of(std::uint32_t variable) const { return current_of_[variable]; }

  /// The edge of `variable ? high : low`. May collect; \p low and \p high are protected. \pre both stand
  /// below it
  Edge make(std::uint32_t variable, Edge low, Edge high) {
    if (low == high) return low;
    const Edge flip = high & 1U;
    const std::uint64_t key = children(low ^ flip, high ^ flip);
    UniqueTable& table = tables_[variable];
    std::uint32_t& bucket = table.bucket(key);
    for (std::uint32_t i = bucket; i != 0; i = nodes_.get()[i].next) {
      if (children(nodes_.get()[i]) == key) return (i << 1) | flip;
    }
    if ((free_ == 0 && used_ == capacity_) || table.count == table.limit) [[unlikely]]
      return make_room(variable, low, high);
    const std::uint32_t index = take_slot();
    nodes_.get()[index] = {low ^ flip, high ^ flip, bucket, variable};
    bucket = index;
    ++table.count;
    return (index << 1) | flip;
  }

  void push(Edge edge) {
    assert(stack_top_ < stack_.size());
    stack_[stack_top_++] = edge;
  }
  void pop(std::size_t count = 1) { stack_top_ -= count; }

  /// To be called once per recursion step that the cache could not answer, before anything is pushed.
  void step() {
    if (--fuel_ == 0) [[unlikely]]
      refuel();
  }

  /// Runs \p operation, which returns an edge, as one operation of the manager.
  template <typename Operation>
  Bdd run(Operation&& operation) {
    Edge result = true_edge;
    run_many([&] { result = operation(); });
    return Bdd(this, result);
  }
  /// Runs \p operation, which keeps what it finds by itself, as one operation of the manager.
  template <typename Operation>
  void run_many(Operation&& operation) {
    prepare();
    for (;;) {
      try {
        return operation();
      } catch (const Restart&) {
        stack_top_ = 0;
        reorder_after_restart();
      } catch (...) {
        stack_top_ = 0;
        throw;
      }
    }
  }

  std::uint32_t add_variables(std::size_t count, bool paired);
  void collect();
  void reorder_automatically();
  /// Nodes in the tables, garbage included.
  [[nodiscard]] std::size_t live() const { return used_ - 1 - free_count_; }
  [[nodiscard]] std::size_t memory_bytes() const;
  [[nodiscard]] bool consistent() const;
  [[nodiscard]] std::size_t variable_count() const { return at_level_.size(); }
  /// A number that no earlier substitution had, for the cache.
  std::uint32_t new_substitution();
  [[nodiscard]] Statistics statistics() const;

  ComputedCache cache;
  Handles handles;
  Manager* const owner;
  ManagerOptions options;
  SiftOptions sift_options;
  util::Budget* budget;

 private:
  friend class Reorderer;
  friend class Walk;
  struct Release {
    void operator()(Node* nodes) const { std::free(nodes); }
  };

  std::uint32_t take_slot() {
    assert(free_ != 0 || used_ < capacity_);
    if (free_ == 0) return used_++;
    const std::uint32_t index = free_;
    free_ = nodes_.get()[index].next;
    --free_count_;
    return index;
  }
  Edge make_room(std::uint32_t variable, Edge low, Edge high);
  void find_slots();
  void refuel();
  void prepare();
  void reorder_after_restart();
  void reorder_for_work();
  [[nodiscard]] std::uint64_t work_bound() const;
  void sift_now();
  void grow_nodes(std::size_t at_least);
  /// Past the bounds of options and budget, where an operation cannot stop.
  void grow_without_asking(std::size_t size);
  void resize_nodes(std::size_t size);
  void grow_table(UniqueTable& table);
  void reserve(std::size_t bytes);
  void mark(Edge edge);
  void mark_roots();
  void rebuild_tables();
  [[nodiscard]] bool marked(std::uint32_t index) const {
    return ((marks_[index >> 6] >> (index & 63U)) & 1U) != 0;
  }
  [[nodiscard]] bool consistent_node(std::uint32_t index) const;

  std::unique_ptr<Node, Release> nodes_;
  std::uint32_t free_ = 0;
  std::uint32_t free_count_ = 0;
  std::uint32_t used_ = 0;
  std::uint32_t capacity_ = 0;
  std::uint32_t fuel_;
  std::vector<UniqueTable> tables_;
  std::vector<std::uint32_t> level_of_;  ///< By variable; the terminal's is greater than any.
  std::vector<std::uint32_t> at_level_;  ///< Variable at each level.
  std::vector<std::uint32_t> next_of_;   ///< By variable: its next one if it is a current one, else itself.
  std::vector<std::uint32_t> current_of_;
  std::vector<std::uint32_t> group_of_;  ///< By variable: the first variable of its group.
  std::vector<Edge> stack_;
  std::size_t stack_top_ = 0;
  std::vector<std::uint64_t> marks_;
  std::size_t reorder_threshold_;      ///< Live nodes that set off the next automatic reordering.
  std::size_t reorder_check_;          ///< Nodes at which to find out how many of them live.
  std::uint64_t work_start_ = 0;       ///< Steps at the last sifting.
  std::uint64_t work_check_ = 0;       ///< Steps at which to find out whether the work calls for a sifting.
  std::uint64_t patience_ = 1;         ///< Doubles with every sifting for work that gained little.
  std::uint64_t steps_at_growth_ = 0;  ///< Of the computed cache.
  std::uint32_t substitutions_ = 0;
  Statistics counts_;
};

}  // namespace heed::bdd
