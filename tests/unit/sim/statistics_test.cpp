#include <gtest/gtest.h>
#include <heed/sim/statistics.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace heed::sim {
namespace {

void expect_close(double value, double reference, double relative = 1e-12) {
  EXPECT_NEAR(value, reference, std::abs(reference) * relative) << value << " against " << reference;
}

TEST(Statistics, QuantilesOfTheNormalDistribution) {
  expect_close(normal_quantile(0.95), 1.959963984540054);
  expect_close(normal_quantile(0.99), 2.5758293035489004);
  expect_close(normal_quantile(0.5), 0.6744897501960817);
  expect_close(normal_quantile(0.6826894921370859), 1, 1e-10);
}

// Q(n, x) = e^-x sum of x^i / i! for whole n; P(1/2, x) = erf(sqrt x).
TEST(Statistics, GammaAgainstClosedForms) {
  for (const double x : {1e-6, 0.1, 0.5, 1.0, 2.5, 7.0, 20.0, 80.0}) {
    double term = std::exp(-x), sum = 0;
    for (int n = 1; n <= 30; ++n) {
      sum += term;
      term *= x / n;
      expect_close(gamma_q(n, x), std::min(sum, 1.0), 1e-11);
      EXPECT_NEAR(gamma_p(n, x) + gamma_q(n, x), 1, 1e-14);
    }
    expect_close(gamma_p(0.5, x), std::erf(std::sqrt(x)));
    expect_close(gamma_q(0.5, x), std::erfc(std::sqrt(x)), 1e-11);
  }
  EXPECT_EQ(gamma_p(3, 0), 0);
  EXPECT_EQ(gamma_q(3, 0), 1);
}

// I_x(k, n - k + 1) = P(at least k successes in n trials).
TEST(Statistics, BetaAgainstBinomialSums) {
  for (const int n : {1, 2, 5, 17, 40})
    for (const double x : {0.001, 0.2, 0.5, 0.77, 0.999})
      for (int k = 1; k <= n; ++k) {
        double sum = 0;
        for (int i = k; i <= n; ++i)
          sum += std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1) + i * std::log(x) +
                          (n - i) * std::log1p(-x));
        EXPECT_NEAR(beta_i(k, n - k + 1, x), sum, 1e-12);
        EXPECT_NEAR(beta_i(k, n - k + 1, x) + beta_i(n - k + 1, k, 1 - x), 1, 1e-12);
      }
  EXPECT_EQ(beta_i(2, 3, 0), 0);
  EXPECT_EQ(beta_i(2, 3, 1), 1);
}

// One degree of freedom is Cauchy's distribution: P(|T| <= t) = 2/pi atan t; two have t = c sqrt(2 / (1 -
// c^2)).
TEST(Statistics, QuantilesOfStudentsDistribution) {
  for (const double c : {0.1, 0.5, 0.9, 0.95, 0.999}) {
    expect_close(student_quantile(c, 1), std::tan(c * std::acos(-1.0) / 2), 1e-9);
    expect_close(student_quantile(c, 2), c * std::sqrt(2 / (1 - c * c)), 1e-9);
  }
  EXPECT_NEAR(student_quantile(0.95, 15), 2.131449546, 1e-8);
  EXPECT_NEAR(student_quantile(0.99, 30), 2.749995654, 1e-8);
}

TEST(Statistics, ChiSquareAgainstTables) {
  const std::vector<std::array<double, 3>> table = {{1, 3.841458820694124, 0.05},
                                                    {2, 5.991464547107979, 0.05},
                                                    {4, 9.487729036781154, 0.05},
                                                    {10, 23.209251158954356, 0.01}};
  for (const auto& [degrees, statistic, p] : table)
    expect_close(gamma_q(degrees / 2, statistic / 2), p, 1e-10);
  const std::vector<std::uint64_t> counts = {44, 56};
  const std::vector<double> fair = {0.5, 0.5};
  const ChiSquare result = chi_square(counts, fair);
  expect_close(result.statistic, 1.44);
  EXPECT_EQ(result.degrees, 1U);
  expect_close(result.p_value, 0.2301393404, 1e-8);
}

TEST(Statistics, ChiSquareOfTheImpossibleAndTheCertain) {
  const std::vector<double> certain = {1, 0};
  EXPECT_EQ(chi_square(std::vector<std::uint64_t>{100, 0}, certain).p_value, 1);
  EXPECT_EQ(chi_square(std::vector<std::uint64_t>{99, 1}, certain).p_value, 0);
  EXPECT_EQ(chi_square(std::vector<std::uint64_t>{0, 0}, certain).p_value, 1);
}

TEST(Statistics, WilsonAndClopperPearsonAgainstPublishedValues) {
  const Interval score = wilson(10, 100);
  EXPECT_NEAR(score.low, 0.0552291, 1e-6);
  EXPECT_NEAR(score.high, 0.1743657, 1e-6);
  const Interval exact = clopper_pearson(10, 100);
  EXPECT_NEAR(exact.low, 0.0490047, 1e-6);
  EXPECT_NEAR(exact.high, 0.1762226, 1e-6);
  expect_close(clopper_pearson(0, 10).high, 1 - std::pow(0.025, 0.1), 1e-10);
  expect_close(clopper_pearson(10, 10).low, std::pow(0.025, 0.1), 1e-10);
}

TEST(Statistics, IntervalsAtTheBorders) {
  EXPECT_EQ(wilson(0, 0).low, 0);
  EXPECT_EQ(wilson(0, 0).high, 1);
  EXPECT_EQ(wilson(0, 50).low, 0);
  EXPECT_EQ(wilson(50, 50).high, 1);
  EXPECT_EQ(clopper_pearson(0, 50).low, 0);
  EXPECT_EQ(clopper_pearson(50, 50).high, 1);
  const Interval rare = clopper_pearson(1, 1'000'000'000);
  EXPECT_NEAR(rare.low * 1e9, 0.0253178, 1e-5);
  EXPECT_NEAR(rare.high * 1e9, 5.571643, 1e-5);
}

// Exact coverage by summing binomial probabilities: Clopper-Pearson never below its level, Wilson near it on
// average.
TEST(Statistics, CoverageByEnumeration) {
  constexpr int n = 60;
  double wilson_sum = 0;
  int points = 0;
  for (double p = 0.005; p < 1; p += 0.01, ++points) {
    double by_wilson = 0, by_clopper = 0;
    for (int k = 0; k <= n; ++k) {
      const double weight = std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) +
                                     k * std::log(p) + (n - k) * std::log1p(-p));
      const Interval w = wilson(k, n), c = clopper_pearson(k, n);
      if (w.low <= p && p <= w.high) by_wilson += weight;
      if (c.low <= p && p <= c.high) by_clopper += weight;
    }
    EXPECT_GE(by_clopper, 0.95 - 1e-9) << p;
    wilson_sum += by_wilson;
  }
  EXPECT_NEAR(wilson_sum / points, 0.95, 0.01);
}

}  // namespace
}  // namespace heed::sim
