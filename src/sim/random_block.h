#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace heed::sim {

/// How many traces are drawn side by side; the arithmetic of one block is a long chain, that of many fills
/// the processor.
inline constexpr std::size_t lanes = 16;

/// Word j of every lane: words[j][lane].
using RandomBlock = std::array<std::array<std::uint32_t, lanes>, 4>;

/// Block \p index of the streams \p stream ... \p stream + lanes - 1, as util::CounterRandom(seed, stream)
/// draws it.
inline void random_block(std::uint64_t seed, std::uint64_t stream, std::uint64_t index, RandomBlock& words) {
  auto& [c0, c1, c2, c3] = words;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    c0[lane] = static_cast<std::uint32_t>(index);
    c1[lane] = static_cast<std::uint32_t>(index >> 32);
    c2[lane] = static_cast<std::uint32_t>(stream + lane);
    c3[lane] = static_cast<std::uint32_t>((stream + lane) >> 32);
  }
  auto k0 = static_cast<std::uint32_t>(seed), k1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::uint64_t p0 = std::uint64_t{0xD2511F53} * c0[lane];
      const std::uint64_t p1 = std::uint64_t{0xCD9E8D57} * c2[lane];
      c0[lane] = static_cast<std::uint32_t>(p1 >> 32) ^ c1[lane] ^ k0;
      c1[lane] = static_cast<std::uint32_t>(p1);
      c2[lane] = static_cast<std::uint32_t>(p0 >> 32) ^ c3[lane] ^ k1;
      c3[lane] = static_cast<std::uint32_t>(p0);
    }
    k0 += 0x9E3779B9;
    k1 += 0xBB67AE85;
  }
}

}  // namespace heed::sim
