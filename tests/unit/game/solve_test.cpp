#include <heed/game/solve.h>
#include <heed/logic/parse.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>

#include <gtest/gtest.h>

namespace heed::game {
namespace {

bool wins(const std::string& text) {
  const spec::Gr1 spec = spec::read_gr1(util::SourceText("test.gr1", text));
  util::Budget budget;
  const Game game = build_game(spec, budget);
  const Region region = solve(game, budget);
  SolveOptions early;
  early.stop_early = true;
  EXPECT_EQ(solve(game, budget, early).realizable, region.realizable) << text;
  for (const std::string& technique : technique_names()) {
    SolveOptions other;
    const bool off_by_default = technique == "greedy-schedule";
    set_technique(other.techniques, technique,
                  technique == "cluster-nodes" ? "0"
                  : off_by_default             ? "on"
                                               : "off");
    EXPECT_EQ(solve(game, budget, other).winning, region.winning) << "without " << technique << "\n" << text;
  }
  return region.realizable;
}

std::string options(const std::string& timing, const std::string& initial = "forall-exists") {
  return "[options]\ntiming = " + timing + "\ninitial = " + initial + "\n";
}

// Whoever sees the other's choice first can follow it.
TEST(Solve, MealySeesTheInputAndMooreDoesNot) {
  const std::string copy = "[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\ny' <-> x'\n";
  const std::string late = "[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\ny' <-> x\n";
  EXPECT_TRUE(wins(options("mealy") + copy));
  EXPECT_FALSE(wins(options("moore") + copy));
  EXPECT_TRUE(wins(options("mealy") + late));
  EXPECT_TRUE(wins(options("moore") + late));
}

// y would have to foretell x.
TEST(Solve, NobodyForetells) {
  const std::string foretell = "[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\ny <-> x'\n";
  EXPECT_FALSE(wins(options("mealy") + foretell));
  EXPECT_FALSE(wins(options("moore") + foretell));
}

TEST(Solve, WhoeverCannotMoveHasLost) {
  const std::string goal = "[sys justice]\nfalse\n";
  const std::string io = "[input]\nx : boolean\n[output]\ny : boolean\n";
  EXPECT_TRUE(wins(io + "[env safety]\ny -> x' & !x'\n" + goal)) << "the system can stop the environment";
  EXPECT_FALSE(wins(io + "[env safety]\nx -> x' & !x'\n" + goal)) << "the environment need not stop itself";
  EXPECT_FALSE(wins(io + "[sys safety]\nx -> y' & !y'\n")) << "the environment can stop the system";
  EXPECT_TRUE(wins(io + "[env init]\n!x\n[env safety]\n!x'\n[sys safety]\nx -> y' & !y'\n"));
}

// Breaking safety loses even where the environment never meets its justice.
TEST(Solve, SafetyIsNotExcusedByJustice) {
  const std::string text =
      "[input]\nx : boolean\n[output]\ny : boolean\n[env justice]\nfalse\n[sys safety]\ny' <-> !y'\n";
  EXPECT_FALSE(wins(text));
  EXPECT_TRUE(wins("[input]\nx : boolean\n[env justice]\nx\n[sys justice]\nx\n"));
  EXPECT_FALSE(wins("[input]\nx : boolean\n[sys justice]\nx\n"));
}

// The start: y follows x, or is the same for all x, or is anything, or somebody is kind.
TEST(Solve, InitialQuantifiers) {
  const std::string io = "[input]\nx : boolean\n[output]\ny : boolean\n[sys init]\n";
  const auto start = [&](const std::string& quantifiers, const std::string& formula) {
    return wins(options("mealy", quantifiers) + io + formula + "\n");
  };
  EXPECT_TRUE(start("forall-exists", "x <-> y"));
  EXPECT_FALSE(start("exists-forall", "x <-> y"));
  EXPECT_TRUE(start("exists-forall", "x | y"));
  EXPECT_FALSE(start("forall-exists", "x & y"));
  EXPECT_TRUE(start("exists-exists", "x & y"));
  EXPECT_FALSE(start("exists-exists", "x & !x"));
  const std::string chooses_well = "x | !x\n[sys safety]\ny -> y' & !y'";
  EXPECT_TRUE(start("forall-exists", chooses_well));
  EXPECT_TRUE(start("exists-forall", chooses_well));
  EXPECT_FALSE(start("forall-forall", chooses_well)) << "y may start true, and then there is no next step";
  EXPECT_TRUE(start("forall-forall", "!y\n[sys safety]\ny -> y' & !y'\n!y'"));
}

TEST(Solve, ArithmeticOverSmallRanges) {
  const std::string counter = "[input]\nup : boolean\n[output]\nn : -3..4\n";
  EXPECT_TRUE(wins(counter + "[sys safety]\nup' -> n' = n + 1 | n = 4 & n' = -3\n"));
  EXPECT_FALSE(wins(counter + "[sys safety]\nup' -> n' = n + 1\n"));
  EXPECT_TRUE(
      wins(counter + "[sys safety]\nn' * n' <= 9 & 2 * n' - 1 >= -7\n[sys justice]\nn = 3\nn = -3\n"));
  EXPECT_FALSE(wins(counter + "[sys justice]\nn * n > 16\n"));
}

TEST(Solve, EnumerationsAndMemories) {
  const std::string lights =
      "[input]\nask : boolean\n[output]\nlight : {red, green}\n"
      "[memory]\nwaited : boolean = false\nwaited' = ask & light = red\n"
      "@plant place : {far, mid, near} = far\n"
      "place' = mid when place = far & light = green\nplace' = near when place = mid & light = green\n"
      "place' = far when place = near\n"
      "[define]\nred := light = red & ask\n";
  EXPECT_TRUE(wins(lights + "[sys justice]\nplace = near\n!waited\n"));
  EXPECT_FALSE(wins(lights + "[sys safety]\nlight = red\n[sys justice]\nplace = near\n"));
  EXPECT_FALSE(
      wins(lights + "[sys safety]\nred <-> X waited\nplace' != place\nplace = far -> light = red\n"));
}

TEST(Solve, RanksCoverTheWinningStates) {
  const spec::Gr1 spec = spec::read_gr1(util::SourceText(
      "test.gr1", "[output]\nn : 0..9\n[sys safety]\nn' <= n + 1\n[sys justice]\nn = 0\nn = 9\n"));
  util::Budget budget;
  const Game game = build_game(spec, budget);
  SolveOptions keep;
  keep.ranks = true;
  const Region region = solve(game, budget, keep);
  ASSERT_TRUE(region.realizable);
  ASSERT_EQ(region.ranks.size(), 2U);
  EXPECT_EQ(region.ranks[0].back(), region.winning);
  EXPECT_EQ(region.ranks[0].size(), 2U) << "from anywhere to 0 in one step";
  EXPECT_EQ(region.ranks[1].size(), 10U) << "nine steps from 0 to 9";
  EXPECT_EQ(region.winning.count(4), 10.0);
}

TEST(Solve, StepsAreBounded) {
  const spec::Gr1 spec = spec::read_gr1(util::SourceText(
      "test.gr1", "[output]\nn : 0..9\n[sys safety]\nn' <= n + 1\n[sys justice]\nn = 0\nn = 9\n"));
  util::Budget budget;
  const Game game = build_game(spec, budget);
  SolveOptions few;
  few.max_steps = 3;
  EXPECT_FALSE(solve(game, budget, few).complete);
  EXPECT_TRUE(solve(game, budget).complete);
  budget.cancel();
  EXPECT_THROW((void)solve(game, budget), util::LimitExceeded);
}

TEST(BuildGame, RefusesWhatMayNotStandThere) {
  spec::Gr1 spec;
  spec.inputs.push_back({"x", model::Domain::boolean(), {}, {}});
  spec.outputs.push_back({{"y", model::Domain::boolean(), {}, {}}, model::OutputRole::Output});
  const auto refused = [&](std::vector<spec::Clause> spec::Gr1::*part, const std::string& text) {
    spec::Gr1 bad = spec;
    (bad.*part).push_back({logic::parse(text), {}, {}});
    util::Budget budget;
    EXPECT_THROW((void)build_game(bad, budget), util::InputError) << text;
  };
  refused(&spec::Gr1::env_init, "y");
  refused(&spec::Gr1::env_safety, "y'");
  refused(&spec::Gr1::sys_init, "y'");
  refused(&spec::Gr1::sys_safety, "X X y");
  refused(&spec::Gr1::sys_safety, "G y");
  refused(&spec::Gr1::sys_safety, "z");
  refused(&spec::Gr1::sys_justice, "y = 9223372036854775807 * 9223372036854775807 * 2");
}

TEST(BuildGame, DepthIsNoMatter) {
  spec::Gr1 spec;
  spec.outputs.push_back({{"y", model::Domain::boolean(), {}, {}}, model::OutputRole::Output});
  logic::Formula deep = logic::name("y");
  for (int i = 0; i < 10'000; ++i) deep = logic::Formula::make(logic::Op::Not, {deep});
  spec.sys_safety.push_back({deep, {}, {}});
  util::Budget budget;
  EXPECT_TRUE(solve(build_game(spec, budget), budget).realizable);
}

}  // namespace
}  // namespace heed::game
