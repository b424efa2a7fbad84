// Special functions by their classical expansions: series where they converge fast, continued fractions
// (modified Lentz) where those do. log_gamma is our own since the C library's writes a global sign.
#include <heed/sim/statistics.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace heed::sim {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double tiny = 1e-300;
constexpr int most_terms = 10'000'000;

/// ln Gamma(x), x > 0: upwards by the recurrence to 15, there Stirling's series is exact to a double. \cite
/// dlmf
double log_gamma(double x) {
  double product = 1;
  for (; x < 15; x += 1) product *= x;
  const double r = 1 / (x * x);
  const double series =
      (1.0 / 12 -
       r * (1.0 / 360 - r * (1.0 / 1260 - r * (1.0 / 1680 - r * (1.0 / 1188 - r * 691.0 / 360360))))) /
      x;
  return (x - 0.5) * std::log(x) - x + 0.5 * std::log(2 * std::numbers::pi) + series - std::log(product);
}

/// x^a e^-x / Gamma(a), the factor before series and fraction.
double gamma_factor(double a, double x) {
  return std::exp(a * std::log(x) - x - log_gamma(a));
}

/// P(a, x) by its power series. \pre 0 < x < a + 1
double gamma_series(double a, double x) {
  double term = 1 / a, sum = term;
  for (int n = 1; n < most_terms && term > sum * epsilon; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * gamma_factor(a, x);
}

/// Evaluates b0 + a1/(b1 + a2/(b2 + ...)) term by term.
class Lentz {
 public:
  explicit Lentz(double b0) : value_(nonzero(b0)), c_(value_) {}
  /// \returns whether the value still moves
  bool add(double a, double b) {
    d_ = 1 / nonzero(b + a * d_);
    c_ = nonzero(b + a / c_);
    value_ *= c_ * d_;
    return std::abs(c_ * d_ - 1) > epsilon;
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  static double nonzero(double x) { return std::abs(x) < tiny ? tiny : x; }
  double value_, c_, d_ = 0;
};

/// Q(a, x) by its continued fraction. \pre x >= a + 1
double gamma_fraction(double a, double x) {
  Lentz fraction(x + 1 - a);
  for (int n = 1; n < most_terms; ++n)
    if (!fraction.add(n * (a - n), x + 2 * n + 1 - a)) break;
  return gamma_factor(a, x) / fraction.value();
}

/// I_x(a, b) by its continued fraction. \pre 0 < x < (a + 1) / (a + b + 2)
double beta_fraction(double a, double b, double x) {
  Lentz fraction(1);
  for (int m = 0; m < most_terms; ++m) {
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    const double next = m + 1.0;
    const double even = next * (b - next) * x / ((a + 2 * next - 1) * (a + 2 * next));
    (void)fraction.add(odd, 1);
    if (!fraction.add(even, 1)) break;
  }
  const double log_factor =
      a * std::log(x) + b * std::log1p(-x) + log_gamma(a + b) - log_gamma(a) - log_gamma(b);
  return std::exp(log_factor) / (a * fraction.value());
}

/// The x in [low, high] where \p increasing reaches \p wanted, to the last bit that bisection gives.
template <typename Function>
double invert(const Function& increasing, double wanted, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (increasing(middle) < wanted ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

}  // namespace

double gamma_p(double a, double x) {
  assert(a > 0 && x >= 0);
  if (x == 0) return 0;
  return x < a + 1 ? gamma_series(a, x) : 1 - gamma_fraction(a, x);
}

double gamma_q(double a, double x) {
  assert(a > 0 && x >= 0);
  if (x == 0) return 1;
  return x < a + 1 ? 1 - gamma_series(a, x) : gamma_fraction(a, x);
}

double beta_i(double a, double b, double x) {
  assert(a > 0 && b > 0 && x >= 0 && x <= 1);
  if (x == 0 || x == 1) return x;
  return x < (a + 1) / (a + b + 2) ? beta_fraction(a, b, x) : 1 - beta_fraction(b, a, 1 - x);
}

// P(|T| > t) = I_x(d/2, 1/2) at x = d / (d + t^2), which falls as t grows: bisection over t.
double student_quantile(double confidence, unsigned degrees) {
  assert(confidence > 0 && confidence < 1 && degrees > 0);
  const double d = degrees, tail = 1 - confidence;
  const auto beyond = [&](double t) { return beta_i(d / 2, 0.5, d / (d + t * t)); };
  double low = 0, high = 1;
  while (beyond(high) > tail) high *= 2;
  while (high - low > 1e-11 * high) {
    const double middle = low + (high - low) / 2;
    (beyond(middle) > tail ? low : high) = middle;
  }
  return high;
}

double normal_quantile(double confidence) {
  assert(confidence > 0 && confidence < 1);
  const auto outside = [](double z) { return -std::erfc(z / std::numbers::sqrt2); };
  return invert(outside, confidence - 1, 0, 40);
}

Interval wilson(std::uint64_t successes, std::uint64_t trials, double confidence) {
  assert(successes <= trials);
  if (trials == 0) return {};
  const double n = static_cast<double>(trials), p = static_cast<double>(successes) / n;
  const double z = normal_quantile(confidence), z2 = z * z / n;
  const double middle = (p + z2 / 2) / (1 + z2);
  const double half = z * std::sqrt(p * (1 - p) / n + z2 / (4 * n)) / (1 + z2);
  return {successes == 0 ? 0 : std::max(0.0, middle - half),
          successes == trials ? 1 : std::min(1.0, middle + half)};
}

Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double confidence) {
  assert(successes <= trials && confidence > 0 && confidence < 1);
  const double k = static_cast<double>(successes), rest = static_cast<double>(trials - successes);
  const double tail = (1 - confidence) / 2;
  Interval result;
  if (successes > 0) result.low = invert([&](double x) { return beta_i(k, rest + 1, x); }, tail, 0, 1);
  if (successes < trials)  // The upper tail as I of 1 - x keeps its digits.
    result.high = 1 - invert([&](double y) { return beta_i(rest, k + 1, y); }, tail, 0, 1);
  return result;
}

ChiSquare chi_square(std::span<const std::uint64_t> counts, std::span<const double> probabilities) {
  assert(counts.size() == probabilities.size());
  double total = 0;
  for (const std::uint64_t count : counts) total += static_cast<double>(count);
  ChiSquare result;
  unsigned possible = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double observed = static_cast<double>(counts[i]), expected = total * probabilities[i];
    if (probabilities[i] > 0) ++possible;
    if (expected > 0)
      result.statistic += (observed - expected) * (observed - expected) / expected;
    else if (observed > 0)
      result.statistic = std::numeric_limits<double>::infinity();
  }
  result.degrees = possible == 0 ? 0 : possible - 1;
  if (std::isinf(result.statistic))
    result.p_value = 0;
  else if (result.degrees > 0)
    result.p_value = gamma_q(result.degrees / 2.0, result.statistic / 2);
  return result;
}

}  // namespace heed::sim
