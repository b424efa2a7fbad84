#include "lasso.h"

#include <gtest/gtest.h>
#include <heed/logic/parse.h>
#include <heed/logic/rewrite.h>

namespace heed::logic {
namespace {

std::optional<Formula> d_is_a_or_b(const std::string& name) {
  if (name == "D") return parse("a | b");
  return std::nullopt;
}

TEST(Substitute, ReplacesBelowEveryOperator) {
  EXPECT_EQ(to_string(substitute(parse("G (D -> X D) & D' & c"), d_is_a_or_b)),
            "G (a | b -> X (a | b)) & X (a | b) & c");
  const Formula untouched = parse("G (a -> X b)");
  EXPECT_EQ(substitute(untouched, d_is_a_or_b).identity(), untouched.identity());
}

TEST(PushNext, LeavesPrimesOnNamesOnly) {
  EXPECT_EQ(to_string(push_next(parse("X (a & !X b -> x + 1 = y')"))), "a' & !b'' -> x' + 1 = y''");
  EXPECT_EQ(to_string(push_next(parse("X (true & 3 = x)"))), "true & 3 = x'");
}

TEST(PushNext, KeepsTheMeaning) {
  const std::vector<Op> operators{Op::Next, Op::Not, Op::And, Op::Or, Op::Implies, Op::Iff};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    util::CounterRandom random(seed, 5);
    const Formula formula = test::random_formula(random, 5, 3, operators);
    const Formula pushed = push_next(formula);
    for (const Formula& node : postorder(pushed)) {
      EXPECT_TRUE(node.op() != Op::Next || node[0].op() == Op::Name || node[0].op() == Op::Next);
    }
    for (int i = 0; i < 20; ++i) {
      const test::Lasso word = test::random_word(random, 3);
      ASSERT_EQ(test::satisfies(formula, word, 1), test::satisfies(pushed, word, 1)) << to_string(formula);
    }
  }
}

TEST(NamesOf, TellsCurrentFromPrimed) {
  const Names names = names_of(parse("a & X (b | a) & x' = y & G c"));
  EXPECT_EQ(names.current, (std::set<std::string>{"a", "c", "y"}));
  EXPECT_EQ(names.primed, (std::set<std::string>{"a", "b", "x"}));
}

TEST(IsPropositional, CountsLevelsOfNext) {
  EXPECT_TRUE(is_propositional(parse("a & x = 1 -> b")));
  EXPECT_FALSE(is_propositional(parse("a & X b")));
  EXPECT_TRUE(is_propositional(parse("a & X b & x' = x"), true));
  EXPECT_FALSE(is_propositional(parse("X (a & X b)"), true));
  EXPECT_FALSE(is_propositional(parse("x'' = x"), true));
  EXPECT_FALSE(is_propositional(parse("a & F b"), true));
  EXPECT_FALSE(is_propositional(parse("a & Y b"), true));
}

TEST(Rewrite, WalksDeepFormulas) {
  Formula deep = name("a");
  for (int i = 0; i < 50'000; ++i) deep = Formula::make(Op::Not, {deep});
  EXPECT_EQ(postorder(substitute(deep, [](const std::string&) { return name("b"); })).size(), 50'001U);
  EXPECT_EQ(postorder(push_next(next(deep))).size(), 50'002U);
  EXPECT_EQ(names_of(deep).current.size(), 1U);
  EXPECT_TRUE(is_propositional(deep));
}

}  // namespace
}  // namespace heed::logic
