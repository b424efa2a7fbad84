#include <heed/check/verify.h>
#include <heed/util/diagnostic.h>

#include "unit/check/replay.h"
#include "unit/spec/case_study.h"

#include <gtest/gtest.h>

namespace heed::check {
namespace {

/// A controller for the case study as a person would write it, one state per state of the car, started in M0.
/// `threshold` of the three features make it stop.
model::Mealy hand_made(const spec::Gr1& spec, const model::Fts& car, int threshold) {
  model::MealyBuilder builder("hand", spec.inputs, spec::controller_outputs(spec));
  const std::vector<std::uint32_t> order{4, 0, 1, 2, 3, 5, 6, 7, 8, 9};  // M0 first
  std::vector<std::uint32_t> place(10);
  for (std::uint32_t i = 0; i < 10; ++i) place[order[i]] = builder.add_state();
  for (std::uint32_t s = 0; s < 10; ++s)
    for (std::int32_t letter = 0; letter < 16; ++letter) {
      const model::Valuation input{letter & 1, letter >> 1 & 1, letter >> 2 & 1, letter >> 3 & 1};
      const bool detected = input[0] + input[1] + input[2] >= threshold;
      const std::string wanted = !detected ? "go" : car.states[s] == "M1" ? "hard_stop" : "slow_down";
      const auto action = std::find(car.actions.begin(), car.actions.end(), wanted) - car.actions.begin();
      const std::uint32_t next = car.successors(s, static_cast<std::uint32_t>(action)).at(0);
      builder.add(place[s], input,
                  {static_cast<std::int32_t>(action), static_cast<std::int32_t>(s), detected, detected},
                  place[next]);
    }
  return builder.finish();
}

TEST(CaseStudy, the_hand_made_controller_is_verified) {
  const model::Fts car = case_study::car();
  const spec::Gr1 spec = spec::compose(car, case_study::awareness()).spec;
  util::Budget budget;
  const Verdict verdict = verify(hand_made(spec, car, 2), spec, budget);
  EXPECT_TRUE(verdict.verified) << (verdict.refutations.empty() ? "" : verdict.refutations[0].message);
  EXPECT_FALSE(verdict.relies_on_broken_justice);
}

TEST(CaseStudy, eager_and_late_controllers_are_refused) {
  const model::Fts car = case_study::car();
  const spec::Gr1 spec = spec::compose(car, case_study::awareness()).spec;
  for (const int threshold : {0, 1, 3, 4}) {
    util::Budget budget;
    const model::Mealy machine = hand_made(spec, car, threshold);
    const Verdict verdict = verify(machine, spec, budget);
    ASSERT_FALSE(verdict.verified);
    EXPECT_EQ(verdict.refutations[0].kind, Refutation::Kind::WrongColumn);
    naive::replay(machine, spec, verdict.refutations[0]);
  }
}

TEST(CaseStudy, every_other_action_is_refused_where_the_input_is_legal) {
  const model::Fts car = case_study::car();
  const spec::Gr1 spec = spec::compose(car, case_study::awareness()).spec;
  const model::Mealy right = hand_made(spec, car, 2);
  std::size_t refused = 0, accepted = 0;
  for (std::size_t row = 0; row < right.transitions.size(); ++row)
    for (std::int32_t shift = 1; shift < 3; ++shift) {
      model::Mealy machine = right;
      model::Valuation letter = machine.output_letters[machine.transitions[row].output];
      letter[0] = (letter[0] + shift) % 3;
      machine.output_letters.push_back(letter);
      machine.transitions[row].output = static_cast<std::uint32_t>(machine.output_letters.size() - 1);
      util::Budget budget;
      ++(verify(machine, spec, budget).verified ? accepted : refused);
    }
  // Of 16 letters, 8 keep both orders (parts on a sign, the whole on a part); the others and the 7 that
  // cannot come first in M0 (after S1 or M1 all 8 can) are never legal, so that their rows do not count.
  EXPECT_EQ(refused + accepted, 320U);
  EXPECT_EQ(refused % 2, 0U);
  EXPECT_GT(refused, 100U);
  EXPECT_GE(accepted, 160U);
}

TEST(CaseStudy, without_the_hard_stop_it_is_refused) {
  const model::Fts car = case_study::car();
  const model::Mealy machine = hand_made(spec::compose(car, case_study::awareness()).spec, car, 2);
  model::Fts other = car;
  std::erase_if(other.transitions, [&](const auto& t) {
    return other.states[t.from] == "M1" && other.actions[t.action] == "hard_stop";
  });
  const spec::Gr1 spec = spec::compose(other, case_study::awareness()).spec;
  util::Budget budget;
  const Verdict verdict = verify(machine, spec, budget);
  ASSERT_FALSE(verdict.verified);
  EXPECT_EQ(verdict.refutations[0].kind, Refutation::Kind::Safety);
  EXPECT_EQ(verdict.refutations[0].clause, "hard_stop only where the plant can");
}

/// 13 inputs without rules, 20 states: all 8192 letters are legal everywhere.
TEST(Size, thirteen_free_inputs_and_twenty_states) {
  spec::Gr1 spec;
  logic::Formula some = logic::truth(false);
  for (int i = 0; i < 13; ++i) {
    spec.inputs.push_back({"f" + std::to_string(i), model::Domain::boolean(), ""});
    some = some || logic::name(spec.inputs.back().name);
  }
  spec.outputs.push_back({{"y", model::Domain::boolean(), ""}, model::OutputRole::Output});
  spec.sys_safety.push_back({logic::iff(logic::name("y"), some), spec::Origin::Task, "y"});
  spec.sys_justice.push_back({logic::implies(some, logic::name("y")), spec::Origin::Task, "again"});
  model::MealyBuilder builder("wide", spec.inputs, spec::controller_outputs(spec));
  for (std::uint32_t s = 0; s < 20; ++s) builder.add_state();
  for (std::uint32_t s = 0; s < 20; ++s)
    for (std::int32_t letter = 0; letter < 8192; ++letter) {
      model::Valuation input;
      for (int i = 0; i < 13; ++i) input.push_back(letter >> i & 1);
      builder.add(s, input, {letter != 0}, (s + 1) % 20);
    }
  const model::Mealy machine = builder.finish();
  util::Budget budget;
  const Verdict verdict = verify(machine, spec, budget);
  EXPECT_TRUE(verdict.verified);
  EXPECT_EQ(verdict.product_edges, 8192U * 21);
  std::cout << "verified in " << budget.elapsed_seconds() << " s\n";
}

}  // namespace
}  // namespace heed::check
