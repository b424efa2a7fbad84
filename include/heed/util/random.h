#pragma once

#include <array>
#include <cstdint>

namespace heed::util {

/// Philox 4x32 with 10 rounds: block `counter` of the stream `key`, four words. Pure function: trace i is the
/// same on any thread or machine. \cite salmon.11.sc
[[nodiscard]] std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key);

/// Random numbers of one trace: (seed, stream) fixes the whole sequence.
class CounterRandom {
 public:
  using result_type = std::uint32_t;
  CounterRandom(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return UINT32_MAX; }
  result_type operator()() {
    if (used_ == 4) refill();
    return block_[used_++];
  }
  /// Uniform in [0, 1), 53 bits.
  double uniform() {
    const std::uint64_t high = (*this)();
    return static_cast<double>((high << 21) ^ ((*this)() >> 11)) * 0x1p-53;
  }
  /// Uniform in 0 ... bound-1 without bias. \pre bound > 0
  std::uint32_t below(std::uint32_t bound);

 private:
  void refill();
  std::uint64_t seed_, stream_, index_ = 0;
  std::array<std::uint32_t, 4> block_{};
  unsigned used_ = 4;
};

}  // namespace heed::util
