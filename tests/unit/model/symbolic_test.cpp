#include <heed/model/symbolic.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>

#include <string>

namespace heed::model {
namespace {

std::string page_example() {
  const std::string page = util::read_file(std::string(HEED_SOURCE_DIR) + "/docs/formats/symbolic.md").text();
  const std::size_t begin = page.find("```json\n") + 8;
  return page.substr(begin, page.find("```", begin) - begin);
}

SymbolicController read(const std::string& text) {
  return read_symbolic(util::SourceText("test.symbolic.json", text));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
  try {
    (void)read(text);
  } catch (const util::InputError& error) {
    return error.diagnostic().message;
  }
  return "";
}

TEST(Symbolic, ThePagesExampleReadsAndIsWrittenAsItIs) {
  const std::string example = page_example();
  EXPECT_TRUE(is_symbolic(util::SourceText("example", example)));
  const SymbolicController controller = read(example);
  EXPECT_EQ(write_symbolic(controller), example);
  EXPECT_EQ(read(write_symbolic(controller)), controller);
  ASSERT_EQ(controller.goals.size(), 1U);
  EXPECT_EQ(controller.outputs.front().role, OutputRole::Action);
}

TEST(Symbolic, AControllerFileIsNone) {
  EXPECT_FALSE(is_symbolic(util::SourceText("explicit", "{\"heed\": \"controller\"}")));
}

/// ((a ? b : !b) as nodes 1, 2) and its negation, on all four assignments.
TEST(Symbolic, FunctionsAreEvaluatedThroughComplements) {
  Diagrams diagrams;
  diagrams.order = {0, 1};
  diagrams.nodes = {{1, 1, 0}, {0, 3, 2}};
  for (const bool a : {false, true})
    for (const bool b : {false, true}) {
      EXPECT_EQ(evaluate(diagrams, 4, {a, b}), a == b);
      EXPECT_EQ(evaluate(diagrams, 5, {a, b}), a != b);
      EXPECT_EQ(evaluate(diagrams, 2, {a, b}), b);
      EXPECT_TRUE(evaluate(diagrams, function_true, {a, b}));
      EXPECT_FALSE(evaluate(diagrams, function_false, {a, b}));
    }
}

TEST(Symbolic, WidthsFollowTheDomain) {
  EXPECT_EQ(bit_width(Domain::boolean()), 1U);
  EXPECT_EQ(bit_width(Domain::integer(7, 7)), 0U);
  EXPECT_EQ(bit_width(Domain::integer(-1, 3)), 3U);
  EXPECT_EQ(bit_width(Domain::enumeration({"a", "b", "c", "d"})), 2U);
}

TEST(Symbolic, WhatBreaksARuleIsRefused) {
  const std::string good = page_example();
  EXPECT_EQ(complaint(good), "");
  EXPECT_NE(complaint(replaced(good, "[0, 1, 2, 3]", "[0, 1, 2]")), "") << "a bit without a level";
  EXPECT_NE(complaint(replaced(good, "[0, 1, 2, 3]", "[0, 1, 2, 2]")), "") << "a bit twice";
  EXPECT_NE(complaint(replaced(good, "[0, 1, 2, 3]", "[0, 1, 2, 4]")), "") << "no such bit";
  EXPECT_NE(complaint(replaced(good, " 1, 1, 0\n", " 1, 4, 0\n")), "") << "a node of itself";
  EXPECT_NE(complaint(replaced(good, " 1, 1, 0\n", " 1, 1, 3\n")), "") << "a negation";
  EXPECT_NE(complaint(replaced(good, " 1, 1, 0\n", " 1, 0, 0\n")), "") << "no choice";
  EXPECT_NE(complaint(replaced(good, " 1, 1, 0\n", " 1, 3, 2\n")), "") << "below a bit that is above";
  EXPECT_NE(complaint(replaced(good, " 1, 1, 0\n", " 1, 1\n")), "") << "two integers";
  EXPECT_NE(complaint(replaced(good, "[4]", "[6]")), "") << "no such function";
  EXPECT_NE(complaint(replaced(good, "[4]", "[4, 4]")), "") << "an answer too many";
  EXPECT_NE(complaint(replaced(good, "\"outputs\": [2]", "\"outputs\": []")), "") << "no first answer";
  EXPECT_NE(complaint(replaced(good, "[0, null]", "[0]")), "") << "a rank without its place";
  EXPECT_NE(complaint(replaced(good, "[0, null]", "[0, -1]")), "") << "no such assumption";
  EXPECT_NE(complaint(replaced(good, "\"winning\"", "\"wining\"")), "") << "an unknown key";
  EXPECT_NE(complaint(replaced(good, "\"version\": 1", "\"version\": 2")), "") << "another version";
  EXPECT_NE(complaint("[]"), "");
  EXPECT_NE(complaint("{"), "");
}

}  // namespace
}  // namespace heed::model
