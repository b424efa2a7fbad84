#include <heed/util/diagnostic.h>

#include <gtest/gtest.h>

namespace heed::util {
namespace {

TEST(Nearest, FindsSlips) {
  const std::vector<std::string> words{"red", "octagon", "sign", "stop_sign"};
  EXPECT_EQ(nearest("rde", words), "red");
  EXPECT_EQ(nearest("Red", words), "red");
  EXPECT_EQ(nearest("otcagon", words), "octagon");
  EXPECT_EQ(nearest("sgin", words), "sign");
  EXPECT_EQ(nearest("stopsign", words), "stop_sign");
  EXPECT_EQ(nearest("yellow", words), "");
}

TEST(Nearest, KnowsTheEmptyWord) {
  EXPECT_EQ(nearest("", {"a"}), "a");
  EXPECT_EQ(nearest("word", {}), "");
}

TEST(Suggestion, ListsWhereNothingIsNear) {
  EXPECT_EQ(suggestion("zzz", {"red", "sign"}), "known: red, sign");
  EXPECT_EQ(suggestion("zzz", {"a1", "b1", "c1"}, 2), "known: a1, b1, ...");
}

TEST(Message, HasPositionCodeExcerptAndHint) {
  const SourceText source("f.txt", "one\ntwo three\n");
  const InputError error(source, 8, "bad-word", "unknown word", "write 'four'");
  EXPECT_STREQ(error.what(),
               "f.txt:2:5: error: unknown word [bad-word]\n  two three\n      ^\nhint: write 'four'");
}

TEST(Source, CountsLinesFromItsPlaceInTheFile) {
  const SourceText source("s.toml", "ab\ncd", 7, 10);
  EXPECT_EQ(to_string(source.at(1)), "s.toml:7:11");
  EXPECT_EQ(to_string(source.at(3)), "s.toml:8:1");
  EXPECT_EQ(source.line_of(4), "cd");
}

}  // namespace
}  // namespace heed::util
