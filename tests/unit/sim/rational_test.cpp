#include <gtest/gtest.h>
#include <heed/sim/rational.h>
#include <heed/util/diagnostic.h>

namespace heed::sim {
namespace {

Rational read(const std::string& text) {
  return parse_rational({"t", text});
}

std::string error_at(const std::string& text) {
  try {
    (void)read(text);
  } catch (const util::InputError& error) {
    return error.diagnostic().code + "@" + std::to_string(error.diagnostic().location.column);
  }
  return "fine";
}

TEST(Rational, ReadsIntegersDecimalsAndFractionsExactly) {
  EXPECT_EQ(fraction(read("0")), "0");
  EXPECT_EQ(fraction(read(" 1 ")), "1");
  EXPECT_EQ(fraction(read("0.1")), "1/10");
  EXPECT_EQ(fraction(read(".625")), "5/8");
  EXPECT_EQ(fraction(read("2.")), "2");
  EXPECT_EQ(fraction(read("010")), "10");
  EXPECT_EQ(fraction(read("6/8")), "3/4");
  EXPECT_EQ(fraction(read("1 / 3")), "1/3");
  EXPECT_EQ(fraction(read("1e-9")), "1/1000000000");
  EXPECT_EQ(fraction(read("2.5E+1")), "25");
  EXPECT_EQ(read("0." + std::string(999, '0') + "1") * read("1e500") * read("1e500"), 1);
}

TEST(Rational, RefusesEverythingElse) {
  EXPECT_EQ(error_at(""), "bad-number@1");
  EXPECT_EQ(error_at("."), "bad-number@2");
  EXPECT_EQ(error_at("-1"), "bad-number@1");
  EXPECT_EQ(error_at("1/0"), "bad-number@3");
  EXPECT_EQ(error_at("1/"), "bad-number@3");
  EXPECT_EQ(error_at("1/2/3"), "bad-number@4");
  EXPECT_EQ(error_at("0.5x"), "bad-number@4");
  EXPECT_EQ(error_at("1e"), "bad-number@3");
  EXPECT_EQ(error_at("1e1000"), "bad-number@7");
  EXPECT_EQ(error_at(std::string(1001, '9')), "bad-number@1");
  EXPECT_EQ(error_at("nan"), "bad-number@1");
  EXPECT_EQ(error_at("0x1"), "bad-number@2");
}

TEST(Rational, DecimalsAreRoundedExactlyHalfToEven) {
  EXPECT_EQ(decimal(read("1/8"), 2), "0.12");
  EXPECT_EQ(decimal(read("3/8"), 2), "0.38");
  EXPECT_EQ(decimal(read("1/3"), 5), "0.33333");
  EXPECT_EQ(decimal(read("2/3"), 5), "0.66667");
  EXPECT_EQ(decimal(read("0.125000000000000000000000000001"), 2), "0.13");
  EXPECT_EQ(decimal(read("0.5"), 0), "0");
  EXPECT_EQ(decimal(read("1.5"), 0), "2");
  EXPECT_EQ(decimal(read("0.9999"), 3), "1.000");
  EXPECT_EQ(decimal(read("1234.5"), 3), "1234.500");
  EXPECT_EQ(decimal(Rational(-1, 3), 2), "-0.33");
  EXPECT_EQ(decimal(Rational(-1, 1000), 2), "0.00");
}

// All fractions with small terms against integer arithmetic: |10^d n/m - printed| is at most 1/2.
TEST(Rational, DecimalsAreNeverOffByMoreThanHalfAUnit) {
  for (int n = 0; n <= 60; ++n)
    for (int m = 1; m <= 60; ++m) {
      Rational value(n, m);
      value.canonicalize();
      Rational off = abs(value - read(decimal(value, 3))) * 1000;
      EXPECT_LE(off, Rational(1, 2));
    }
}

}  // namespace
}  // namespace heed::sim
