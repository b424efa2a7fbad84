#include "reorder.h"

#include <algorithm>

namespace heed::bdd {

namespace {
/// Node visits that a sifting pass may make where the caller sets no bound: this many per live node, and a
/// base.
constexpr std::uint64_t visits_per_node = 100, visits_base = 1'000'000;
}  // namespace

Reorderer::Reorderer(Kernel& kernel) : kernel_(kernel), row_words_((kernel.level_of_.size() + 63) / 64) {
  kernel_.collect();
  for (const std::uint32_t variable : kernel_.at_level_) {
    if (kernel_.group_of_[variable] == variable) {
      blocks_.push_back({variable, 1});
    } else {
      ++blocks_.back().size;
    }
  }
  count_parents();
  ++kernel_.counts_.reorderings;
}

/// Slots that swaps freed may hold other functions by now, so nothing that was computed before can be
/// trusted.
Reorderer::~Reorderer() {
  kernel_.cache.clear();
}

void Reorderer::count_parents() {
  parents_.assign(kernel_.capacity_, 0);
  for (std::uint32_t i = 1; i < kernel_.used_; ++i) {
    const Node& node = kernel_.nodes_.get()[i];
    if (node.variable == free_variable) continue;
    ++parents_[node.low >> 1];
    ++parents_[node.high >> 1];
  }
  kernel_.handles.for_each([this](Edge edge) { ++parents_[edge >> 1]; });
}

std::size_t Reorderer::block_nodes(const Block& block) const {
  std::size_t sum = 0;
  for (std::uint32_t v = block.first; v < block.first + block.size; ++v) sum += kernel_.tables_[v].count;
  return sum;
}

std::size_t Reorderer::position_of(std::uint32_t first) const {
  const auto found = std::find_if(blocks_.begin(), blocks_.end(),
                                  [first](const Block& block) { return block.first == first; });
  return static_cast<std::size_t>(found - blocks_.begin());
}

void Reorderer::sift(const SiftOptions& options) {
  find_interactions();
  for (;;) {
    const std::size_t before = kernel_.live();
    const std::uint64_t bound =
        options.max_node_swaps != 0 ? options.max_node_swaps : before * visits_per_node + visits_base;
    allowance_ = kernel_.counts_.node_swaps + bound;
    sift_pass(options);
    if (!options.until_no_gain || kernel_.live() + before / 50 >= before) return;
  }
}

void Reorderer::sift_pass(const SiftOptions& options) {
  std::vector<Block> queue = blocks_;
  std::stable_sort(queue.begin(), queue.end(),
                   [this](const Block& a, const Block& b) { return block_nodes(a) > block_nodes(b); });
  if (queue.size() > options.max_groups) queue.resize(options.max_groups);
  for (const Block& block : queue) {
    if (kernel_.counts_.node_swaps >= allowance_) return;
    if (block_nodes(block) > 0) sift_block(block.first, options.max_growth);
  }
}

/// Towards the nearer end first: the way back is then the shorter one.
void Reorderer::sift_block(std::uint32_t first, double max_growth) {
  std::size_t position = position_of(first);
  best_size_ = kernel_.live();
  best_position_ = position;
  const std::size_t last = blocks_.size() - 1;
  const bool down_first = position * 2 > last;
  travel(position, down_first ? last : 0, max_growth);
  travel(position, down_first ? 0 : last, max_growth);
  while (position < best_position_) swap_blocks(position++);
  while (position > best_position_) swap_blocks(--position);
}

/// Stops where nothing further on can beat the best: at most the nodes of the block and of what it has yet to
/// pass and interacts with could vanish.
void Reorderer::travel(std::size_t& position, std::size_t end, double max_growth) {
  const Block block = blocks_[position];
  std::size_t ahead = 0;
  for (std::size_t p = std::min(position, end); p <= std::max(position, end); ++p)
    ahead += nodes_at_stake(block, blocks_[p]);
  while (position != end && kernel_.counts_.node_swaps < allowance_) {
    const std::size_t size = kernel_.live();
    if (size >= best_size_ + ahead + block_nodes(block)) return;
    if (static_cast<double>(size) > static_cast<double>(best_size_) * max_growth) return;
    const bool down = position < end;
    const std::size_t passed = down ? position + 1 : position - 1;
    ahead -= nodes_at_stake(block, blocks_[passed]);
    swap_blocks(std::min(position, passed));
    position = passed;
    if (kernel_.live() < best_size_) {
      best_size_ = kernel_.live();
      best_position_ = position;
    }
  }
}

/// Nodes of \p other, if it is another block that interacts with \p block.
std::size_t Reorderer::nodes_at_stake(const Block& block, const Block& other) const {
  if (block.first == other.first) return 0;
  for (std::uint32_t v = block.first; v < block.first + block.size; ++v) {
    for (std::uint32_t w = other.first; w < other.first + other.size; ++w) {
      if (interact(v, w)) return block_nodes(other);
    }
  }
  return 0;
}

/// A level that passes another makes at most two nodes of each of its own, and may have twice as many
/// afterwards: a block that passes two levels makes six of each. What a longer block needs beyond that is
/// taken without asking in swap_levels(), for a block stopped half-way would not stand together.
void Reorderer::ensure_room(std::size_t position) {
  if (kernel_.budget != nullptr) kernel_.budget->check();
  const std::size_t wanted = 6 * block_nodes(blocks_[position]);
  if (wanted <= room()) return;
  kernel_.grow_nodes(kernel_.capacity_ + (wanted - room()));
  parents_.resize(kernel_.capacity_, 0);
}

std::size_t Reorderer::room() const {
  return std::size_t{kernel_.free_count_} + (kernel_.capacity_ - kernel_.used_);
}

void Reorderer::ensure_room_for_level(std::uint32_t upper) {
  const std::size_t wanted = 2 * std::size_t{kernel_.tables_[upper].count};
  if (wanted <= room()) return;
  kernel_.grow_without_asking(kernel_.capacity_ + (wanted - room()));
  parents_.resize(kernel_.capacity_, 0);
}

void Reorderer::swap_blocks(std::size_t position) {
  ensure_room(position);
  const Block upper = blocks_[position], lower = blocks_[position + 1];
  const std::uint32_t top = kernel_.level_of_[upper.first];
  for (std::uint32_t j = 0; j < lower.size; ++j) {
    for (std::uint32_t level = top + upper.size + j; level-- > top + j;) swap_levels(level);
  }
  std::swap(blocks_[position], blocks_[position + 1]);
}

/// The nodes of the upper variable that depend on the lower one become nodes of the lower one, in place; the
/// others and all nodes of the lower variable that keep a parent stay as they are.
void Reorderer::swap_levels(std::uint32_t upper_level) {
  const std::uint32_t upper = kernel_.at_level_[upper_level], lower = kernel_.at_level_[upper_level + 1];
  std::swap(kernel_.at_level_[upper_level], kernel_.at_level_[upper_level + 1]);
  std::swap(kernel_.level_of_[upper], kernel_.level_of_[lower]);
  if (!interact(upper, lower)) return;
  ensure_room_for_level(upper);
  kernel_.counts_.node_swaps += kernel_.tables_[upper].count;
  std::uint32_t list = detach_dependent(upper, lower);
  while (list != 0) {
    const std::uint32_t index = list;
    list = kernel_.nodes_.get()[index].next;
    rewrite(index, upper, lower);
    ++kernel_.counts_.node_swaps;
  }
}

/// Takes the nodes of \p upper with a child of \p lower out of their table. \returns them, chained
std::uint32_t Reorderer::detach_dependent(std::uint32_t upper, std::uint32_t lower) {
  Node* const nodes = kernel_.nodes_.get();
  UniqueTable& table = kernel_.tables_[upper];
  std::uint32_t list = 0;
  for (std::uint32_t& head : table.buckets) {
    std::uint32_t* link = &head;
    while (*link != 0) {
      Node& node = nodes[*link];
      if (nodes[node.low >> 1].variable != lower && nodes[node.high >> 1].variable != lower) {
        link = &node.next;
        continue;
      }
      const std::uint32_t index = *link;
      *link = node.next;
      node.next = list;
      list = index;
      --table.count;
    }
  }
  return list;
}

void Reorderer::rewrite(std::uint32_t index, std::uint32_t upper, std::uint32_t lower) {
  const Edge low = kernel_.nodes_.get()[index].low, high = kernel_.nodes_.get()[index].high;
  Edge low_low = low, low_high = low, high_low = high, high_high = high;
  if (kernel_.variable(low) == lower) {
    low_low = kernel_.low(low);
    low_high = kernel_.high(low);
  }
  if (kernel_.variable(high) == lower) {
    high_low = kernel_.low(high);
    high_high = kernel_.high(high);
  }
  const Edge new_low = make_lower(upper, low_low, high_low);
  ++parents_[new_low >> 1];
  const Edge new_high = make_lower(upper, low_high, high_high);
  ++parents_[new_high >> 1];
  Node& node = kernel_.nodes_.get()[index];
  node.low = new_low;
  node.high = new_high;
  node.variable = lower;
  insert(index);
  drop(low, lower);
  drop(high, lower);
}

/// As Kernel::make, without collection: ensure_room() has seen to it.
Edge Reorderer::make_lower(std::uint32_t variable, Edge low, Edge high) {
  if (low == high) return low;
  const Edge flip = high & 1U;
  low ^= flip;
  high ^= flip;
  const std::uint64_t key = children(low, high);
  for (std::uint32_t i = kernel_.tables_[variable].bucket(key); i != 0; i = kernel_.nodes_.get()[i].next) {
    if (children(kernel_.nodes_.get()[i]) == key) return (i << 1) | flip;
  }
  const std::uint32_t index = kernel_.take_slot();
  kernel_.nodes_.get()[index] = {low, high, 0, variable};
  parents_[index] = 0;
  ++parents_[low >> 1];
  ++parents_[high >> 1];
  insert(index);
  return (index << 1) | flip;
}

void Reorderer::insert(std::uint32_t index) {
  Node& node = kernel_.nodes_.get()[index];
  UniqueTable& table = kernel_.tables_[node.variable];
  if (table.count >= table.limit) kernel_.grow_table(table);
  std::uint32_t& bucket = table.bucket(children(node));
  node.next = bucket;
  bucket = index;
  ++table.count;
}

/// One parent less. What a node of \p lower pointed to has new parents by now, so freeing it never cascades.
void Reorderer::drop(Edge edge, std::uint32_t lower) {
  const std::uint32_t index = edge >> 1;
  if (--parents_[index] != 0 || index == 0) return;
  Node& node = kernel_.nodes_.get()[index];
  assert(node.variable == lower);
  UniqueTable& table = kernel_.tables_[lower];
  std::uint32_t* link = &table.bucket(children(node));
  while (*link != index) link = &kernel_.nodes_.get()[*link].next;
  *link = node.next;
  --table.count;
  --parents_[node.low >> 1];
  --parents_[node.high >> 1];
  node.variable = free_variable;
  node.next = kernel_.free_;
  kernel_.free_ = index;
  ++kernel_.free_count_;
}

void Reorderer::set_order(std::span<const std::uint32_t> order) {
  std::size_t position = 0;
  for (const std::uint32_t variable : order) {
    if (kernel_.group_of_[variable] != variable) continue;
    for (std::size_t at = position_of(variable); at > position; --at) swap_blocks(at - 1);
    ++position;
  }
}

}  // namespace heed::bdd
