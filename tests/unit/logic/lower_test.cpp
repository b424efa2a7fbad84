#include "lasso.h"

#include <gtest/gtest.h>
#include <heed/logic/lower.h>
#include <heed/logic/parse.h>
#include <heed/logic/rewrite.h>
#include <heed/util/diagnostic.h>

#include <optional>

namespace heed::logic {
namespace {

std::string describe(const Lowered& lowered) {
  std::string out;
  for (const Formula& f : lowered.init) out += "\n  init " + to_string(f);
  for (const Formula& f : lowered.safety) out += "\n  safety " + to_string(f);
  for (const Formula& f : lowered.justice) out += "\n  justice " + to_string(f);
  for (const Monitor& m : lowered.monitors)
    out += "\n  " + m.name + " := " + (m.initial ? "true" : "false") + ", " + to_string(m.update) + "  # " +
           m.remembers;
  return out;
}

std::string describe(const test::Lasso& word) {
  std::string out;
  for (std::size_t i = 0; i < word.letters.size(); ++i) {
    if (i == word.loop) out += "(";
    out += std::to_string(word.letters[i]) + " ";
  }
  return out + ")";
}

/// The first word on which the requirement and its parts differ.
::testing::AssertionResult agrees(const Formula& requirement, const Lowered& lowered,
                                  const std::vector<test::Lasso>& words) {
  for (const test::Lasso& word : words) {
    const bool expected = test::satisfies(requirement, word);
    if (expected != test::satisfies(lowered, word))
      return ::testing::AssertionFailure()
             << to_string(requirement) << (expected ? " holds" : " fails") << " on " << describe(word)
             << ", its parts do not:" << describe(lowered);
  }
  return ::testing::AssertionSuccess();
}

void expect_well_formed(const Lowered& lowered) {
  std::set<std::string> monitors;
  for (const Monitor& monitor : lowered.monitors) EXPECT_TRUE(monitors.insert(monitor.name).second);
  const auto check = [&](const Formula& f, bool next_allowed) {
    EXPECT_TRUE(is_propositional(f, next_allowed)) << to_string(f);
    for (const std::string& primed : names_of(f).primed)
      EXPECT_FALSE(monitors.contains(primed)) << to_string(f);
  };
  for (const Formula& f : lowered.init) {
    check(f, false);
    for (const std::string& current : names_of(f).current) EXPECT_FALSE(monitors.contains(current));
  }
  for (const Formula& f : lowered.safety) check(f, true);
  for (const Formula& f : lowered.justice) check(f, true);
  for (const Monitor& monitor : lowered.monitors) check(monitor.update, false);
}

class Accepted : public ::testing::TestWithParam<const char*> {};

TEST_P(Accepted, HasTheSameWords) {
  const Formula requirement = parse(GetParam());
  const Lowered lowered = lower(requirement);
  expect_well_formed(lowered);
  EXPECT_TRUE(agrees(requirement, lowered, test::all_words(2, 2, 2)));
  std::vector<test::Lasso> words;
  util::CounterRandom random(7, 1);
  for (int i = 0; i < 800; ++i) words.push_back(test::random_word(random, 3));
  EXPECT_TRUE(agrees(requirement, lowered, words));
}

INSTANTIATE_TEST_SUITE_P(Plain, Accepted,
                         ::testing::Values("a", "a -> b", "X a", "a & X X b", "G a", "G (a -> X b)",
                                           "G (a -> X X b)", "G (a -> b & X X X c)", "G X X a", "GF a",
                                           "GF (a & X b)", "GF X X a", "F a", "F (a & X b)",
                                           "G a & GF b & (a | b)", "true", "false", "G false", "F G F a",
                                           "G G a", "X G a", "X X F a", "X GF a", "X (a U b)"));

INSTANTIATE_TEST_SUITE_P(Past, Accepted,
                         ::testing::Values("G (a -> Y b)", "G (a -> O b)", "G (H a | b)", "G (c -> a S b)",
                                           "GF (a & Y b)", "G X (a S X b)", "G (Y X a -> b)", "O a | H b",
                                           "a S b", "X (a S b)", "G (O X X a -> b)", "GF O X a",
                                           "F (a & O b)", "G (a -> Y Y (b S c))", "G H a",
                                           "G (X H a | Y true)"));

INSTANTIATE_TEST_SUITE_P(
    Reactive, Accepted,
    ::testing::Values("G (a -> F b)", "G (a -> X F b)", "G (a -> F (b & X c))", "a U b", "a W b", "a R b",
                      "G (a -> b W c)", "G (a -> b U c)", "G (a -> b R c)", "G (a -> G b)", "G (a -> GF b)",
                      "a -> G b", "a -> F b", "F a -> G b", "G a | G b", "G a | GF b", "GF a | GF b",
                      "F (a & F b)", "F (a & F (b & F c))", "F (a & X F b)", "F (a & (b U c))", "(a W b) W c",
                      "(a U (b U c)) | G c", "a U (b U c)", "a W (b U c)", "a W (b & F c)", "X (a U (b U c))",
                      "a U (b & X (c U a))", "G (a -> X (b U c))", "G (a -> G b | F c)",
                      "G (a -> (b W c) | F c)", "G (a -> X (b W c) | F b)", "GF (a & F b)",
                      "G F (a & F (b & F c))", "!(a U b)", "!(a W b)", "!(a R b)", "!(G a -> F b)",
                      "G (a -> G b | G c)", "G (a -> GF b | F c)", "G (a <-> X b) | F c", "F a <-> b",
                      "F (a & F b & F c)", "G (F a | G b)", "X F (a & F b)", "a -> X F (b & F c)",
                      "F (a & GF b)", "G (a -> (F b & G c))"));

// The patterns of Dwyer, Avrunin and Corbett in the scopes that have deterministic monitors; c ends the
// scope, or begins it.
INSTANTIATE_TEST_SUITE_P(Patterns, Accepted,
                         ::testing::Values("G !a", "F c -> (!a U c)", "G (c -> G !a)",
                                           "G (b & !c & F c -> (!a U c))", "G (b & !c -> (!a W c))", "F a",
                                           "!c W (a & !c)", "G !c | F (c & F a)",
                                           "G (b & !c -> (!c W (a & !c)))", "G (b & !c -> (!c U (a & !c)))",
                                           "F c -> (a U c)", "G (b & !c & F c -> (a U c))", "!a W b",
                                           "F c -> (!a U (b | c))", "G (b & !c & F c -> (!a U (b | c)))",
                                           "G (b & !c -> (!a W (b | c)))",
                                           "F c -> (a -> (!c U (b & !c))) U c", "G (c -> G (a -> F b))",
                                           "G (b & !c & F c -> (a -> (!c U (b & !c))) U c)",
                                           "G (b & !c -> ((a -> (!c U (b & !c))) W c))"));

TEST(Lower, KeepsWhatIsGr1AsItWasWritten) {
  const Lowered lowered = lower(parse("G (a -> X b) & GF (a & X b) & (a | b) & G (x = 1 -> x' > x + 1)"));
  EXPECT_TRUE(lowered.monitors.empty());
  ASSERT_EQ(lowered.safety.size(), 2U);
  EXPECT_EQ(to_string(lowered.safety[0]), "a -> b'");
  EXPECT_EQ(to_string(lowered.safety[1]), "x = 1 -> x' > x + 1");
  ASSERT_EQ(lowered.justice.size(), 1U);
  EXPECT_EQ(to_string(lowered.justice[0]), "a & b'");
  ASSERT_EQ(lowered.init.size(), 1U);
  EXPECT_EQ(to_string(lowered.init[0]), "a | b");
}

TEST(Lower, NeedsOneMonitorForAResponse) {
  const Lowered lowered = lower(parse("G (a -> F b)"), {"wait_"});
  ASSERT_EQ(lowered.monitors.size(), 1U);
  EXPECT_EQ(lowered.monitors[0].name, "wait_1");
  EXPECT_EQ(lowered.justice.size(), 1U);
  EXPECT_TRUE(lowered.safety.empty());
}

TEST(Lower, LooksBackAtComparisonsOfAStep) {
  const Lowered lowered = lower(parse("G (a -> X X (x' = x))"));
  ASSERT_EQ(lowered.safety.size(), 1U);
  EXPECT_NE(to_string(lowered.safety[0]).find("x' = x"), std::string::npos);
  const Lowered back = lower(parse("G (x' = x | X X a)"));
  EXPECT_TRUE(std::any_of(back.monitors.begin(), back.monitors.end(),
                          [](const Monitor& m) { return to_string(m.update) == "x' = x"; }));
  EXPECT_THROW((void)lower(parse("G x'' = x")), util::InputError);
}

struct Refusal {
  const char* text;
  const char* subformula;
  std::uint32_t column;
};

class Refused : public ::testing::TestWithParam<Refusal> {};

TEST_P(Refused, NamesTheSubformula) {
  try {
    (void)lower(parse(GetParam().text));
    FAIL() << GetParam().text << " was accepted";
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "not-gr1");
    EXPECT_NE(error.diagnostic().message.find(GetParam().subformula), std::string::npos) << error.what();
    EXPECT_EQ(error.diagnostic().location.column, GetParam().column) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(All, Refused,
                         ::testing::Values(Refusal{"G a & F G b", "F G b", 7},
                                           Refusal{"GF a -> GF b", "F G !a", 1},
                                           Refusal{"G (a -> O F b)", "O F b", 9},
                                           Refusal{"G (a -> F (b & F c))", "F (b & F c)", 9},
                                           Refusal{"G (a -> F G b)", "F G b", 9},
                                           Refusal{"a W F G b", "F", 1},
                                           Refusal{"a U (b U c | G c)", "G c", 1}));

TEST(Lower, AgreesWithTheLogicOnRandomFormulas) {
  const std::vector<Op> operators{Op::Not,   Op::And,       Op::Or,           Op::Implies, Op::Iff,
                                  Op::Next,  Op::Next,      Op::Always,       Op::Always,  Op::Eventually,
                                  Op::Until, Op::WeakUntil, Op::Release,      Op::Since,   Op::Previous,
                                  Op::Once,  Op::Always,    Op::Historically, Op::And,     Op::Or};
  const std::vector<test::Lasso> small = test::all_words(2, 1, 2);
  int accepted = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    util::CounterRandom random(seed, 2);
    const unsigned propositions = seed % 2 == 0 ? 2 : 3;
    const Formula requirement =
        test::random_formula(random, 1 + static_cast<int>(seed % 5), propositions, operators);
    std::optional<Lowered> lowered;
    try {
      lowered = lower(requirement);
    } catch (const util::InputError& error) {
      EXPECT_EQ(error.diagnostic().code, "not-gr1");
      ++refused;
      continue;
    }
    ++accepted;
    expect_well_formed(*lowered);
    std::vector<test::Lasso> words = propositions == 2 ? small : std::vector<test::Lasso>{};
    for (int i = 0; i < 40; ++i) words.push_back(test::random_word(random, propositions));
    ASSERT_TRUE(agrees(requirement, *lowered, words)) << "seed " << seed;
  }
  RecordProperty("accepted", accepted);
  RecordProperty("refused", refused);
  EXPECT_GT(accepted, 900) << refused << " refused";
}

TEST(Lower, SurvivesDeepNesting) {
  Formula deep = name("a");
  for (int i = 0; i < 10'000; ++i)
    deep = Formula::make(i % 2 == 0 ? Op::Always : Op::Not, {Formula::make(Op::Not, {deep})});
  EXPECT_NO_THROW({
    try {
      (void)lower(deep);
    } catch (const util::InputError&) {
    }
  });
  Formula past = name("a");
  for (int i = 0; i < 10'000; ++i) past = Formula::make(Op::Once, {name("b") && past});
  EXPECT_EQ(lower(always(past)).monitors.size(), 10'000U);
}

}  // namespace
}  // namespace heed::logic
