#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel.h"

namespace heed::bdd {

/// Changes the variable order in place: every edge keeps its meaning, so handles need not know.
///
/// Groups of variables move as blocks by swaps of adjacent levels. For the time of its life parents are
/// counted, so that a swap can free what it orphans; outside, nodes carry no counters. No operation may be
/// under way. A limit may end it between two swaps of blocks; the order reached then stays. \cite
/// rudell.93.iccad panda.95.iccad
class Reorderer {
 public:
  explicit Reorderer(Kernel& kernel);
  Reorderer(const Reorderer&) = delete;
  Reorderer& operator=(const Reorderer&) = delete;
  ~Reorderer();

  void sift(const SiftOptions& options);
  /// \p order  Kernel variables, top first; groups together.
  void set_order(std::span<const std::uint32_t> order);

 private:
  /// Variables first ... first + size - 1, on adjacent levels.
  struct Block {
    std::uint32_t first;
    std::uint32_t size;
  };

  void sift_pass(const SiftOptions& options);
  void sift_block(std::uint32_t first, double max_growth);
  void travel(std::size_t& position, std::size_t end, double max_growth);
  [[nodiscard]] std::size_t nodes_at_stake(const Block& block, const Block& other) const;
  void swap_blocks(std::size_t position);
  void swap_levels(std::uint32_t upper_level);
  std::uint32_t detach_dependent(std::uint32_t upper, std::uint32_t lower);
  void rewrite(std::uint32_t index, std::uint32_t upper, std::uint32_t lower);
  Edge make_lower(std::uint32_t variable, Edge low, Edge high);
  void drop(Edge edge, std::uint32_t lower);
  void insert(std::uint32_t index);
  void ensure_room(std::size_t position);
  void ensure_room_for_level(std::uint32_t upper);
  [[nodiscard]] std::size_t room() const;

  void count_parents();
  void find_interactions();
  [[nodiscard]] bool interact(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::size_t block_nodes(const Block& block) const;
  [[nodiscard]] std::size_t position_of(std::uint32_t first) const;

  Kernel& kernel_;
  std::vector<Block> blocks_;           ///< In the present order.
  std::vector<std::uint32_t> parents_;  ///< By node: edges and handles to it.
  std::size_t row_words_;
  std::vector<std::uint64_t> interactions_;  ///< Row per variable; empty: not known, everything may interact.
  std::uint64_t allowance_ = 0;  ///< Kernel's count of node swaps at which to stop looking further.
  std::size_t best_size_ = 0;
  std::size_t best_position_ = 0;
};

}  // namespace heed::bdd
