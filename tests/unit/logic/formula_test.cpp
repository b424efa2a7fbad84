#include <gtest/gtest.h>
#include <heed/logic/formula.h>
#include <heed/logic/nodes.h>
#include <heed/util/random.h>

#include <thread>
#include <unordered_set>

namespace heed::logic {
namespace {

const Formula a = name("a"), b = name("b"), c = name("c");

TEST(Formula, DefaultIsTrue) {
  EXPECT_TRUE(Formula().is_true());
  EXPECT_EQ(Formula(), truth(true));
  EXPECT_EQ(Formula(), Formula::make(Op::True, {}));
  EXPECT_EQ(Formula().hash(), Formula::make(Op::True, {}).hash());
  EXPECT_FALSE(truth(false).is_true());
}

TEST(Formula, MovedFromIsAValue) {
  Formula source = a && b;
  const Formula target = std::move(source);
  EXPECT_TRUE(source.is_true());  // NOLINT(bugprone-use-after-move): that is what is tested
  EXPECT_EQ(target.op(), Op::And);
}

TEST(Formula, EqualityIsStructural) {
  EXPECT_EQ(a && next(b), name("a") && next(name("b")));
  EXPECT_FALSE((a && b) == (b && a));
  EXPECT_FALSE(name("a") == name("b"));
  EXPECT_FALSE(number(1) == number(2));
  EXPECT_FALSE(always(a) == eventually(a));
  EXPECT_EQ(Formula::make_name("a", {nullptr, 3, 4}), a) << "a location takes no part";
}

// Written down once: a change would reorder everything that follows hashes, and so what heed writes.
TEST(Formula, HashIsTheSameInEveryRun) {
  EXPECT_EQ(name("red").hash(), name("red").hash());
  EXPECT_NE(name("red").hash(), name("der").hash());
  EXPECT_NE((a && b).hash(), (b && a).hash());
  EXPECT_NE(number(-1).hash(), number(1).hash());
}

TEST(Formula, BuildersSimplifyConstants) {
  const Formula yes = truth(true), no = truth(false);
  EXPECT_EQ(!yes, no);
  EXPECT_EQ(!!a, a);
  EXPECT_EQ(a && yes, a);
  EXPECT_EQ(a && no, no);
  EXPECT_EQ(a || no, a);
  EXPECT_EQ(a || yes, yes);
  EXPECT_EQ(implies(yes, a), a);
  EXPECT_EQ(implies(no, a), yes);
  EXPECT_EQ(implies(a, no), !a);
  EXPECT_EQ(implies(a, yes), yes);
  EXPECT_EQ(iff(a, no), !a);
  EXPECT_EQ(iff(yes, a), a);
  EXPECT_EQ(next(yes), yes);
  EXPECT_EQ(always(no), no);
  EXPECT_EQ(all_of({}), yes);
  EXPECT_EQ(any_of({}), no);
  EXPECT_EQ(compare(Op::Lt, number(1), number(2)), yes);
  EXPECT_EQ(compare(Op::Ge, number(1), number(2)), no);
}

TEST(Formula, BuildersFlattenAndDropNeighbours) {
  const Formula flat = (a && b) && (b && c);
  ASSERT_EQ(flat.op(), Op::And);
  EXPECT_EQ(flat.operands().size(), 3U);
  EXPECT_EQ(any_of({a, a, a}), a);
  EXPECT_EQ(any_of({a, b, a}).operands().size(), 3U);
}

Formula chain(int length, Op op) {
  Formula formula = name("a");
  for (int i = 0; i < length; ++i) formula = Formula::make(op, {formula});
  return formula;
}

TEST(Formula, LongChainsAreReleasedComparedAndListed) {
  Formula one = chain(100'000, Op::Next);
  const Formula other = chain(100'000, Op::Next);
  EXPECT_EQ(one, other);
  EXPECT_EQ(postorder(one).size(), 100'001U);
  one = Formula();
  EXPECT_EQ(other.op(), Op::Next);
}

TEST(Formula, SharedPartsOutliveTheirParents) {
  Formula shared = chain(1'000, Op::Not);
  {
    const Formula parent = Formula::make(Op::And, {shared, shared, name("b")});
    EXPECT_EQ(parent[0].identity(), parent[1].identity());
  }
  EXPECT_EQ(postorder(shared).size(), 1'001U);
}

TEST(Formula, EqualityOfSharedGraphsIsNotExponential) {
  const auto doubled = [] {
    Formula formula = name("a");
    for (int i = 0; i < 200; ++i) formula = Formula::make(Op::And, {formula, formula});
    return formula;
  };
  const Formula one = doubled(), other = doubled();
  EXPECT_EQ(one, other);
  EXPECT_EQ(postorder(one).size(), 201U);
}

TEST(Formula, PostorderListsOperandsFirst) {
  const Formula root = implies(a && b, a || !b);
  std::unordered_set<const void*> seen;
  for (const Formula& node : postorder(root)) {
    for (const Formula& operand : node.operands()) EXPECT_TRUE(seen.contains(operand.identity()));
    EXPECT_TRUE(seen.insert(node.identity()).second);
  }
  EXPECT_EQ(postorder(root).back().identity(), root.identity());
}

TEST(Formula, PostorderListsConstantsToo) {
  const Formula root = Formula::make(Op::And, {Formula(), a, Formula(), Formula::make(Op::Not, {Formula()})});
  const std::vector<Formula> nodes = postorder(root);
  ASSERT_EQ(nodes.size(), 4U);
  EXPECT_EQ(nodes[0], Formula());
  EXPECT_EQ(nodes[1], a);
  EXPECT_EQ(nodes[3], root);
  EXPECT_EQ(postorder(Formula()).size(), 1U);
}

TEST(Formula, TwoThreadsMayDropTheSameFormula) {
  for (int round = 0; round < 20; ++round) {
    Formula one = chain(20'000, Op::Always);
    Formula other = one;
    std::thread first([&one] { one = Formula(); });
    std::thread second([&other] { other = Formula(); });
    first.join();
    second.join();
    EXPECT_TRUE(one.is_true() && other.is_true());
  }
}

TEST(Formula, KnowsWhetherANextStandsBelow) {
  EXPECT_FALSE(Formula().has_next());
  EXPECT_FALSE((a && !b).has_next());
  EXPECT_TRUE(next(a).has_next());
  EXPECT_TRUE(implies(a, b || !next(a)).has_next());
  EXPECT_TRUE(compare(Op::Lt, a, next(b)).has_next());
}

TEST(Nodes, ListOperandsByPlace) {
  const Formula both = a && b;
  const Formula root = implies(both, next(both) || a);
  const Nodes nodes(root);
  ASSERT_EQ(nodes.size(), 6U);
  EXPECT_EQ(nodes[5].identity(), root.identity());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ASSERT_EQ(nodes.operands(i).size(), nodes[i].operands().size());
    for (std::size_t k = 0; k < nodes.operands(i).size(); ++k) {
      EXPECT_LT(nodes.operands(i)[k], i);
      EXPECT_EQ(nodes[nodes.operands(i)[k]].identity(), nodes[i][k].identity());
    }
  }
  EXPECT_EQ(Nodes(Formula()).size(), 1U);
  EXPECT_TRUE(Nodes(Formula()).operands(0).empty());
}

}  // namespace
}  // namespace heed::logic
