#include <heed/export/runner.h>

#include <gtest/gtest.h>

#include "machines.h"

namespace heed::exporter {
namespace {

using namespace testing;

std::vector<Shape> shapes() {
  const std::vector<model::Output> outputs{{enumeration("action", {"go", "halt"}), OutputRole::Action},
                                           {integer("n", -2, 2), OutputRole::Output}};
  return {{"complete", {boolean("a"), integer("b", -3, 4)}, outputs, 7, 0, 0, 0},
          {"partial", {boolean("a"), enumeration("c", {"x", "y", "z"})}, outputs, 9, 0, 4, 3},
          {"few letters", {integer("a", -1000000, 1000000), integer("b", 0, 1000000)}, outputs, 5, 20, 2, 1},
          {"no rows", {boolean("a")}, outputs, 1, 0, 16, 0},
          {"no inputs", {}, outputs, 4, 0, 0, 0}};
}

std::vector<Valuation> probes(const Mealy& machine, std::uint64_t seed) {
  std::vector<Valuation> probes = machine.input_letters;
  util::CounterRandom random(seed, 1);
  for (int i = 0; i < 20; ++i) probes.push_back(random_letter(machine.inputs, random));
  for (std::size_t k = 0; k < machine.inputs.size(); ++k) {
    probes.push_back(random_letter(machine.inputs, random));
    probes.back()[k] = machine.inputs[k].domain.high + 1;
    probes.push_back(random_letter(machine.inputs, random));
    probes.back()[k] = INT32_MIN;
  }
  probes.emplace_back(machine.inputs.size() + 1, 0);
  return probes;
}

/// Every reachable state on every probe: answer, state after it, and what answers() said before.
void compare(Runner& runner, const std::vector<Valuation>& probes) {
  const Mealy& machine = runner.machine();
  const Reference reference(machine);
  for (const auto& [state, word] : reference.words())
    for (const Valuation& probe : probes) {
      runner.reset();
      for (const Valuation& observation : word) runner.step(observation);
      ASSERT_EQ(runner.state(), state);
      const Reference::Row* row = reference.find(state, probe);
      const auto letter = runner.letter(probe);
      ASSERT_EQ(letter, machine.input_letter(probe));
      ASSERT_EQ(letter && runner.answers(*letter), row != nullptr);
      const Runner::Answer answer = runner.step(probe);
      if (row == nullptr) {
        ASSERT_EQ(answer.status, Status::Undefined);
        ASSERT_EQ(runner.state(), state);
        continue;
      }
      ASSERT_EQ(answer.status, row->fallback ? Status::Fallback : Status::Defined);
      ASSERT_EQ(machine.output_letters[answer.output], row->output);
      ASSERT_EQ(runner.state(), row->next);
    }
}

TEST(Runner, DoesWhatTheMachineSaysInEveryReachableState) {
  for (const Shape& shape : shapes())
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      for (const std::size_t bytes : {std::size_t{0}, std::size_t{100}, std::size_t{1} << 20}) {
        SCOPED_TRACE(shape.name + " " + std::to_string(seed) + " " + std::to_string(bytes));
        Runner runner(random_machine(shape, seed), bytes);
        compare(runner, probes(runner.machine(), seed));
        if (HasFatalFailure()) return;
      }
}

TEST(Runner, LettersOutOfRangeAreUndefined) {
  Runner runner(random_machine(shapes()[0], 1));
  for (const std::uint32_t letter : {16U, 17U, UINT32_MAX}) {
    EXPECT_FALSE(runner.answers(letter));
    EXPECT_EQ(runner.step_letter(letter).status, Status::Undefined);
  }
  EXPECT_EQ(runner.step_letter(15).status, Status::Defined);
}

TEST(Runner, CopiesStepApart) {
  Mealy machine;
  {
    model::MealyBuilder builder("count", {}, {});
    for (std::uint32_t s = 0; s < 3; ++s) builder.add_state();
    for (std::uint32_t s = 0; s < 3; ++s) builder.add(s, {}, {}, (s + 1) % 3);
    machine = builder.finish();
  }
  Runner one(std::move(machine));
  one.step({});
  Runner two = one;
  two.step({});
  EXPECT_EQ(one.state(), 1U);
  EXPECT_EQ(two.state(), 2U);
  two.reset();
  EXPECT_EQ(two.state(), 0U);
  EXPECT_EQ(one.state(), 1U);
}

TEST(Runner, AMachineWithoutStatesAnswersNothing) {
  Runner runner(Mealy{});
  EXPECT_EQ(runner.step({}).status, Status::Undefined);
  EXPECT_EQ(runner.step_letter(0).status, Status::Undefined);
}

}  // namespace
}  // namespace heed::exporter
