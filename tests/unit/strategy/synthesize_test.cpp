#include <heed/spec/text.h>
#include <heed/strategy/synthesize.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace heed::strategy {
namespace {

using model::Mealy;
using model::Valuation;

spec::Gr1 specification(const std::string& text) {
  return spec::read_gr1(util::SourceText("test.gr1", text));
}

Result result(const std::string& text, const Options& options = {}) {
  util::Budget budget;
  return synthesize(specification(text), budget, options);
}

/// The outputs of \p machine along \p inputs.
std::vector<Valuation> run(const Mealy& machine, const std::vector<Valuation>& inputs) {
  std::vector<Valuation> outputs;
  std::uint32_t state = 0;
  for (const Valuation& input : inputs) {
    const auto letter = machine.input_letter(input);
    const auto* row = letter ? machine.find(state, *letter) : nullptr;
    if (row == nullptr) break;
    outputs.push_back(machine.output_letters[row->output]);
    state = row->next;
  }
  return outputs;
}

TEST(Synthesize, FollowsTheInputInOneState) {
  const Result found = result("[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\nx <-> y\n");
  ASSERT_TRUE(found.machine);
  EXPECT_EQ(found.machine->state_count(), 1U);
  EXPECT_EQ(run(*found.machine, {{0}, {1}, {1}}), (std::vector<Valuation>{{0}, {1}, {1}}));
  EXPECT_FALSE(found.relies_on_broken_justice);
}

TEST(Synthesize, ColumnsAreOutputsMemoriesDefinitions) {
  const Result found = result(
      "[input]\nx : boolean\n[output]\ny : 0..2\n[memory]\nm : boolean = true\nm' = x\n"
      "[define]\nd := x & m\n[sys safety]\ny' = 2 <-> m\n");
  ASSERT_TRUE(found.machine);
  const Mealy& machine = *found.machine;
  ASSERT_EQ(machine.outputs.size(), 3U);
  EXPECT_EQ(machine.outputs[0].variable.name, "y");
  EXPECT_EQ(machine.outputs[1].variable.name, "m");
  EXPECT_EQ(machine.outputs[2].variable.name, "d");
  const auto steps = run(machine, {{1}, {1}});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0], (Valuation{0, 1, 1}));
  EXPECT_EQ(steps[1], (Valuation{2, 1, 1}));
}

/// Clients ask until they are served; at most one is served at a time.
std::string arbiter(int clients) {
  std::string in = "[input]\n", out = "[output]\n", assume = "[env safety]\n", safe = "[sys safety]\n",
              goal = "[sys justice]\n";
  for (int i = 0; i < clients; ++i) {
    in += fmt::format("r{} : boolean\n", i);
    out += fmt::format("g{} : boolean\n", i);
    assume += fmt::format("r{0} & !g{0} -> r{0}'\n", i);
    safe += fmt::format("g{0} -> r{0}\n", i);
    goal += fmt::format("r{0} -> g{0}\n", i);
    for (int k = 0; k < i; ++k) safe += fmt::format("!(g{} & g{})\n", i, k);
  }
  return in + out + assume + safe + goal;
}

TEST(Synthesize, ArbitersServeEveryClient) {
  for (int clients = 2; clients <= 6; ++clients) {
    const Result found = result(arbiter(clients));
    ASSERT_TRUE(found.machine) << clients;
    const Valuation all(static_cast<std::size_t>(clients), 1);
    std::vector<int> served(static_cast<std::size_t>(clients));
    const auto steps =
        run(*found.machine, std::vector<Valuation>(4 * static_cast<std::size_t>(clients), all));
    ASSERT_EQ(steps.size(), 4 * served.size());
    for (const Valuation& step : steps)
      for (std::size_t i = 0; i < served.size(); ++i) served[i] += step[i];
    for (const int times : served) EXPECT_GE(times, 3) << clients;
  }
}

TEST(Synthesize, ArbiterWithoutMutualExclusionOverGoalsThatExclude) {
  std::string unfair = arbiter(2);
  unfair += "g0 & r1\n[sys safety]\nr1 -> g1\n";
  EXPECT_FALSE(result(unfair).realizable);
}

// The environment may run into a dead end: a state without rows, and a win.
TEST(Synthesize, DeadlockOfTheEnvironment) {
  const Result found = result(
      "[input]\nask : boolean\n[output]\ndone : boolean\n[env init]\n!ask\n[env safety]\nask -> !ask'\n!ask "
      "-> ask'\n"
      "done -> ask'\n[sys safety]\nask -> done\n[sys justice]\nfalse\n");
  ASSERT_TRUE(found.machine);
  bool dead_end = false;
  for (std::uint32_t s = 0; s < found.machine->state_count(); ++s)
    dead_end = dead_end || found.machine->first[s] == found.machine->first[s + 1];
  EXPECT_TRUE(dead_end);
}

TEST(Synthesize, SaysWhenItWaitsForABrokenAssumption) {
  EXPECT_TRUE(result("[input]\nx : boolean\n[env justice]\nx\n[sys justice]\nx\n").relies_on_broken_justice);
  EXPECT_FALSE(result("[input]\nx : boolean\n[output]\ny : boolean\n[env justice]\nx\n[sys justice]\ny\n")
                   .relies_on_broken_justice);
}

TEST(Synthesize, MooreAnswersTheSameWhateverComes) {
  const Result found = result(
      "[options]\ntiming = moore\ninitial = exists-forall\n[input]\nx : boolean\n[output]\ny : boolean\n"
      "[sys safety]\ny' <-> !x\n[define]\nboth := x & y\n");
  ASSERT_TRUE(found.machine);
  const auto steps = run(*found.machine, {{1}, {1}, {0}, {1}});
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[1][0], 0);
  EXPECT_EQ(steps[2][0], 0);
  EXPECT_EQ(steps[3], (Valuation{1, 1}));
}

TEST(Synthesize, OnlyAskedGivesNoMachine) {
  Options asked;
  asked.only_realizability = true;
  const Result found = result(arbiter(3), asked);
  EXPECT_TRUE(found.realizable);
  EXPECT_FALSE(found.machine);
  EXPECT_FALSE(result("[input]\nx : boolean\n[sys safety]\nx\n", asked).counter);
}

TEST(Synthesize, TooManyStatesIsALimit) {
  Options few;
  few.max_states = 3;
  EXPECT_THROW((void)result(arbiter(4), few), util::LimitExceeded);
}

// Forty inputs that hardly matter: their letters would never all be met.
TEST(Synthesize, AutoGivesUpListingManyLetters) {
  std::string text = "[input]\n";
  for (int i = 0; i < 40; ++i) text += fmt::format("i{} : boolean\n", i);
  text += "[output]\ny : boolean\n[sys safety]\ny' <-> i0 | i1\n[sys justice]\ny | !i0\n";
  Options automatic;
  automatic.form = Form::Auto;
  automatic.auto_rows = 1000;
  const Result found = result(text, automatic);
  EXPECT_TRUE(found.realizable);
  EXPECT_FALSE(found.machine);
  EXPECT_TRUE(found.symbolic);
}

TEST(Synthesize, AutoGivesUpListingAfterManySteps) {
  Options automatic;
  automatic.form = Form::Auto;
  EXPECT_TRUE(result(arbiter(6), automatic).machine);
  automatic.auto_steps = 1000;
  EXPECT_TRUE(result(arbiter(6), automatic).symbolic);
  automatic.form = Form::Explicit;
  EXPECT_TRUE(result(arbiter(6), automatic).machine);
}

TEST(Synthesize, AssumptionsThatGrowTogetherStayApart) {
  Options symbolic;
  symbolic.form = Form::Symbolic;
  EXPECT_EQ(result(arbiter(4), symbolic).symbolic->legal.size(), 1U);
  symbolic.legal_nodes = 0;
  EXPECT_EQ(result(arbiter(4), symbolic).symbolic->legal.size(), 4U);
  Options apart;
  apart.legal_nodes = 0;
  EXPECT_EQ(*result(arbiter(4), apart).machine, *result(arbiter(4)).machine);
  EXPECT_EQ(result("[input]\na : boolean\n[output]\ny : boolean\n", symbolic).symbolic->legal.size(), 0U);
}

TEST(Synthesize, SameInputSameMachine) {
  EXPECT_EQ(model::write_mealy(*result(arbiter(4)).machine), model::write_mealy(*result(arbiter(4)).machine));
}

// Nothing disappears from view: what does is answered as if it were still there.
TEST(Latch, AnswersEveryObservation) {
  Options latch;
  latch.on_violation = OnViolation::Latch;
  const std::string text =
      "[input]\na : boolean\nb : boolean\n[output]\ny : boolean\n[env init]\n!a & !b\n[env safety]\na -> "
      "a'\nb -> b'\n"
      "[sys safety]\ny <-> a & b\n";
  EXPECT_EQ(result(text).machine->find(0, 0)->fallback, false);
  const Mealy machine = *result(text, latch).machine;
  ASSERT_EQ(machine.input_letters.size(), 4U);
  for (std::uint32_t s = 0; s < machine.state_count(); ++s)
    EXPECT_EQ(machine.first[s + 1] - machine.first[s], 4U) << "state " << s;
  EXPECT_EQ(run(machine, {{0, 0}, {1, 0}, {0, 1}, {0, 0}}), (std::vector<Valuation>{{0}, {0}, {1}, {1}}));
  EXPECT_TRUE(machine.find(0, *machine.input_letter({1, 1}))->fallback)
      << "nothing was seen: the first legal letter";
  EXPECT_EQ(run(machine, {{1, 1}, {1, 0}}), (std::vector<Valuation>{{0}, {0}}));
}

// Where keeping what was seen is illegal too, the last observation is repeated.
TEST(Latch, FallsBackToTheLastObservation) {
  Options latch;
  latch.on_violation = OnViolation::Latch;
  const Mealy machine =
      *result(
           "[input]\nlane : {none, left, right}\nx : boolean\n[output]\ny : {none, left, right}\n"
           "[env init]\nlane = left & !x\n[env safety]\nlane' = lane\n!x\n[sys safety]\ny = lane\n",
           latch)
           .machine;
  EXPECT_EQ(run(machine, {{1, 0}, {0, 0}, {2, 0}, {1, 1}, {1, 0}}),
            (std::vector<Valuation>{{1}, {1}, {1}, {1}, {1}}));
}

}  // namespace
}  // namespace heed::strategy
