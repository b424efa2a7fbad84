// Lumped outcomes against the whole chain, on everything small; and sizes that have no whole chain.
#include <gtest/gtest.h>
#include <heed/sim/exact.h>
#include <heed/sim/lumping.h>

#include <cmath>

#include "unit/sim/lumping_cases.h"

namespace heed::sim {
namespace {

using namespace case_study;
using lumping_cases::Case;
using lumping_cases::Maker;
using lumping_cases::SymbolicTwin;

ExactOutcome unlumped(const Case& made) {
  util::Budget budget;
  const Chain chain = compile(made.profile, budget);
  return exact_outcome({chain, made.machine, made.wiring, made.judgement}, budget);
}

LumpedOutcome lumped(const Case& made, double exact_work = LumpOptions().exact_work) {
  util::Budget budget;
  LumpOptions options;
  options.exact_work = exact_work;
  return lumped_outcome(made.profile, made.machine, made.wiring, made.judgement, options, budget);
}

void expect_same(const LumpedOutcome& found, const ExactOutcome& expected, const std::string& what) {
  ASSERT_TRUE(found.exact) << what;
  for (std::size_t c = 0; c < expected.probability.size(); ++c)
    EXPECT_EQ(*found.probability[c].exact, expected.probability[c]) << what << " category " << c;
  EXPECT_EQ(*found.undefined.exact, expected.undefined) << what;
  EXPECT_EQ(*found.missing.exact, expected.missing) << what;
  ASSERT_EQ(found.event_at.size(), expected.event_at.size());
  for (std::size_t i = 0; i < expected.event_at.size(); ++i)
    EXPECT_EQ(*found.event_at[i].exact, expected.event_at[i]) << what << " observation " << i;
}

TEST(Lumping, EqualsTheWholeChainOnRandomMachines) {
  std::uint32_t lumped_somewhere = 0, dropped_somewhere = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const Case made = Maker(seed).make();
    const LumpedOutcome found = lumped(made);
    const ExactOutcome expected = unlumped(made);
    expect_same(found, expected, fmt::format("seed {}", seed));
    EXPECT_EQ(*found.fallback.exact, expected.fallback) << "seed " << seed;
    lumped_somewhere += found.lumps.largest_group > 1;
    dropped_somewhere += found.lumps.components < made.profile.features.size();
    if (HasFailure()) break;
  }
  EXPECT_GT(lumped_somewhere, 50U);
  EXPECT_GT(dropped_somewhere, 100U);
}

TEST(Lumping, EqualsTheWholeChainOnMachinesByFunctions) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Case made = Maker(seed).make();
    const model::SymbolicController twin = SymbolicTwin(made).make();
    SymbolicJudge judge{made.judgement.categories, made.judgement.never, {}, {}};
    judge.event = [](const model::Valuation&, const model::Valuation& columns) {
      return columns[1] == 3 ? Judge::none : static_cast<std::uint32_t>(columns[1]);
    };
    util::Budget budget;
    expect_same(lumped_outcome(made.profile, twin, made.wiring, judge, {}, budget), unlumped(made),
                fmt::format("seed {}", seed));
    if (HasFailure()) break;
  }
}

TEST(Lumping, DoublesAreWithinTheirBound) {
  double worst = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    const Case made = Maker(seed).make();
    const LumpedOutcome found = lumped(made, 0);
    const ExactOutcome expected = unlumped(made);
    ASSERT_FALSE(found.exact);
    for (std::size_t c = 0; c < expected.probability.size(); ++c) {
      const Rational off = abs(Rational(found.probability[c].value) - expected.probability[c]);
      EXPECT_LE(off, Rational(found.probability[c].error)) << "seed " << seed;
      if (expected.probability[c] != 0)
        worst = std::max(worst, found.probability[c].error / to_double(expected.probability[c]));
    }
    if (HasFailure()) break;
  }
  EXPECT_LT(worst, 1e-13) << "a bound that says nothing";
  EXPECT_GT(worst, 0);
}

TEST(Lumping, TableOfTheCaseStudyToTheDigit) {
  const std::vector<ProfileSpec> profiles{p1(), p1(), p1(), p2(), p2(), p2(), p3(), p3(), p3()};
  const std::vector<Chart> all = charts();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const LumpedOutcome found = lumped({profiles[i], all[i].mealy, all[i].wiring, all[i].judgement});
    ASSERT_TRUE(found.exact);
    for (std::size_t c = 0; c < all[i].expected.size(); ++c)
      EXPECT_EQ(fraction(*found.probability[c].exact), fraction(q(all[i].expected[c]))) << all[i].name;
  }
}

/// A machine with one input per feature that stops when \p wanted of them are seen at once.
Case counting(int features, std::uint32_t cells, int wanted) {
  Case made;
  made.profile.name = "many";
  made.profile.cells = cells;
  std::vector<model::Variable> inputs;
  for (int f = 0; f < features; ++f) {
    made.profile.features.push_back(feature(fmt::format("f{}", f), GeometricOnset{q("1/100"), 0}));
    made.profile.features.back().detection = q("9/10");
    made.profile.features.back().false_detection = q("1/1000");
    inputs.push_back({fmt::format("i{}", f), model::Domain::boolean(), {}, {}});
    made.wiring.blank.push_back(0);
    made.wiring.wires.push_back({static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(f), 1});
  }
  model::MealyBuilder builder("counting", inputs, {});
  builder.add_state();
  for (std::int32_t bits = 0; bits < 1 << features; ++bits) {
    model::Valuation letter;
    for (int f = 0; f < features; ++f) letter.push_back(bits >> f & 1);
    builder.add(0, letter, {}, 0);
    made.judgement.event.push_back(std::popcount(static_cast<unsigned>(bits)) >= wanted ? 1 : Judge::none);
  }
  made.judgement.categories = {"never", "stop"};
  made.machine = builder.finish();
  for (std::size_t t = 0; t < made.machine.transitions.size(); ++t) {
    int seen = 0;
    for (const std::int32_t v : made.machine.input_letters[made.machine.transitions[t].input]) seen += v;
    made.judgement.event[t] = seen >= wanted ? 1 : Judge::none;
  }
  return made;
}

// One feature: never reported in any cell. By hand: with flicker, P(no report in cell d | onset) multiplies.
TEST(Lumping, ManyAlikeMultiplyWhereOneSuffices) {
  Case one = counting(1, 12, 1), many = counting(12, 12, 1);
  one.profile.persistent = many.profile.persistent = false;
  const LumpedOutcome single = lumped(one), all = lumped(many);
  Rational power = 1;
  for (int i = 0; i < 12; ++i) power *= *single.probability[0].exact;
  ASSERT_TRUE(all.exact);
  EXPECT_EQ(*all.probability[0].exact, power);
  EXPECT_EQ(all.lumps.groups, 1U);
  EXPECT_EQ(all.lumps.largest_group, 12U);
}

TEST(Lumping, WhatIsWatchedTooLongIsRoundedAndSaysSo) {
  Case many = counting(10, 100, 3);
  many.profile.persistent = false;
  const LumpedOutcome found = lumped(many);
  EXPECT_FALSE(found.exact);
  const double sum = found.probability[0].value + found.probability[1].value;
  EXPECT_LE(std::abs(sum - 1), found.probability[0].error + found.probability[1].error + 0x1p-52);
  EXPECT_LT(found.probability[0].error / found.probability[0].value, 1e-9);
}

TEST(Lumping, WhatDoesNotLumpIsRefusedWithItsSize) {
  Case many = counting(12, 40, 3);
  many.profile.persistent = false;
  for (std::size_t f = 0; f < many.profile.features.size(); ++f)
    many.profile.features[f].detection = Rational(static_cast<long>(90 + f), 103);
  util::Budget budget;
  LumpOptions options;
  options.most_states = 1000;
  try {
    (void)lumped_outcome(many.profile, many.machine, many.wiring, many.judgement, options, budget);
    FAIL() << "should not fit";
  } catch (const util::LimitExceeded& limit) {
    EXPECT_EQ(limit.kind(), util::LimitExceeded::Kind::Size);
    EXPECT_NE(std::string(limit.what()).find("12 independent components in 12 groups"), std::string::npos)
        << limit.what();
  }
}

}  // namespace
}  // namespace heed::sim
