#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace heed::sim {

/// How many traces are drawn side by side; the arithmetic of one block is a long chain, that of many fills
/// the processor.
inline constexpr std::size_t lanes = 16;

/// Word j of every lane: words[j][lane].
using RandomBlock = std::array<std::array<std::uint32_t, lanes>, 4>;

#if defined(__SSE2__)

// Two lanes per register, each word in the lower half of 64 bits; the upper halves hold rubbish, which the
// multiplication does not read. Compilers find this form neither in 32-bit nor in 64-bit loops.
class RandomLanes {
 public:
  RandomLanes(std::uint64_t stream, std::uint64_t index)
      : c0_(spread(index)),
        c1_(spread(index >> 32)),
        c2_(_mm_add_epi64(spread(stream), _mm_set_epi64x(1, 0))),
        c3_(_mm_srli_epi64(c2_, 32)) {}

  void round(std::uint32_t k0, std::uint32_t k1) {
    const __m128i p0 = _mm_mul_epu32(spread(0xD2511F53), c0_), p1 = _mm_mul_epu32(spread(0xCD9E8D57), c2_);
    c0_ = _mm_xor_si128(_mm_srli_epi64(p1, 32), _mm_xor_si128(c1_, spread(k0)));
    c1_ = p1;
    c2_ = _mm_xor_si128(_mm_srli_epi64(p0, 32), _mm_xor_si128(c3_, spread(k1)));
    c3_ = p0;
  }

  void store(RandomBlock& words, std::size_t lane) const {
    store(c0_, &words[0][lane]);
    store(c1_, &words[1][lane]);
    store(c2_, &words[2][lane]);
    store(c3_, &words[3][lane]);
  }

  static constexpr std::size_t size = 2;

 private:
  static __m128i spread(std::uint64_t value) { return _mm_set1_epi64x(std::bit_cast<std::int64_t>(value)); }
  static void store(__m128i value, std::uint32_t* target) {
    _mm_storel_epi64(reinterpret_cast<__m128i*>(target), _mm_shuffle_epi32(value, _MM_SHUFFLE(3, 1, 2, 0)));
  }
  __m128i c0_, c1_, c2_, c3_;
};

#else

class RandomLanes {
 public:
  RandomLanes(std::uint64_t stream, std::uint64_t index)
      : c0_(index & low), c1_(index >> 32), c2_(stream & low), c3_(stream >> 32) {}

  void round(std::uint32_t k0, std::uint32_t k1) {
    const std::uint64_t p0 = 0xD2511F53 * c0_, p1 = 0xCD9E8D57 * c2_;
    c0_ = (p1 >> 32) ^ c1_ ^ k0;
    c1_ = p1 & low;
    c2_ = (p0 >> 32) ^ c3_ ^ k1;
    c3_ = p0 & low;
  }

  void store(RandomBlock& words, std::size_t lane) const {
    words[0][lane] = static_cast<std::uint32_t>(c0_);
    words[1][lane] = static_cast<std::uint32_t>(c1_);
    words[2][lane] = static_cast<std::uint32_t>(c2_);
    words[3][lane] = static_cast<std::uint32_t>(c3_);
  }

  static constexpr std::size_t size = 1;

 private:
  static constexpr std::uint64_t low = 0xFFFFFFFF;
  std::uint64_t c0_, c1_, c2_, c3_;
};

#endif

/// Block \p index of the streams \p stream ... \p stream + lanes - 1, as util::CounterRandom(seed, stream)
/// draws it.
inline void random_block(std::uint64_t seed, std::uint64_t stream, std::uint64_t index, RandomBlock& words) {
  // Four registers' worth at a time: enough to hide the multiplication's latency, few enough to stay in
  // registers.
  constexpr std::size_t stride = 4 * RandomLanes::size;
  for (std::size_t lane = 0; lane < lanes; lane += stride) {
    RandomLanes a(stream + lane, index), b(stream + lane + RandomLanes::size, index),
        c(stream + lane + 2 * RandomLanes::size, index), d(stream + lane + 3 * RandomLanes::size, index);
    auto k0 = static_cast<std::uint32_t>(seed), k1 = static_cast<std::uint32_t>(seed >> 32);
    for (int i = 0; i < 10; ++i, k0 += 0x9E3779B9, k1 += 0xBB67AE85) {
      a.round(k0, k1);
      b.round(k0, k1);
      c.round(k0, k1);
      d.round(k0, k1);
    }
    a.store(words, lane);
    b.store(words, lane + RandomLanes::size);
    c.store(words, lane + 2 * RandomLanes::size);
    d.store(words, lane + 3 * RandomLanes::size);
  }
}

}  // namespace heed::sim
