#include "../../../src/report/text_table.h"

#include <gtest/gtest.h>

#include <sstream>

#include "../../../src/report/format.h"

namespace heed::report {

namespace {

TEST(TextTable, AlignsByWhatATerminalShows) {
  TextTable table({{"name"}, {"n", TextTable::Align::Right}});
  table.add({"a→b", "1"});
  table.add({"止", "10,000"});
  table.add({"x"});
  EXPECT_EQ(table.render(80),
            "  name       n\n"
            "  ----  ------\n"
            "  a→b        1\n"
            "  止    10,000\n"
            "  x\n");
}

TEST(TextTable, EmptyWithoutRows) {
  EXPECT_EQ(TextTable({{"name"}}).render(80), "");
}

TEST(TextTable, TheWidestColumnGivesWay) {
  TextTable table({{"name", TextTable::Align::Left, 100}, {"n", TextTable::Align::Right}});
  table.add({std::string(60, 'x'), "12345"});
  std::istringstream stream(table.render(40));
  for (std::string line; std::getline(stream, line);) {
    EXPECT_LE(columns(line), 40u) << line;
    if (line.find('x') != std::string::npos) {
      EXPECT_TRUE(line.ends_with("12345")) << line;
    }
  }
}

TEST(Wrap, BreaksAtBlanksAndHangs) {
  EXPECT_EQ(wrap("one two three", 12, "- "), "- one two\n  three\n");
  EXPECT_EQ(wrap("", 12), "\n");
  EXPECT_EQ(wrap("misses 12 % of all", 10), "misses\n12 % of\nall\n");
}

/// Nothing is lost, nothing is too wide, whatever the width.
TEST(Wrap, KeepsEveryCharacter) {
  const std::string text = "G(sign & red -> stop_sign_recognised_by_the_awareness_controller) → halt → σ";
  for (std::size_t width = 8; width < 90; ++width) {
    const std::string wrapped = wrap(text, width);
    std::string joined;
    std::istringstream stream(wrapped);
    for (std::string line; std::getline(stream, line); joined += line) EXPECT_LE(columns(line), width);
    const auto bare = [](std::string s) { return std::erase(s, ' '), s; };
    EXPECT_EQ(bare(joined), bare(text)) << width;
  }
}

}  // namespace

}  // namespace heed::report
