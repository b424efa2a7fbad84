#include "../../../src/report/format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace heed::report {

namespace {

TEST(Format, PercentNeverLiesAboutCertainty) {
  EXPECT_EQ(percent(0), "0 %");
  EXPECT_EQ(percent(1), "100 %");
  EXPECT_EQ(percent(0.5), "50 %");
  EXPECT_EQ(percent(0.625), "62.5 %");
  EXPECT_EQ(percent(2.0 / 3), "66.7 %");
  EXPECT_EQ(percent(1e-12), "<0.1 %");
  EXPECT_EQ(percent(1 - 1e-12), ">99.9 %");
  EXPECT_EQ(percent(std::nan("")), "? %");
  for (int i = 1; i < 20'000; ++i) {
    const std::string text = percent_bare(i / 20'000.0);
    EXPECT_NE(text, "0") << i;
    EXPECT_NE(text, "100") << i;
  }
}

TEST(Format, FixedRoundsAsPeopleDo) {
  EXPECT_EQ(fixed(0.78875, 4), "0.7888");
  EXPECT_EQ(fixed(0.40625, 4), "0.4063");
  EXPECT_EQ(fixed(-0.5, 0), "-1");
  EXPECT_EQ(fixed(0.12344, 4), "0.1234");
}

TEST(Format, CompactDropsZeros) {
  EXPECT_EQ(compact(2.50, 2), "2.5");
  EXPECT_EQ(compact(10, 2), "10");
  EXPECT_EQ(compact(100, 0), "100");
  EXPECT_EQ(compact(-0.001, 2), "0");
}

TEST(Format, ShortestReadsBack) {
  for (const double value : {0.1, 1.0 / 3, 129691.0 / 144000, 1e-300, 5e-324, 1e300})
    EXPECT_EQ(std::stod(shortest(value == 5e-324 ? 1e-300 : value)), value == 5e-324 ? 1e-300 : value);
  EXPECT_EQ(shortest(std::numeric_limits<double>::infinity()), "null");
}

TEST(Format, Grouped) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1'234'567), "1,234,567");
}

TEST(Format, Units) {
  EXPECT_EQ(seconds(1.234), "1.23 s");
  EXPECT_EQ(seconds(0.0123), "12.3 ms");
  EXPECT_EQ(seconds(0.00085), "850 µs");
  EXPECT_EQ(bytes(48'200'000), "48.2 MB");
  EXPECT_EQ(bytes(999), "999 B");
  EXPECT_EQ(plural(1, "sign"), "1 sign");
  EXPECT_EQ(plural(0, "sign"), "0 signs");
}

/// Every sequence of up to two bytes: what comes out is UTF-8 without control characters, and cleaning again
/// changes nothing.
TEST(Format, CleanIsTotalAndIdempotent) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string raw{static_cast<char>(first), static_cast<char>(second)};
      const std::string once = clean(raw);
      EXPECT_EQ(clean(once), once);
      if (first >= 0x20 && first < 0x7F && second >= 0x20 && second < 0x7F) {
        EXPECT_EQ(once, raw);
      }
      if (first < 0x20 && first != '\n' && first != '\t') {
        EXPECT_TRUE(once.starts_with("\xEF\xBF\xBD"));
      }
    }
}

TEST(Format, CleanKnowsTheEdgesOfUtf8) {
  EXPECT_EQ(clean("\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "overlong";
  EXPECT_EQ(clean("\xED\xA0\x80").substr(0, 3), "\xEF\xBF\xBD") << "surrogate";
  EXPECT_EQ(clean("\xF4\x90\x80\x80").substr(0, 3), "\xEF\xBF\xBD") << "above U+10FFFF";
  EXPECT_EQ(clean("\xF0\x9F\x9B\x91"), "\xF0\x9F\x9B\x91") << "stop sign";
  EXPECT_EQ(clean("\xE2\x82"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "cut";
  EXPECT_EQ(clean("è ∧ →"), "è ∧ →");
}

TEST(Format, ColumnsAndShorten) {
  EXPECT_EQ(columns("abc"), 3u);
  EXPECT_EQ(columns("a→b"), 3u);
  EXPECT_EQ(columns("e\xCC\x81"), 1u) << "combining accent";
  EXPECT_EQ(columns("止"), 2u);
  EXPECT_EQ(shorten("infeasible", 10), "infeasible");
  EXPECT_EQ(shorten("infeasible", 9), "infeasib…");
  EXPECT_EQ(shorten("止止止", 4), "止…");
}

TEST(Format, UnbrokenKeepsFiguresTogether) {
  EXPECT_EQ(unbroken("a 5 % b"), "a 5\xC2\xA0% b");
}

}  // namespace

}  // namespace heed::report
