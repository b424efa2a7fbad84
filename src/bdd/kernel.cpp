#include "kernel.h"

#include <algorithm>
#include <bit>
#include <new>

#include "reorder.h"

namespace heed::bdd {

namespace {
/// Steps between two looks at the budget: some tens of microseconds.
constexpr std::uint32_t fuel_per_check = 1024;
/// Intermediate results per level that nested recursions can hold.
constexpr std::size_t stack_per_level = 32;
/// Nodes made, by the live ones that call for a reordering, before it is worth finding out how many live: a
/// collection also sweeps the computed cache, and one that came too early was a fifth of some games' time.
constexpr std::size_t garbage_before_check = 4;
/// Live nodes below which work is counted as if there were as many.
constexpr std::uint64_t least_work = 1000;
}  // namespace

Kernel::Kernel(Manager* manager, const ManagerOptions& given, util::Budget* limits)
    : cache(given.initial_cache_bytes, given.max_cache_bytes),
      owner(manager),
      options(given),
      budget(limits),
      fuel_(fuel_per_check),
      reorder_threshold_(given.first_reordering),
      reorder_check_(given.first_reordering) {
  options.max_nodes = std::clamp<std::size_t>(options.max_nodes, 16, node_limit);
  grow_nodes(std::clamp<std::size_t>(options.initial_nodes, 16, options.max_nodes));
  nodes_.get()[0] = {true_edge, true_edge, 0, 0};
  used_ = 1;
  tables_.resize(1);
  level_of_.assign(1, UINT32_MAX);
  next_of_.assign(1, 0);
  current_of_.assign(1, 0);
  group_of_.assign(1, 0);
  stack_.resize(stack_per_level * 8);
  work_check_ = work_bound();
}

std::uint32_t Kernel::add_variables(std::size_t count, bool paired) {
  const auto first = static_cast<std::uint32_t>(level_of_.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto variable = static_cast<std::uint32_t>(level_of_.size());
    level_of_.push_back(static_cast<std::uint32_t>(at_level_.size()));
    at_level_.push_back(variable);
    next_of_.push_back(variable);
    current_of_.push_back(variable);
    group_of_.push_back(first);
    tables_.emplace_back();
  }
  if (paired) {
    next_of_[first] = first + 1;
    current_of_[first + 1] = first;
  }
  stack_.resize(stack_per_level * (level_of_.size() + 8));
  return first;
}

void Kernel::reserve(std::size_t bytes) {
  if (budget != nullptr) budget->reserve(bytes);
}

void Kernel::grow_nodes(std::size_t at_least) {
  const std::size_t size =
      std::min(std::max<std::size_t>(at_least, std::size_t{capacity_} * 2), options.max_nodes);
  if (size < at_least || size <= capacity_)
    throw util::LimitExceeded(
        util::LimitExceeded::Kind::Memory,
        "limit of " + std::to_string(options.max_nodes) + " decision diagram nodes reached");
  reserve((size - capacity_) * sizeof(Node));
  resize_nodes(size);
}

void Kernel::grow_without_asking(std::size_t size) {
  if (size > node_limit)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Memory,
                              "no more decision diagram nodes can be numbered");
  resize_nodes(size);
}

void Kernel::resize_nodes(std::size_t size) {
  // realloc moves large blocks by page tables, so growth neither copies nor needs both at once.
  auto* grown = static_cast<Node*>(std::realloc(static_cast<void*>(nodes_.get()), size * sizeof(Node)));
  if (grown == nullptr)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Memory, "no memory for more nodes");
  static_cast<void>(nodes_.release());
  nodes_.reset(grown);
  capacity_ = static_cast<std::uint32_t>(size);
}

void UniqueTable::reset(std::uint32_t nodes) {
  const std::size_t size = std::bit_ceil(std::max<std::size_t>(nodes, 4));
  if (size == buckets.size()) {
    std::fill(buckets.begin(), buckets.end(), 0);
  } else {
    buckets = std::vector<std::uint32_t>(size, 0);
  }
  shift = 64 - std::countr_zero(size);
  limit = static_cast<std::uint32_t>(size);
  count = 0;
}

void Kernel::grow_table(UniqueTable& table) {
  const std::size_t size = table.buckets.size() * 4;
  reserve(size * sizeof(std::uint32_t));
  std::vector<std::uint32_t> old(size, 0);
  old.swap(table.buckets);
  table.shift -= 2;
  table.limit = static_cast<std::uint32_t>(size);
  for (std::size_t i = 0; i < old.size(); ++i) {
    __builtin_prefetch(&nodes_.get()[old[std::min(i + 12, old.size() - 1)]]);
    std::uint32_t head = old[i];
    while (head != 0) {
      Node& node = nodes_.get()[head];
      const std::uint32_t following = node.next;
      std::uint32_t& bucket = table.bucket(children(node));
      node.next = bucket;
      bucket = head;
      head = following;
    }
  }
}

Edge Kernel::make_room(std::uint32_t variable, Edge low, Edge high) {
  push(low);
  push(high);
  if (free_ == 0 && used_ == capacity_) find_slots();
  if (tables_[variable].count == tables_[variable].limit) grow_table(tables_[variable]);
  pop(2);
  return make(variable, low, high);
}

/// Collect when most of the nodes may be garbage, grow when most of them live, so that both cost a constant
/// per node made.
void Kernel::find_slots() {
  collect();
  const std::size_t alive = live();
  if (options.automatic_reordering && alive > reorder_threshold_) throw Restart{};
  if (alive * 2 <= capacity_) return;
  if (capacity_ < options.max_nodes) return grow_nodes(std::size_t{capacity_} + 1);
  if (free_ == 0) grow_nodes(std::size_t{capacity_} + 1);
}

/// The cache grows once the work since it last did is worth some times the touching of all its entries.
void Kernel::refuel() {
  fuel_ = fuel_per_check;
  counts_.steps += fuel_per_check;
  if (budget != nullptr) budget->check();
  if (counts_.steps - steps_at_growth_ < cache.entries() * 4) return;
  const unsigned growth = cache.growth();
  if (growth == 0 || cache.entries() > used_) return;
  reserve(cache.bytes() << growth);
  cache.grow();
  steps_at_growth_ = counts_.steps;
}

void Kernel::prepare() {
  if (!options.automatic_reordering) return;
  if (live() > reorder_check_) return reorder_automatically();
  if (options.steps_per_reordering != 0 && counts_.steps >= work_check_) reorder_for_work();
}

void Kernel::sift_now() {
  Reorderer(*this).sift(sift_options);
  work_start_ = counts_.steps;
}

/// Sifting visits nodes about as often as there are live ones times a constant, so that it pays where much
/// more work than that was done since.
std::uint64_t Kernel::work_bound() const {
  return work_start_ + patience_ * options.steps_per_reordering * std::max<std::uint64_t>(live(), least_work);
}

void Kernel::reorder_for_work() {
  collect();
  if (counts_.steps >= work_bound()) {
    const std::size_t before = live();
    sift_now();
    patience_ = live() * 10 < before * 9 ? 1 : patience_ * 2;
  }
  work_check_ = work_bound();
}

void Kernel::reorder_automatically() {
  collect();
  if (live() > reorder_threshold_) {
    sift_now();
    reorder_threshold_ = std::max(options.first_reordering, live() * 2);
  }
  reorder_check_ = live() + reorder_threshold_ * garbage_before_check;
}

void Kernel::reorder_after_restart() {
  const std::size_t before = reorder_threshold_;
  sift_now();
  reorder_threshold_ = std::max(before * 2, live() * 2);
}

std::size_t Kernel::memory_bytes() const {
  std::size_t buckets = 0;
  for (const UniqueTable& table : tables_) buckets += table.buckets.size();
  return std::size_t{capacity_} * sizeof(Node) + buckets * sizeof(std::uint32_t) + cache.bytes();
}

std::uint32_t Kernel::new_substitution() {
  if (++substitutions_ == 0) {
    cache.clear();
    ++substitutions_;
  }
  return substitutions_;
}

Statistics Kernel::statistics() const {
  Statistics result = counts_;
  result.live_nodes = live();
  result.peak_nodes = used_;
  result.memory_bytes = memory_bytes();
  result.steps += fuel_per_check - fuel_;
  return result;
}

}  // namespace heed::bdd
