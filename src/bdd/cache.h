#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "node.h"

namespace heed::bdd {

/// What a cached result is of. Codes of two-operand operations stand where the third operand would.
enum class Binary : std::uint32_t {
  And,
  Xor,
  Disjoint,
  Exists,
  Next,
  Current,
  AndNext,
  Cofactor,
  Restrict,
  Constrain,
  Compose
};
/// Codes of three-operand operations stand in the three free bits of the first operand.
enum class Ternary : std::uint32_t { Ite = 1, AndExists = 2, AndExistsNext = 3 };

/// Remembers results; forgets the older of two that collide. Grows with the work done, within bounds.
/// Two ways instead of one: a relational product keeps a conjunction and its quantified form alive side by
/// side.
class ComputedCache {
 public:
  ComputedCache(std::size_t bytes, std::size_t max_bytes);

  bool find(Binary op, Edge f, Edge g, Edge& result) { return find(f, g, code(op), result); }
  void store(Binary op, Edge f, Edge g, Edge result) { store(f, g, code(op), result); }
  bool find(Ternary op, Edge f, Edge g, Edge h, Edge& result) { return find(tagged(op, f), g, h, result); }
  void store(Ternary op, Edge f, Edge g, Edge h, Edge result) { store(tagged(op, f), g, h, result); }

  void clear();
  /// Forget what mentions a node without its bit in \p marked.
  void sweep(const std::vector<std::uint64_t>& marked);
  /// Times that the next growth doubles it; 0 at the bound.
  [[nodiscard]] unsigned growth() const;
  /// Grows, keeping what is there.
  void grow();
  [[nodiscard]] std::size_t entries() const { return sets_.size() * 2; }
  [[nodiscard]] std::size_t bytes() const { return sets_.size() * sizeof(Set); }

 private:
  struct Entry {
    std::uint32_t f, g, h;
    Edge result;
  };
  struct alignas(32) Set {
    Entry newer, older;
  };
  static constexpr std::uint32_t binary_mark = 0xe0000000U;
  static constexpr std::uint32_t operand_mask = 0x1fffffffU;

  static std::uint32_t code(Binary op) { return binary_mark | static_cast<std::uint32_t>(op); }
  static std::uint32_t tagged(Ternary op, Edge f) { return f | (static_cast<std::uint32_t>(op) << 29); }
  static bool same(const Entry& entry, std::uint32_t f, std::uint32_t g, std::uint32_t h) {
    return entry.f == f && entry.g == g && entry.h == h;
  }
  [[nodiscard]] Set& set(std::uint32_t f, std::uint32_t g, std::uint32_t h) {
    return sets_[scatter(children(f, g) + scatter(h)) >> shift_];
  }
  bool find(std::uint32_t f, std::uint32_t g, std::uint32_t h, Edge& result) {
    Set& place = set(f, g, h);
    if (same(place.newer, f, g, h)) {
      result = place.newer.result;
      return true;
    }
    if (!same(place.older, f, g, h)) return false;
    result = place.older.result;
    return true;
  }
  void store(std::uint32_t f, std::uint32_t g, std::uint32_t h, Edge result) {
    Set& place = set(f, g, h);
    place.older = place.newer;
    place.newer = {f, g, h, result};
  }

  std::vector<Set> sets_;
  unsigned shift_;
  std::size_t max_bytes_;
};

}  // namespace heed::bdd
