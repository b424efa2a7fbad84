#pragma once

#include <cstddef>
#include <cstdint>

namespace heed::util {

/// A fixed mixing of two words (no per-process seed: order of work never depends on the run). \cite
/// steele.14.oopsla
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = a + 0x9e3779b97f4a7c15ULL * (b + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Takes one more word into the hash of a sequence, by one multiplication: its upper half, which all words so
/// far reach, is folded into the lower half, from which a place in a table may be taken.
[[nodiscard]] constexpr std::uint64_t absorb(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
  return hash ^ (hash >> 32);
}

}  // namespace heed::util
