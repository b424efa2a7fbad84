#pragma once

#include <cstdint>
#include <span>

namespace heed::sim {

/// An interval for a probability; 0 <= low <= high <= 1.
struct Interval {
  double low = 0, high = 1;
};

/// The z with P(|N(0,1)| <= z) = confidence: 1.959964 for .95. \pre 0 < confidence < 1
[[nodiscard]] double normal_quantile(double confidence);

/// The t with P(|T| <= t) = confidence for Student's distribution with that many degrees of freedom; relative
/// error below 1e-10. \pre 0 < confidence < 1, degrees > 0
[[nodiscard]] double student_quantile(double confidence, unsigned degrees);

/// Wilson's score interval: centred well even near 0 and 1, covers about `confidence` on average over p.
/// \cite wilson.27.jasa \pre successes <= trials; trials == 0 gives [0, 1].
[[nodiscard]] Interval wilson(std::uint64_t successes, std::uint64_t trials, double confidence = 0.95);

/// Clopper and Pearson's interval: covers at least `confidence` for every p. \cite clopper.34.biometrika
[[nodiscard]] Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials,
                                       double confidence = 0.95);

/// Regularised incomplete gamma functions P(a, x) and Q(a, x) = 1 - P(a, x); a > 0, x >= 0. Relative error
/// below 1e-12 of the smaller one where it exceeds 1e-300. Series for x < a + 1, continued fraction beyond.
/// \cite dlmf
[[nodiscard]] double gamma_p(double a, double x);
[[nodiscard]] double gamma_q(double a, double x);

/// Regularised incomplete beta function I_x(a, b); a, b > 0, 0 <= x <= 1. Continued fraction. \cite dlmf
[[nodiscard]] double beta_i(double a, double b, double x);

struct ChiSquare {
  double statistic = 0;  ///< Infinite when something of probability 0 was counted.
  unsigned degrees = 0;  ///< Categories of positive probability, less one.
  double p_value = 1;    ///< P(chi-square with that many degrees >= statistic); 0 for an infinite statistic.
};

/// Pearson's test of counts against probabilities. \pre sizes agree; probabilities add up to about 1
[[nodiscard]] ChiSquare chi_square(std::span<const std::uint64_t> counts,
                                   std::span<const double> probabilities);

}  // namespace heed::sim
