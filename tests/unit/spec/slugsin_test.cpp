#include "unit/spec/formula_value.h"

#include <heed/spec/slugsin.h>

#include <fmt/format.h>

#include <random>

namespace heed::spec {
namespace {

using test::Values;

Gr1 read(const std::string& text) {
  return read_slugsin(util::SourceText("test.slugsin", text));
}

const std::string head = "[INPUT]\na\nb\n[OUTPUT]\nc\nd\n";

/// A random line and, by its definition, its value; `block` has the values of the innermost block so far.
struct Line {
  std::mt19937 random;
  Values now, next;

  bool write(std::string& text, int depth, const std::vector<bool>* block) {
    const int kind = static_cast<int>(random() % (depth > 0 ? 9 : 4));
    const std::vector<std::string> names{"a", "b", "c", "d"};
    if (kind < 2) {
      const std::string& name = names[random() % 4];
      const bool primed = random() % 2 == 0;
      text += name + (primed ? "' " : " ");
      return (primed ? next : now).at(name) != 0;
    }
    if (kind == 2 && block != nullptr && !block->empty()) {
      const std::size_t i = random() % block->size();
      text += fmt::format("? {} ", i);
      return (*block)[i];
    }
    if (kind < 4) {
      const bool value = random() % 2 == 0;
      text += value ? "1 " : "0 ";
      return value;
    }
    if (kind == 8) return write_block(text, depth);
    if (kind == 7) {
      text += "! ";
      return !write(text, depth - 1, block);
    }
    text += kind == 4 ? "& " : kind == 5 ? "| " : "^ ";
    const bool left = write(text, depth - 1, block), right = write(text, depth - 1, block);
    return kind == 4 ? left && right : kind == 5 ? left || right : left != right;
  }

  bool write_block(std::string& text, int depth) {
    const std::size_t size = 1 + random() % 4;
    text += fmt::format("$ {} ", size);
    std::vector<bool> values;
    for (std::size_t i = 0; i < size; ++i) values.push_back(write(text, depth - 1, &values));
    return values.back();
  }
};

TEST(Slugsin, lines_have_the_value_of_their_definition) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    Line line{std::mt19937(seed), {}, {}};
    for (const char* name : {"a", "b", "c", "d"}) {
      line.now[name] = line.random() % 2;
      line.next[name] = line.random() % 2;
    }
    std::string text;
    const bool expected = line.write(text, 6, nullptr);
    const Gr1 spec = read(head + "[SYS_TRANS]\n" + text + "\n[SYS_LIVENESS]\n" + text);
    bool all = true;
    for (const Clause& clause : spec.sys_safety)
      all = all && test::value_of(clause.formula, line.now, line.next) != 0;
    ASSERT_EQ(all, expected) << text;
    ASSERT_EQ(test::value_of(spec.sys_justice.at(0).formula, line.now, line.next) != 0, expected) << text;
  }
}

TEST(Slugsin, blocks_stay_shared) {
  std::string line = "$ 2001 a ";
  for (int i = 0; i < 2000; ++i) line += fmt::format("^ ? {} ^ b ? {} ", i, i);
  const Gr1 spec = read(head + "[SYS_LIVENESS]\n" + line);
  EXPECT_LT(logic::postorder(spec.sys_justice[0].formula).size(), 10'000U);
  const std::string written = write_slugsin(spec);
  EXPECT_LT(written.size(), 100'000U);
  EXPECT_LT(logic::postorder(read(written).sys_justice[0].formula).size(), 10'000U);
}

TEST(Slugsin, long_chains_are_no_nesting_and_deep_lines_are_refused) {
  std::string chain, deep;
  for (int i = 0; i < 200'000; ++i) chain += "& ";
  for (int i = 0; i <= 200'000; ++i) chain += i % 2 == 0 ? "a " : "b ";
  EXPECT_EQ(read(head + "[SYS_TRANS]\n" + chain).sys_safety.size(), 200'001U);
  for (int i = 0; i < 100'000; ++i) deep += "! ";
  EXPECT_EQ(test::refusal([&] { (void)read(head + "[SYS_TRANS]\n" + deep + "a"); }), "too-deep 8:20001");
  EXPECT_EQ(test::refusal([&] { (void)read(head + "[SYS_TRANS]\n" + deep.substr(0, 19'998) + "a"); }), "");
}

TEST(Slugsin, constraints_of_steps_say_nothing_of_a_state_that_is_never_left) {
  const Gr1 spec = read(head + "[SYS_TRANS]\n! c\n& c d'\n[ENV_TRANS]\na\n1\n[SYS_INIT]\n& c ! d\n");
  ASSERT_EQ(spec.sys_safety.size(), 3U);
  EXPECT_EQ(spec.sys_safety[0].formula.op(), logic::Op::And);
  EXPECT_EQ(spec.sys_safety[0].formula[1].op(), logic::Op::Next);
  EXPECT_EQ(spec.sys_safety[2].formula.op(), logic::Op::Next);
  EXPECT_EQ(spec.sys_safety[1].text, "c");
  EXPECT_EQ(spec.env_safety.size(), 1U);
  EXPECT_EQ(spec.sys_init.size(), 2U);
}

TEST(Slugsin, flaws_are_told_with_their_place) {
  const std::vector<test::Flaw> flaws{{"a\n", "no-section 1:1"},
                                      {"[INPUTS]\n", "unknown-section 1:1"},
                                      {"[INPUT]\na b\n", "name 2:1"},
                                      {"[INPUT]\n  a'\n", "name 2:3"},
                                      {"[INPUT]\n&\n", "name 2:1"},
                                      {"[INPUT]\na\n[OUTPUT]\na\n", "duplicate-name 4:1"},
                                      {head + "[SYS_TRANS]\n| a\n", "syntax 8:4"},
                                      {head + "[SYS_TRANS]\n| a b c\n", "syntax 8:7"},
                                      {head + "[SYS_TRANS]\n| a e\n", "unknown-name 8:5"},
                                      {head + "[ENV_TRANS]\n| a c'\n", "not-allowed-here 8:5"},
                                      {head + "[ENV_INIT]\n! c\n", "not-allowed-here 8:3"},
                                      {head + "[SYS_INIT]\n! c'\n", "not-allowed-here 8:3"},
                                      {head + "[SYS_TRANS]\n$ 2 a ? 1\n", "not-yet-known 8:7"},
                                      {head + "[SYS_TRANS]\n$ 0\n", "empty-block 8:1"},
                                      {head + "[SYS_TRANS]\n$ x\n", "number 8:3"},
                                      {head + "[SYS_TRANS]\n? 0\n", "no-block 8:1"},
                                      {head + "[SYS_TRANS]\n$ 2 $ 1 ? 0 a\n", "not-yet-known 8:9"}};
  for (const test::Flaw& flaw : flaws)
    EXPECT_EQ(test::refusal([&] { (void)read(flaw.text); }), flaw.refusal) << flaw.text;
}

}  // namespace
}  // namespace heed::spec
