#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace heed::bdd {

/// 2 * index of a node + complement bit. The high edge of a node is never complemented, so an edge is regular
/// exactly when its function is true where all variables are true; this makes equal functions equal edges.
/// \cite brace.90.dac
using Edge = std::uint32_t;
inline constexpr Edge true_edge = 0;
inline constexpr Edge false_edge = 1;

/// Indices stay below this, which leaves three bits of an edge for the computed cache's operation codes.
inline constexpr std::size_t node_limit = std::size_t{1} << 28;

/// Variables are numbered from 1 inside the kernel; 0 is the terminal's, below every level.
struct alignas(16) Node {
  Edge low;
  Edge high;
  std::uint32_t next;      ///< In its bucket, or in the free list.
  std::uint32_t variable;  ///< free_variable for a slot in the free list.
};
static_assert(sizeof(Node) == 16);
inline constexpr std::uint32_t free_variable = UINT32_MAX;

inline std::uint64_t children(Edge low, Edge high) {
  return low | (std::uint64_t{high} << 32);
}
inline std::uint64_t children(const Node& node) {
  std::uint64_t both = 0;
  std::memcpy(&both, &node.low, sizeof both);
  return both;
}
inline std::uint64_t scatter(std::uint64_t key) {
  return key * 0x9e3779b97f4a7c15ULL;
}

/// All nodes of one variable, chained by Node::next. Index 0 ends a chain: the terminal is in no table.
struct UniqueTable {
  std::vector<std::uint32_t> buckets = std::vector<std::uint32_t>(4, 0);
  unsigned shift = 62;  ///< 64 - log2 of the number of buckets.
  std::uint32_t count = 0;
  std::uint32_t limit = 4;  ///< Nodes at which it grows.

  [[nodiscard]] std::uint32_t& bucket(std::uint64_t key) { return buckets[scatter(key) >> shift]; }
  [[nodiscard]] std::uint32_t bucket(std::uint64_t key) const { return buckets[scatter(key) >> shift]; }
  /// Empties it and makes room for \p nodes.
  void reset(std::uint32_t nodes);
};

}  // namespace heed::bdd
