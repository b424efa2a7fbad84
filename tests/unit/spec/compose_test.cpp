#include <heed/logic/parse.h>
#include <heed/spec/compose.h>
#include <heed/spec/print.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>

#include "unit/spec/case_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace heed::spec {
namespace {

using logic::parse;

std::vector<std::string> formulas(const std::vector<Clause>& clauses, Origin origin) {
  std::vector<std::string> out;
  for (const Clause& clause : clauses)
    if (clause.origin == origin) out.push_back(logic::to_string(clause.formula));
  return out;
}

std::string same(const char* text) {
  return logic::to_string(parse(text));
}

util::Diagnostic refusal(const model::Fts& plant, const Composition& parts) {
  try {
    static_cast<void>(compose(plant, parts));
  } catch (const util::InputError& error) {
    return error.diagnostic();
  }
  return {};
}

TEST(Compose, the_case_study_is_one_specification) {
  const Composed composed = compose(case_study::car(), case_study::awareness());
  const Gr1& spec = composed.spec;
  ASSERT_EQ(spec.inputs.size(), 4U);
  ASSERT_EQ(spec.outputs.size(), 1U);
  EXPECT_EQ(spec.outputs[0].role, model::OutputRole::Action);
  ASSERT_EQ(spec.memories.size(), 1U);
  EXPECT_EQ(spec.memories[0].role, model::OutputRole::Plant);
  EXPECT_EQ(spec.memories[0].initial, std::vector<std::int32_t>{4});
  EXPECT_EQ(spec.memories[0].cases.size(), 20U);
  EXPECT_EQ(spec.definitions[0].name, "StopSign") << "definitions are sorted";
  EXPECT_THAT(formulas(spec.sys_safety, Origin::Binding),
              testing::ElementsAre(same("action = slow_down | action = hard_stop <-> Halt")));
  EXPECT_THAT(formulas(spec.sys_safety, Origin::Plant),
              testing::Contains(same("action = hard_stop -> state = M1")));
  EXPECT_THAT(formulas(spec.sys_justice, Origin::Task),
              testing::ElementsAre(same("state = M0 | state = S0"), same("state != M0 & state != S0")));
  EXPECT_EQ(spec.env_init.size(), 4U);
  EXPECT_EQ(formulas(spec.env_safety, Origin::Perception).size(), 6U);
  EXPECT_EQ(spec.sys_safety.back().text, "X (stopping) <-> Halt");
  EXPECT_THAT(spec.sys_safety.back().axioms, testing::ElementsAre("a2"));
  EXPECT_EQ(composed.notes.size(), 1U);
  EXPECT_EQ(composed.notes[0].code, "only-when-prescribed");
}

TEST(Compose, what_it_makes_is_written_and_read_back) {
  const Gr1 spec = compose(case_study::car(), case_study::awareness()).spec;
  const std::string text = write_gr1(spec);
  EXPECT_EQ(write_gr1(read_gr1(util::SourceText("case.gr1", text))), text);
  EXPECT_THAT(listing(spec), testing::HasSubstr("StopSign := "));
}

TEST(Compose, a_nondeterministic_plant_is_resolved_against_the_system) {
  model::Fts plant = case_study::car();
  plant.transitions.push_back({3, 2, 9, {}});
  plant.transitions.push_back({3, 2, 8, {}});
  const Composed composed = compose(plant, case_study::awareness());
  EXPECT_TRUE(composed.spec.memories.empty());
  EXPECT_EQ(composed.spec.inputs.back().name, "state");
  EXPECT_THAT(formulas(composed.spec.env_init, Origin::Plant), testing::ElementsAre("state = M0"));
  EXPECT_EQ(formulas(composed.spec.env_safety, Origin::Plant).size(), 20U);
  EXPECT_TRUE(std::any_of(composed.notes.begin(), composed.notes.end(),
                          [](const auto& n) { return n.code == "nondeterministic-plant"; }));
}

TEST(Compose, one_equivalence_per_effect_whatever_its_words) {
  Composition parts = case_study::awareness();
  parts.definitions.push_back({"GiveWay", parse("stop_sign"), model::OutputRole::Prescribed, "", {}});
  parts.definitions.push_back({"SlowDown", parse("sign"), model::OutputRole::Prescribed, "", {}});
  parts.bindings.push_back({"GiveWay", parse("!moving"), "!moving"});
  Composed composed = compose(case_study::car(), parts);
  EXPECT_EQ(formulas(composed.spec.sys_safety, Origin::Binding).size(), 1U);
  EXPECT_EQ(composed.spec.sys_safety.back().text, "X (stopping) <-> Halt | GiveWay");
  EXPECT_TRUE(std::any_of(composed.notes.begin(), composed.notes.end(),
                          [](const auto& n) { return n.code == "unbound-behaviour"; }));
  parts.only_when_prescribed = false;
  composed = compose(case_study::car(), parts);
  EXPECT_EQ(formulas(composed.spec.sys_safety, Origin::Binding).size(), 2U);
}

TEST(Compose, general_ltl_is_lowered_and_its_plant_terms_are_expanded) {
  Composition parts = case_study::awareness();
  parts.guarantees.push_back({parse("G (stop_sign -> F stopping)")});
  parts.guarantees.push_back({parse("G (location = 4 & X location = 3 -> Y true)")});
  const Gr1 spec = compose(case_study::car(), parts).spec;
  EXPECT_GT(spec.memories.size(), 1U);
  for (auto part : {&Gr1::env_safety, &Gr1::sys_safety, &Gr1::sys_justice})
    for (const Clause& clause : spec.*part) {
      const std::string text = logic::to_string(clause.formula);
      EXPECT_EQ(text.find("state'"), std::string::npos) << text;
      EXPECT_EQ(text.find("location"), std::string::npos) << text;
    }
}

TEST(Compose, lowering_leaves_values_without_next) {
  Composition parts = case_study::awareness();
  parts.guarantees.push_back({parse("G (sign & !red & !octagon -> X (action = go | sign))")});
  const Gr1 spec = compose(case_study::car(), parts).spec;
  EXPECT_EQ(logic::to_string(spec.sys_safety.back().formula).find("go'"), std::string::npos);
  EXPECT_NE(logic::to_string(spec.sys_safety.back().formula).find("action' = go"), std::string::npos)
      << logic::to_string(spec.sys_safety.back().formula);
}

TEST(Compose, refuses_bad_parts_with_a_hint) {
  const model::Fts car = case_study::car();
  const auto with = [&](auto change) {
    Composition parts = case_study::awareness();
    change(parts);
    return refusal(car, parts);
  };
  EXPECT_EQ(with([](auto& p) { p.bindings[0].effect = parse("X stopping"); }).code, "x-in-binding");
  EXPECT_EQ(with([](auto& p) { p.bindings[0].effect = parse("red"); }).code, "unknown-name");
  EXPECT_EQ(with([](auto& p) { p.bindings[0].behaviour = "Holt"; }).hint, "did you mean 'Halt'?");
  EXPECT_EQ(with([](auto& p) { p.inputs[1].name = "moving"; }).code, "name-clash");
  EXPECT_EQ(with([](auto& p) { p.inputs[1].name = "state"; }).code, "name-clash");
  EXPECT_EQ(with([](auto& p) { p.guarantees.push_back({parse("GF lokation = 0")}); }).hint,
            "did you mean 'location'?");
  EXPECT_EQ(with([](auto& p) { p.guarantees.push_back({parse("GF state = M9")}); }).code, "unknown-name");
  EXPECT_EQ(with([](auto& p) { p.assumptions.push_back({parse("G (signn -> red)")}); }).hint,
            "did you mean 'sign'?");
  EXPECT_EQ(with([](auto& p) { p.guarantees.push_back({parse("GF action = goo")}); }).hint,
            "did you mean 'go'?");
  EXPECT_EQ(with([](auto& p) { p.initial_states = {3}; }).code, "initial-state");
  EXPECT_EQ(with([](auto& p) { p.first_observation = model::Valuation{0}; }).code, "first-observation");
  EXPECT_EQ(with([](auto& p) { p.guarantees.push_back({parse("F G moving")}); }).code, "not-gr1");
  EXPECT_EQ(with([](auto& p) { p.definitions[1].formula = parse("Halt"); }).code, "definition-cycle");
}

}  // namespace
}  // namespace heed::spec
