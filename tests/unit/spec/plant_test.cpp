#include <heed/logic/parse.h>
#include <heed/spec/compose.h>
#include <heed/util/diagnostic.h>
#include <heed/util/random.h>

#include "unit/check/naive.h"

#include <gtest/gtest.h>

namespace heed::spec {
namespace {

using naive::Step;
using Random = util::CounterRandom;

model::Fts random_plant(Random& random, bool deterministic) {
  model::Fts plant;
  plant.name = "random";
  for (int i = 0; i < 5; ++i) plant.states.push_back("q" + std::to_string(i));
  plant.actions = {"go", "wait", "turn"};
  plant.initial = {0};
  for (std::uint32_t s = 0; s < 5; ++s)
    for (std::uint32_t a = 0; a < 3; ++a) {
      if (a != 0 && random.below(3) == 0) continue;
      const std::uint32_t to = random.below(5);
      plant.transitions.push_back({s, a, to, {}});
      if (!deterministic && to != 4 && random.below(2) == 0) plant.transitions.push_back({s, a, to + 1, {}});
    }
  for (const char* label : {"moving", "lit"}) {
    std::vector<bool> holds;
    for (int s = 0; s < 5; ++s) holds.push_back(random.below(2) == 0);
    plant.labels.emplace_back(label, holds);
  }
  for (const char* value : {"place", "speed"}) {
    std::vector<std::int32_t> values;
    for (int s = 0; s < 5; ++s) values.push_back(static_cast<std::int32_t>(random.below(3)) - 1);
    plant.values.emplace_back(value, values);
  }
  return plant;
}

std::string random_formula(Random& random, unsigned depth) {
  const std::vector<std::string> atoms{"moving",
                                       "lit",
                                       "state = q3",
                                       "state != q1",
                                       "place = 0",
                                       "place <= speed",
                                       "place + speed = 1",
                                       "place' < place",
                                       "speed' = 0",
                                       "state' = state",
                                       "state' != q2",
                                       "red",
                                       "seen = place",
                                       "seen' < place'",
                                       "seen > place'",
                                       "X (moving & red)",
                                       "X (lit <-> place = 1)",
                                       "action = go",
                                       "X !moving",
                                       "place * 2 > speed' - 1"};
  if (depth == 0) return "(" + atoms[random.below(static_cast<std::uint32_t>(atoms.size()))] + ")";
  const std::vector<std::string> signs{" & ", " | ", " -> ", " <-> "};
  const std::string left = random_formula(random, depth - 1), right = random_formula(random, depth - 1);
  return (random.below(4) == 0 ? "!(" : "(") + left + signs[random.below(4)] + right + ")";
}

/// The names of a step as a person would list them: what the plant is like in the state, and what else is
/// seen.
Step step_in(const model::Fts& plant, std::uint32_t state, std::int64_t red, std::int64_t seen,
             std::uint32_t action) {
  Step out{{"state", state}, {"red", red}, {"seen", seen}, {"action", action}};
  for (const auto& [name, holds] : plant.labels) out[name] = holds[state] ? 1 : 0;
  for (const auto& [name, values] : plant.values) out[name] = values[state];
  return out;
}

naive::Evaluator evaluator(const model::Fts& plant) {
  naive::Evaluator out{Gr1{}};
  out.declare("state", model::Domain::enumeration(plant.states));
  out.declare("action", model::Domain::enumeration(plant.actions));
  return out;
}

void compare(const model::Fts& plant, const std::string& text, Random& random) {
  SCOPED_TRACE(text);
  const logic::Formula formula = logic::parse(text), expanded = expand_plant(formula, plant);
  SCOPED_TRACE(logic::to_string(expanded));
  const auto holds = evaluator(plant);
  for (const auto& t : plant.transitions) {
    const auto draw = [&] { return static_cast<std::int64_t>(random.below(2)); };
    const Step now = step_in(plant, t.from, draw(), draw(), t.action),
               next = step_in(plant, t.to, draw(), draw(), random.below(3));
    // After expansion nothing of the plant but state and action may be asked for.
    Step now_left = now, next_left = next;
    for (const char* name : {"moving", "lit", "place", "speed"}) {
      now_left.erase(name);
      next_left.erase(name);
    }
    if (plant.deterministic()) next_left.erase("state");
    EXPECT_EQ(holds(formula, now, next) != 0, holds(expanded, now_left, next_left) != 0);
  }
}

TEST(ExpandPlant, means_the_same_on_every_transition) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Random random(7, seed);
    const model::Fts plant = random_plant(random, seed % 2 == 0);
    compare(plant, random_formula(random, static_cast<unsigned>(seed % 3)), random);
    if (testing::Test::HasFailure()) return;
  }
}

model::Fts car() {
  model::Fts plant;
  plant.states = {"M1", "M0", "S1", "S0"};
  plant.actions = {"go", "slow", "hard"};
  plant.initial = {1, 3};
  plant.transitions = {{0, 0, 1, {}}, {1, 0, 0, {}}, {2, 0, 1, {}}, {3, 0, 0, {}},
                       {0, 2, 3, {}}, {1, 1, 2, {}}, {2, 1, 3, {}}, {3, 1, 2, {}}};
  plant.labels = {{"moving", {true, true, false, false}}, {"stopping", {false, false, true, true}}};
  plant.values = {{"location", {1, 0, 1, 0}}};
  return plant;
}

TEST(ExpandPlant, next_constrains_the_action_of_now) {
  const auto text = [](const char* formula) {
    return logic::to_string(expand_plant(logic::parse(formula), car()));
  };
  EXPECT_EQ(text("X stopping"), logic::to_string(logic::parse("action = slow | action = hard")));
  EXPECT_EQ(text("stopping"), "state = S1 | state = S0");
  EXPECT_EQ(
      text("location' = 1 & red"),
      logic::to_string(logic::parse(
          "(action = go & (state = M0 | state = S0) | action = slow & (state = M0 | state = S0)) & red")));
  EXPECT_EQ(text("G (a -> F b)"), logic::to_string(logic::parse("G (a -> F b)")));
  EXPECT_EQ(text("moving | !moving"), "true");
}

TEST(ExpandPlant, refuses_what_has_no_meaning) {
  for (const char* bad : {"location", "location & moving", "state < M1", "state = M7", "location''' = 1"}) {
    EXPECT_THROW(static_cast<void>(expand_plant(logic::parse(bad), car())), util::InputError) << bad;
  }
}

TEST(ExpandPlant, deep_formulas_are_no_deep_calls) {
  logic::Formula formula = logic::parse("stopping");
  for (int i = 0; i < 100000; ++i) formula = logic::Formula::make(logic::Op::Not, {formula});
  EXPECT_EQ(logic::to_string(expand_plant(formula, car())), "state = S1 | state = S0");
}

}  // namespace
}  // namespace heed::spec
