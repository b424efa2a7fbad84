#pragma once

#include <heed/sim/lumping.h>
#include <heed/sim/rational.h>

#include <algorithm>
#include <cstdint>

namespace heed::sim {

/// A sum of products of probabilities as a double, with the roundings on the longest way to it: it is within
/// (1 + u)^roundings - 1 of its true value, relatively, u = 2^-53, since no term is negative. What underflows
/// loses at most 2^-1074 for each operation.
struct Counted {
  double value = 0;
  std::uint64_t roundings = 0;

  Counted() = default;
  Counted(double v, std::uint64_t r) : value(v), roundings(r) {}
  /// get_d() cuts off: at most 2^-52, as two roundings.
  explicit Counted(const Rational& exact)
      : value(to_double(exact)), roundings(Rational(value) == exact ? 0 : 2) {}

  friend Counted operator*(const Counted& a, const Counted& b) {
    return {a.value * b.value, a.roundings + b.roundings + 1};
  }
  Counted& operator+=(const Counted& other) {
    value += other.value;
    roundings = std::max(roundings, other.roundings) + 1;
    return *this;
  }
};

[[nodiscard]] inline Figure figure(const Rational& value) {
  return known(value);
}

/// With r roundings the error is below r u / (1 - r u) of the true value; doubled, that covers the division
/// by 1 - r u and the roundings here, as long as r u < 1/8, that is for 10^15 roundings.
[[nodiscard]] inline Figure figure(const Counted& found) {
  constexpr double unit = 0x1p-53;
  constexpr double underflow = 1e-300;  // of fewer than 2^70 operations
  return {std::nullopt, found.value,
          found.value * 2 * (static_cast<double>(found.roundings) * unit) + underflow};
}

}  // namespace heed::sim
