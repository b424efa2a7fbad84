#include <gtest/gtest.h>
#include <heed/util/word_table.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

namespace heed::util {
namespace {

using Word = std::vector<std::uint32_t>;

TEST(WordTable, NumbersInTheOrderOfDiscovery) {
  WordTable table(2);
  EXPECT_EQ(table.find(std::array{1U, 2U}), WordTable::none);
  EXPECT_EQ(table.number(std::array{1U, 2U}), std::pair(0U, true));
  EXPECT_EQ(table.number(std::array{2U, 1U}), std::pair(1U, true));
  EXPECT_EQ(table.number(std::array{1U, 2U}), std::pair(0U, false));
  EXPECT_EQ(table.find(std::array{2U, 1U}), 1U);
  EXPECT_EQ(table.letters(), (Word{1, 2, 2, 1}));
}

TEST(WordTable, HoldsOneWordWithoutLetters) {
  WordTable table(0);
  EXPECT_EQ(table.number(std::span<const std::uint32_t>()), std::pair(0U, true));
  EXPECT_EQ(table.number(std::span<const std::uint32_t>()), std::pair(0U, false));
}

/// Few different letters, so that many words repeat; against an ordered map.
TEST(WordTable, NumbersLikeAMap) {
  for (const std::size_t length : {1U, 3U, 7U}) {
    std::mt19937 random(static_cast<unsigned>(length));
    WordTable table(length);
    std::map<Word, std::uint32_t> reference;
    for (int i = 0; i < 20'000; ++i) {
      Word word(length);
      for (std::uint32_t& letter : word)
        letter = static_cast<std::uint32_t>(random() % (length == 1 ? 9000 : 5));
      const auto [place, added] = reference.try_emplace(word, static_cast<std::uint32_t>(reference.size()));
      ASSERT_EQ(table.number(std::span<const std::uint32_t>(word)), std::pair(place->second, added));
    }
    ASSERT_EQ(table.size(), reference.size());
    for (const auto& [word, number] : reference)
      ASSERT_TRUE(std::ranges::equal(table[number], word)) << "length " << length;
  }
}

TEST(WordTable, TellsWhatGrowingTakesAtOnce) {
  WordTable table(2);
  EXPECT_EQ(table.bytes_to_grow(32), 0U);
  for (std::uint32_t i = 0; i < 32; ++i) table.number(std::array{i, i});
  EXPECT_GE(table.bytes_to_grow(1), 32 * 2 * sizeof(std::uint32_t));
  EXPECT_EQ(bytes_to_grow(table.letters(), 0), 0U);
}

}  // namespace
}  // namespace heed::util
