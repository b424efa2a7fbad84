#include <heed/game/explain.h>
#include <heed/spec/text.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heed::game {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

Defeat defeat(const std::string& text) {
  const spec::Gr1 spec = spec::read_gr1(util::SourceText("test.gr1", text));
  util::Budget budget;
  const Game game = build_game(spec, budget);
  SolveOptions options;
  options.iterates = true;
  const Region region = solve(game, budget, options);
  EXPECT_FALSE(region.realizable) << text;
  return explain(game, region, budget);
}

TEST(Explain, ConflictAtTheFirstStep) {
  const Defeat found = defeat(
      "[input]\nred : boolean\nsign : boolean\n[output]\nhalt : boolean\ngo : boolean\n"
      "[sys safety]\nred -> halt\nred & sign -> go\n!(halt & go)\nhalt | go\n");
  EXPECT_EQ(found.losing_initial, "red = true, sign = true");
  ASSERT_EQ(found.moves.size(), 2U);
  EXPECT_EQ(found.moves[0], "At the first step the environment gives red = true, sign = true.");
  EXPECT_EQ(found.moves[1], "No answer keeps 'red -> halt' and 'red & sign -> go' and '!(halt & go)'.");
  EXPECT_THAT(found.reasons, ElementsAre("red -> halt", "red & sign -> go", "!(halt & go)"));
}

// The answer that survives longest is taken, and the step that has none is named.
TEST(Explain, FollowsThePlayToItsEnd) {
  const Defeat found = defeat(
      "[input]\nx : boolean\n[output]\nn : 0..3\n[env init]\n!x\n[sys safety]\nx' -> n' < n\n!x' -> n' <= "
      "n\n");
  EXPECT_EQ(found.losing_initial, "x = false");
  ASSERT_EQ(found.moves.size(), 10U);
  EXPECT_EQ(found.moves[1], "The system holds out longest by answering n = 3.");
  EXPECT_EQ(found.moves[2], "Then the environment gives x = true.");
  EXPECT_EQ(found.moves[3], "The system holds out longest by answering n = 2.");
  EXPECT_THAT(found.reasons, ElementsAre("x' -> n' < n"));
}

// The same play as values, for whoever wants to tell it in other words.
TEST(Explain, GivesThePlayAsValues) {
  const Defeat found = defeat(
      "[input]\nx : boolean\n[output]\nn : 0..1\n[env init]\n!x\n[sys safety]\nx' -> n' < n\n!x' -> n' <= "
      "n\n");
  ASSERT_EQ(found.turns.size(), 3U);
  EXPECT_EQ(found.turns[0].observation, (Values{{"x", "false"}}));
  EXPECT_EQ(found.turns[0].answer, (Values{{"n", "1"}}));
  EXPECT_EQ(found.turns[1].answer, (Values{{"n", "0"}}));
  EXPECT_TRUE(found.turns[2].answer.empty());
  ASSERT_EQ(found.broken.size(), 1U);
  EXPECT_EQ(found.broken[0].text, "x' -> n' < n");
  EXPECT_FALSE(found.goal);
}

TEST(Explain, NamesTheGoalOutOfReach) {
  const Defeat found = defeat(
      "[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\ny' -> x'\ny' | !y\n[sys justice]\nx & "
      "y\n!y & !x\n");
  ASSERT_FALSE(found.moves.empty());
  EXPECT_THAT(found.moves.back(), HasSubstr("can still not meet"));
  EXPECT_EQ(found.reasons.size(), 1U);
}

TEST(Explain, MooreAnswersFirst) {
  const Defeat found = defeat(
      "[options]\ntiming = moore\ninitial = exists-forall\n"
      "[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\ny' <-> x'\n");
  ASSERT_GE(found.moves.size(), 3U);
  EXPECT_THAT(found.moves.back(), HasSubstr("No answer keeps"));
  EXPECT_THAT(found.reasons, ElementsAre("y' <-> x'"));
}

TEST(Explain, NoLegalStart) {
  const Defeat found =
      defeat("[options]\ninitial = exists-exists\n[input]\nx : boolean\n[env init]\nx & !x\n");
  EXPECT_EQ(found.losing_initial, "none: no first observation is legal");
}

TEST(Explain, ConflictsAreMinimal) {
  bdd::Manager manager;
  const bdd::Bdd a = manager.variable(manager.new_variable());
  const bdd::Bdd b = manager.variable(manager.new_variable());
  EXPECT_THAT(minimal_conflict({a | b, !a, a, b}), ElementsAre(1, 2));
  EXPECT_THAT(minimal_conflict({a | b, !a, b | a, !b}), ElementsAre(0, 1, 3));
}

}  // namespace
}  // namespace heed::game
