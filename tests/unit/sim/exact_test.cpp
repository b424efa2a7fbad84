#include <gtest/gtest.h>
#include <heed/sim/exact.h>

#include "unit/sim/case_study.h"

namespace heed::sim {
namespace {

using namespace case_study;

ExactOutcome exact(const Run& run) {
  util::Budget budget;
  return exact_outcome(run, budget);
}

Rational sum(const ExactOutcome& outcome) {
  Rational result = outcome.undefined;
  for (const Rational& p : outcome.probability) result += p;
  return result;
}

TEST(Exact, TableOfTheCaseStudyToTheDigit) {
  for (const Chart& chart : charts()) {
    const ExactOutcome outcome = exact(chart.run());
    ASSERT_EQ(outcome.probability.size(), chart.expected.size());
    for (std::size_t i = 0; i < chart.expected.size(); ++i)
      EXPECT_EQ(fraction(outcome.probability[i]), fraction(q(chart.expected[i])))
          << chart.name << ", " << chart.judgement.categories[i];
    EXPECT_EQ(sum(outcome), 1);
    EXPECT_EQ(outcome.undefined, 0);
    EXPECT_EQ(outcome.missing, 0);
    EXPECT_EQ(outcome.fallback, 0);
  }
}

TEST(Exact, DecimalsOfTheThirdProfile) {
  const ExactOutcome outcome = exact(charts()[6].run());
  const std::vector<std::string> expected = {"0.9006", "0.0698", "0.0222", "0.0062", "0.0012"};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(decimal(outcome.probability[i], 4), expected[i]);
}

// One cell, one feature with probability 1/3. The machine: state 0 -blank-> 1; in 1 `off` stays silent, `on`
// as given.
struct OneCell {
  explicit OneCell(bool blank_row, bool on_row, bool fallback) : mealy(build(blank_row, on_row, fallback)) {
    ProfileSpec profile;
    profile.cells = 1;
    profile.features = {feature("f", TableOnset{{q("1/3")}, q("2/3"), 0})};
    util::Budget budget;
    chain = compile(profile, budget);
    judgement = {{"silent", "seen"}, std::vector<std::uint32_t>(mealy.transitions.size(), Judge::none), 0};
  }
  static model::Mealy build(bool blank_row, bool on_row, bool fallback) {
    model::MealyBuilder builder("one cell", {{"f", model::Domain::boolean(), {}, {}}}, {});
    builder.add_state();
    builder.add_state();
    if (blank_row) builder.add(0, {0}, {}, 1);
    builder.add(1, {0}, {}, 1);
    if (on_row) builder.add(1, {1}, {}, 1, fallback);
    return builder.finish();
  }
  [[nodiscard]] ExactOutcome outcome() const { return exact({chain, mealy, wiring, judgement}); }

  Chain chain;
  model::Mealy mealy;
  Binding wiring{{0}, {{0, 0, 1}}};
  Judge judgement;
};

TEST(Exact, MissingRowIsUndefinedUnlessAnEventCameBefore) {
  OneCell run(true, false, false);
  ExactOutcome outcome = run.outcome();
  EXPECT_EQ(outcome.probability, (std::vector<Rational>{q("2/3"), 0}));
  EXPECT_EQ(outcome.undefined, q("1/3"));
  EXPECT_EQ(outcome.missing, q("1/3"));
  run.judgement.event[0] = 1;  // The blank observation's row.
  outcome = run.outcome();
  EXPECT_EQ(outcome.probability, (std::vector<Rational>{0, 1}));
  EXPECT_EQ(outcome.undefined, 0);
  EXPECT_EQ(outcome.missing, q("1/3"));
}

TEST(Exact, NoRowForTheBlankObservation) {
  const ExactOutcome outcome = OneCell(false, true, false).outcome();
  EXPECT_EQ(outcome.undefined, 1);
  EXPECT_EQ(sum(outcome), 1);
}

TEST(Exact, FallbackIsCountedOncePerRun) {
  OneCell run(true, true, true);
  const auto* row = run.mealy.find(1, *run.mealy.input_letter({1}));
  run.judgement.event[static_cast<std::size_t>(row - run.mealy.transitions.data())] = 1;
  const ExactOutcome outcome = run.outcome();
  EXPECT_EQ(outcome.probability, (std::vector<Rational>{q("2/3"), q("1/3")}));
  EXPECT_EQ(outcome.fallback, q("1/3"));
  EXPECT_EQ(outcome.undefined, 0);
}

TEST(Exact, ALetterThatTheMachineDoesNotKnowIsAMissingRow) {
  OneCell run(true, true, false);
  run.wiring.wires[0].value = 7;
  EXPECT_EQ(run.outcome().undefined, q("1/3"));
}

}  // namespace
}  // namespace heed::sim
