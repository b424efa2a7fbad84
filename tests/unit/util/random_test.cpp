#include <heed/util/random.h>

#include <gtest/gtest.h>

#include <vector>

namespace heed::util {
namespace {

// Known answers of Philox 4x32-10 from the generator's own test vectors.
TEST(Philox, GivesItsKnownAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t f = 0xffffffff;
  EXPECT_EQ(philox({f, f, f, f}, {f, f}),
            (std::array<std::uint32_t, 4>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (std::array<std::uint32_t, 4>{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(CounterRandom, StreamsAreIndependentOfOneAnother) {
  CounterRandom a(1, 7), b(1, 7), c(1, 8);
  bool differs = false;
  for (int i = 0; i < 100; ++i) {
    const std::uint32_t word = a();
    EXPECT_EQ(word, b());
    differs = differs || word != c();
  }
  EXPECT_TRUE(differs);
}

TEST(CounterRandom, BelowIsUniform) {
  CounterRandom random(3, 0);
  std::vector<int> counts(6, 0);
  for (int i = 0; i < 60'000; ++i) ++counts[random.below(6)];
  for (const int count : counts) EXPECT_NEAR(count, 10'000, 500);
}

TEST(CounterRandom, UniformIsInTheHalfOpenInterval) {
  CounterRandom random(5, 0);
  double sum = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
  }
  EXPECT_NEAR(sum / 100'000, 0.5, 0.01);
}

}  // namespace
}  // namespace heed::util
