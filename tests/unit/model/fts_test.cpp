#include <gtest/gtest.h>
#include <heed/model/fts.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>
#include <heed/util/random.h>

#include <algorithm>
#include <filesystem>

namespace heed::model {
namespace {

const std::filesystem::path regress = std::filesystem::path(HEED_SOURCE_DIR) / "tests/regress/model";

/// Names instead of indices, so that what was read can be compared with what the file says.
std::string describe(const Fts& fts, const Fts::Transition& t) {
  return fts.states[t.from] + " -" + fts.actions[t.action] + "-> " + fts.states[t.to];
}

void expect_equal(const Fts& a, const Fts& b) {
  EXPECT_EQ(a.states, b.states);
  EXPECT_EQ(a.actions, b.actions);
  EXPECT_EQ(a.initial, b.initial);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.values, b.values);
  ASSERT_EQ(a.transitions.size(), b.transitions.size());
  for (std::size_t i = 0; i < a.transitions.size(); ++i)
    EXPECT_EQ(describe(a, a.transitions[i]), describe(b, b.transitions[i]));
}

Fts read(const std::string& text) {
  return read_fts(util::SourceText("car.fts", text));
}

TEST(Fts, ReadsEveryItem) {
  const Fts fts = read(
      "# a door\nlabel passable: open # held or not\r\nstates:closed open\n\n  initial :  open closed\n"
      "value gap : closed = -1 open=90\nlabel never:\nclosed-push->open\nclosed -wait-> closed\n"
      "open -release-> open\nopen -release-> closed");
  EXPECT_EQ(fts.name, "car.fts");
  EXPECT_EQ(fts.states, (std::vector<std::string>{"closed", "open"}));
  EXPECT_EQ(fts.actions, (std::vector<std::string>{"push", "wait", "release"}));
  EXPECT_EQ(fts.initial, (std::vector<std::uint32_t>{1, 0}));
  ASSERT_EQ(fts.labels.size(), 2U);
  EXPECT_EQ(fts.labels[0].second, (std::vector<bool>{false, true}));
  EXPECT_EQ(fts.labels[1].second, (std::vector<bool>{false, false}));
  ASSERT_EQ(fts.values.size(), 1U);
  EXPECT_EQ(fts.values[0].second, (std::vector<std::int32_t>{-1, 90}));
  EXPECT_EQ(fts.successors(1, 2), (std::vector<std::uint32_t>{0, 1})) << "ascending";
  EXPECT_TRUE(fts.successors(0, 2).empty());
  EXPECT_FALSE(fts.deterministic());
  EXPECT_EQ(to_string(fts.transitions[0].location), "car.fts:8:1");
}

TEST(Fts, ReadsTheRegressionFilesAndWritesThemBack) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(regress)) {
    if (entry.path().extension() != ".fts") continue;
    const util::SourceText source = util::read_file(entry.path().string());
    const Fts fts = read_fts(source);
    const std::string expected = "# expect: " + std::to_string(fts.states.size()) + " states, " +
                                 std::to_string(fts.actions.size()) + " actions, " +
                                 std::to_string(fts.transitions.size()) + " transitions, " +
                                 (fts.deterministic() ? "deterministic" : "nondeterministic") + "\n";
    EXPECT_TRUE(source.text().starts_with(expected)) << entry.path() << ": " << expected;
    expect_equal(read(write_fts(fts)), fts);
    EXPECT_EQ(write_fts(read(write_fts(fts))), write_fts(fts));
    ++files;
  }
  EXPECT_GE(files, 3);
}

Fts random_fts(std::uint64_t seed) {
  util::CounterRandom random(seed, 3);
  const std::uint32_t count = 1 + random.below(8);
  std::string text = "states:", initial = "initial:", labels = "label l:", values = "value v:", edges;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string state = "s" + std::to_string(i);
    text += ' ' + state;
    if (i == 0 || random.below(3) == 0) initial += ' ' + state;
    if (random.below(2) == 0) labels += ' ' + state;
    values += ' ' + state + '=' + std::to_string(static_cast<std::int32_t>(random()));
    std::vector<std::string> targets;
    for (std::uint32_t k = 1 + random.below(3); k > 0; --k) {
      const std::string target =
          "-a" + std::to_string(random.below(3)) + "-> s" + std::to_string(random.below(count));
      if (std::find(targets.begin(), targets.end(), target) == targets.end()) targets.push_back(target);
    }
    for (const std::string& target : targets) edges += state + ' ' + target + '\n';
  }
  return read(text + '\n' + initial + '\n' + labels + '\n' + values + '\n' + edges);
}

TEST(Fts, RandomSystemsReadBack) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Fts fts = random_fts(seed);
    expect_equal(read(write_fts(fts)), fts);
    // deterministic() against the definition, through successors().
    bool deterministic = true;
    for (std::uint32_t state = 0; state < fts.states.size(); ++state)
      for (std::uint32_t action = 0; action < fts.actions.size(); ++action)
        deterministic = deterministic && fts.successors(state, action).size() <= 1;
    EXPECT_EQ(fts.deterministic(), deterministic);
  }
}

/// Files whose first line is `# expect: CODE LINE:COLUMN | part of message or hint`.
TEST(Fts, RefusesFlawedFiles) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(regress / "flawed")) {
    if (entry.path().extension() != ".fts") continue;
    const std::string text = util::read_file(entry.path().string()).text();
    const std::size_t line_end = text.find('\n'), bar = text.find(" | ");
    ASSERT_TRUE(text.starts_with("# expect: ") && bar < line_end) << entry.path();
    try {
      (void)read_fts(util::SourceText("f", text));
      ADD_FAILURE() << entry.path() << " was accepted";
    } catch (const util::InputError& error) {
      const util::Diagnostic& found = error.diagnostic();
      EXPECT_EQ(found.code + " " + to_string(found.location).substr(2), text.substr(10, bar - 10))
          << error.what();
      EXPECT_NE((found.message + "; " + found.hint).find(text.substr(bar + 3, line_end - bar - 3)),
                std::string::npos)
          << error.what();
    }
    ++files;
  }
  EXPECT_GE(files, 18);
}

TEST(Fts, SurvivesRandomBytes) {
  const std::string alphabet = "ab:=->#- \n\tstatesinitiallabelvalue9\xff";
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    util::CounterRandom random(seed, 6);
    std::string text = seed % 2 == 0 ? "states: a\ninitial: a\n" : "";
    for (std::uint32_t i = random.below(20); i > 0; --i)
      text += alphabet[random.below(static_cast<std::uint32_t>(alphabet.size()))];
    try {
      const Fts fts = read(text);
      expect_equal(read(write_fts(fts)), fts);
    } catch (const util::InputError&) {
    }
  }
}

}  // namespace
}  // namespace heed::model
