#include <gtest/gtest.h>
#include <heed/util/diagnostic.h>

#include "../src/sim/onset.h"

namespace heed::sim {
namespace {

OnsetExpression read(const std::string& text) {
  return parse_onset({"t", text});
}

std::string error_at(const std::string& text) {
  try {
    (void)read(text);
  } catch (const util::InputError& error) {
    return error.diagnostic().code + "@" + std::to_string(error.diagnostic().location.column);
  }
  return "fine";
}

/// The value for a = 3, b = 5, "min" = 7, sign.on = never.
std::int64_t value(const std::string& text) {
  const auto resolved = resolve(read(text), {"a", "b", "min", "sign.on"});
  const OnsetRange range = resolved.evaluate({{3, 3}, {5, 5}, {7, 7}, {infinite, infinite}});
  EXPECT_TRUE(range.known());
  return range.low;
}

TEST(Onset, Values) {
  EXPECT_EQ(value("4"), 4);
  EXPECT_EQ(value(" a+1 "), 4);
  EXPECT_EQ(value("a - 1 - 1 + 10"), 11);
  EXPECT_EQ(value("a - 4"), -1);
  EXPECT_EQ(value("min(a, b, 1)"), 1);
  EXPECT_EQ(value("max(2, min(a, b) + 1)"), 4);
  EXPECT_EQ(value("((b))"), 5);
  EXPECT_EQ(value("(a + 1) - 2"), 2);
  EXPECT_EQ(value("min(a)"), 3);
  EXPECT_EQ(value("\"min\" + 1"), 8);
  EXPECT_EQ(value("never"), infinite);
  EXPECT_EQ(value("never - 5"), infinite);
  EXPECT_EQ(value("sign.on + 1"), infinite);
  EXPECT_EQ(value("min(never, a)"), 3);
}

TEST(Onset, RangesWhileAnOnsetLiesAhead) {
  const std::vector<OnsetRange> known = {{2, 2}, {4, infinite}};
  const auto range = [&](const std::string& text) {
    const OnsetRange r = resolve(read(text), {"a", "b"}).evaluate(known);
    return std::pair(r.low, r.high);
  };
  EXPECT_EQ(range("min(a, b) + 1"), std::pair(std::int64_t{3}, std::int64_t{3}));
  EXPECT_EQ(range("max(a, b)"), std::pair(std::int64_t{4}, infinite));
  EXPECT_EQ(range("b - 1"), std::pair(std::int64_t{3}, infinite));
  EXPECT_EQ(range("min(b, 5)"), std::pair(std::int64_t{4}, std::int64_t{5}));
}

TEST(Onset, RefusesWithPosition) {
  EXPECT_EQ(error_at(""), "bad-onset@1");
  EXPECT_EQ(error_at("-1"), "bad-onset@1");
  EXPECT_EQ(error_at("a +"), "bad-onset@4");
  EXPECT_EQ(error_at("a + b"), "bad-onset@5");
  EXPECT_EQ(error_at("a b"), "bad-onset@3");
  EXPECT_EQ(error_at("min a"), "bad-onset@5");
  EXPECT_EQ(error_at("min(a"), "bad-onset@6");
  EXPECT_EQ(error_at("min(a,)"), "bad-onset@7");
  EXPECT_EQ(error_at("(a, b)"), "bad-onset@3");
  EXPECT_EQ(error_at("a)"), "bad-onset@2");
  EXPECT_EQ(error_at("\"a"), "bad-onset@1");
  EXPECT_EQ(error_at("1.5"), "bad-onset@2");
  EXPECT_EQ(error_at("99999999999999999999"), "bad-onset@1");
  EXPECT_EQ(error_at("1000001"), "bad-onset@1");
}

TEST(Onset, DeepNestingIsReadAndDeeperNestingRefused) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '(') + "a" + std::string(depth, ')');
  };
  EXPECT_EQ(value(nested(10'000)), 3);
  EXPECT_EQ(error_at(nested(100'000)), "bad-onset@10002");
  std::string mins;
  for (int i = 0; i < 9'000; ++i) mins += "min(b, ";
  EXPECT_EQ(value(mins + "a" + std::string(9'000, ')')), 3);
}

}  // namespace
}  // namespace heed::sim
