#include <gtest/gtest.h>
#include <heed/report/write.h>
#include <heed/util/file.h>

#include <sstream>
#include <string>

#include "unit/report/sample.h"

namespace heed::report {

namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

/// Code points, counted apart from the writer: all labels of the sample are one column each.
std::size_t width(const std::string& line) {
  std::size_t count = 0;
  for (const char c : line)
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) ++count;
  return count;
}

/// The expected text below the line "---"; the head says what it is.
std::string golden(const std::string& name) {
  const std::string text = util::read_file(HEED_SOURCE_DIR "/tests/regress/report/" + name).text();
  return text.substr(text.find("\n---\n") + 5);
}

TEST(Text, LooksAsAgreed) {
  EXPECT_EQ(to_text(sample::result()), golden("stop-sign.txt"));
}

TEST(Text, ShowsTheTableOfTheCaseStudy) {
  const std::string text = to_text(sample::result());
  for (const char* figure :
       {"0.6250", "0.1875", "0.4063", "0.2969", "0.3750", "2/3", "129691/144000", "20111/288000",
        "19153/864000", "671/108000", "1/864", "631/800", "157/1200", "419/7200", "37/240", "11/120"})
    EXPECT_NE(text.find(figure), std::string::npos) << figure;
}

TEST(Text, StaysWithinItsWidth) {
  for (const std::size_t most : {60u, 72u, 100u})
    for (const bool details : {false, true})
      for (const std::string& line : lines(to_text(sample::result(), {details, most})))
        EXPECT_LE(width(line), most) << line;
}

TEST(Text, DetailsBringTheKnowledge) {
  EXPECT_EQ(to_text(sample::result()).find("because"), std::string::npos);
  const std::string text = to_text(sample::result(), {true, 100});
  EXPECT_NE(text.find("G(sign & red -> stop_sign_recognised)"), std::string::npos);
  EXPECT_NE(text.find("traffic-signs.owl:812"), std::string::npos);
}

TEST(Text, NothingSteersTheTerminal) {
  RunResult result = sample::result();
  result.scenario = "a\x1b[31mb\xC2\x9B";
  result.controllers[0].title = "first\nsecond\x1b]0;x\a";
  result.headline = {"tab\there \xff"};
  for (const char c : to_text(result, {true, 100}))
    EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << static_cast<int>(c);
  EXPECT_EQ(to_text(result).find("\xC2\x9B"), std::string::npos);
}

TEST(Text, EmptyResultIsShort) {
  RunResult result;
  result.scenario = "nothing";
  EXPECT_EQ(to_text(result), "nothing\n\nseed 0\n");
}

TEST(Text, RoadsTellWhatIsExpected) {
  const std::string text = to_text(sample::result());
  EXPECT_NE(text.find("Road: through town"), std::string::npos);
  EXPECT_NE(text.find("20 things passed one after another: nothing with probability 9/10"),
            std::string::npos);
  const auto row = text.find("P1       Awareness", text.find("Road: through town"));
  ASSERT_NE(row, std::string::npos);
  const std::string line = text.substr(row, text.find('\n', row) - row);
  for (const char* number : {"2.3333", "1.2500", "0.1167", "0.0625", "0.1250"})
    EXPECT_NE(line.find(number), std::string::npos) << line;
  EXPECT_NE(text.find("cells left"), std::string::npos);
}

}  // namespace

}  // namespace heed::report
