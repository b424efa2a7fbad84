// Bad input through the program: every file under tests/regress/job/flawed says in its first line how the run
// must end, `# expect: exit N; part of the message; file[:line]`, `-` for a message without a place. A line
// `# options: ...` adds words to the command.
#include "workshop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace case_study {
namespace {

const fs::path flawed = fs::path(HEED_SOURCE_DIR) / "tests/regress/job/flawed";

struct Expected {
  int exit_code = 0;
  std::string message, place;
  bool hint = true;
  std::vector<std::string> options;
};

Expected expected_of(const std::string& path) {
  std::istringstream lines(read(path));
  std::string line, word;
  std::getline(lines, line);
  Expected expected;
  const std::string head = "# expect: exit ";
  EXPECT_TRUE(line.starts_with(head)) << path;
  std::istringstream parts(line.substr(head.size()));
  std::getline(parts, word, ';');
  expected.exit_code = std::stoi(word);
  std::getline(parts >> std::ws, expected.message, ';');
  std::getline(parts >> std::ws, expected.place, ';');
  if (std::getline(parts >> std::ws, word)) expected.hint = word != "no hint";
  std::getline(lines, line);
  if (line.starts_with("# options: ")) {
    std::istringstream options(line.substr(11));
    while (options >> word) expected.options.push_back(word);
  }
  return expected;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

void expect_one_message(const Said& said, const Expected& expected) {
  EXPECT_EQ(said.exit_code, expected.exit_code) << said.err;
  EXPECT_EQ(said.out, "");
  EXPECT_EQ(count(said.err, "error: "), 1U) << said.err;
  EXPECT_NE(said.err.find(expected.message), std::string::npos) << said.err;
  EXPECT_EQ(count(said.err, "hint: "), expected.hint ? 1U : 0U) << said.err;
  // Where it is: the first thing said, with a column where there is a line.
  const std::string first = said.err.substr(0, said.err.find("error: "));
  if (expected.place == "-") {
    EXPECT_EQ(first, "");
  } else {
    const std::size_t at = first.find(expected.place + ":");
    EXPECT_NE(at, std::string::npos) << "expected " << expected.place << " in: " << said.err;
    if (expected.place.find(':') != std::string::npos) {
      EXPECT_GE(count(first, ":"), 3U) << "no column: " << said.err;
    }
  }
  for (const char* trace : {"terminate", "what()", "Segmentation", "#0", "Sanitizer", ".cpp"})
    EXPECT_EQ(said.err.find(trace), std::string::npos) << said.err;
}

std::vector<std::string> inputs() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(flawed))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Flawed : public testing::TestWithParam<std::string> {};

TEST_P(Flawed, IsToldOnceAndLeavesNothing) {
  const std::string path = (flawed / (GetParam() + ".toml")).string();
  const Expected expected = expected_of(path);
  const Folder folder;
  std::vector<std::string> words{"run", path, "-o", folder.path("out")};
  words.insert(words.end(), expected.options.begin(), expected.options.end());
  const Said said = heed_says(words);
  if (expected.exit_code == 1) {
    EXPECT_EQ(said.exit_code, 1) << said.err;
    EXPECT_NE(said.out.find(expected.message), std::string::npos) << said.out;
    return;
  }
  expect_one_message(said, expected);
  EXPECT_TRUE(fs::is_empty(folder.path())) << "something was left behind";
}

INSTANTIATE_TEST_SUITE_P(Inputs, Flawed, testing::ValuesIn(inputs()), [](const auto& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(FlawedKnowledge, AnImpossibleSignIsShownButNotBuiltUpon) {
  const std::string path = (flawed / "unsatisfiable-sign.toml").string();
  for (const char* command : {"kb", "explain"}) {
    const Said said = heed_says({command, path});
    EXPECT_EQ(said.exit_code, 0) << command << said.err;
    EXPECT_NE((said.out + said.err).find("unsatisfiable-entity"), std::string::npos)
        << command << ": " << said.out << said.err;
  }
  expect_one_message(heed_says({"spec", path}), expected_of(path));
}

TEST(FlawedKnowledge, HundredThousandLevelsAreRefused) {
  const Example example;
  std::string text = "<?xml version=\"1.0\"?>\n<r xmlns=\"http://example.org/r\">";
  for (int i = 0; i < 100'000; ++i) text += "<r>";
  for (int i = 0; i < 100'000; ++i) text += "</r>";
  write(example.path("traffic-signs.owl"), text + "</r>\n");
  const Said said = heed_says({"run", example.scenario(), "-o", example.path("out")});
  Expected expected{2, "nest", "traffic-signs.owl", false, {}};
  expect_one_message(said, expected);
  EXPECT_FALSE(fs::exists(example.path("out")));
}

TEST(FlawedKnowledge, DeepFormulasAreReadOrRefused) {
  for (const std::size_t depth : {std::size_t{5'000}, std::size_t{100'000}}) {
    Example example;
    example.edit("stop-sign.toml", "\"GF location = 0\"",
                 "\"GF " + std::string(depth, '(') + "location = 0" + std::string(depth, ')') + "\"");
    const Said said = heed_says({"run", example.scenario(), "-o", example.path("out"), "--traces", "0"});
    if (depth < 10'000) {
      EXPECT_EQ(said.exit_code, 0) << said.err.substr(0, 300);
    } else {
      EXPECT_EQ(said.exit_code, 2) << said.err.substr(0, 300);
      EXPECT_FALSE(fs::exists(example.path("out")));
    }
  }
}

TEST(FlawedKnowledge, AMissingScenarioIsOneMessage) {
  const Folder folder;
  const Said said = heed_says({"run", folder.path("none.toml"), "-o", folder.path("out")});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(count(said.err, "error: "), 1U) << said.err;
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FlawedKnowledge, WithJsonTheMessageIsTheDocument) {
  const std::string path = (flawed / "unknown-root.toml").string();
  const Folder folder;
  const Said said = heed_says({"run", path, "-o", folder.path("out"), "--json"});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.err, "");
  for (const char* part : {"\"line\": 7", "\"hint\"", "Sign"})
    EXPECT_NE(said.out.find(part), std::string::npos) << said.out;
}

}  // namespace
}  // namespace case_study
