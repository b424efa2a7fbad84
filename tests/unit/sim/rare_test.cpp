#include <gtest/gtest.h>
#include <heed/sim/exact.h>
#include <heed/sim/rare.h>
#include <heed/sim/sample.h>

#include <cmath>

#include "unit/sim/case_study.h"
#include "unit/sim/thread_team.h"

namespace heed::sim {
namespace {

using namespace case_study;

/// A thing that is reported with probability 2/5 per cell, and a machine that reacts when it is reported
/// once: category 1 "seen"; category 0 "missed", with probability (3/5)^cells.
struct Overlooked {
  explicit Overlooked(std::uint32_t cells) {
    ProfileSpec profile;
    profile.cells = cells;
    profile.features = {feature("f", FixedOnset{0})};
    profile.features[0].detection = q("2/5");
    util::Budget budget;
    chain = compile(profile, budget);
    model::MealyBuilder builder("react", {{"f", model::Domain::boolean(), {}, {}}}, {});
    builder.add_state();
    builder.add_state();
    builder.add(0, {0}, {}, 0);
    builder.add(0, {1}, {}, 1);
    builder.add(1, {0}, {}, 1);
    builder.add(1, {1}, {}, 1);
    machine = builder.finish();
    judge = {{"missed", "seen"}, {Judge::none, 1, Judge::none, Judge::none}, 0};
  }
  [[nodiscard]] sim::Run run() const { return {chain, machine, binding, judge}; }

  Chain chain;
  model::Mealy machine;
  Binding binding{{0}, {{0, 0, 1}}};
  Judge judge;
};

RareEstimate estimate(const sim::Run& run, std::uint32_t category, std::uint64_t seed,
                      std::uint32_t particles = 5'000) {
  util::Budget budget;
  RareOptions options;
  options.particles = particles;
  options.category = category;
  options.seed = seed;
  return estimate_rare(run, options, budget);
}

TEST(Rare, OneInABillionWithinATenthForNearlyEverySeed) {
  const Overlooked road(41);
  util::Budget budget;
  const Rational exact = exact_outcome(road.run(), budget).probability[0];
  const double p = to_double(exact);
  ASSERT_NEAR(p, std::pow(0.6, 41), 1e-20);
  ASSERT_LT(p, 1.1e-9);
  int close = 0, covered = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const RareEstimate found = estimate(road.run(), 0, seed, 1'000);
    close += std::abs(found.probability - p) <= 0.1 * p;
    covered += found.interval.low <= p && p <= found.interval.high;
    EXPECT_EQ(found.extinct, 0U);
  }
  EXPECT_GE(close, 95);
  EXPECT_GE(covered, 88);  // 95 of 100 within three standard deviations
}

TEST(Rare, SharesAreWhatACellLeaves) {
  const RareEstimate found = estimate(Overlooked(20).run(), 0, 7);
  ASSERT_EQ(found.survival.size(), 20U);
  for (const double share : found.survival) EXPECT_NEAR(share, 0.6, 0.01);
}

// Outcomes of every kind, those that come early and those at the end, against the exact table.
TEST(Rare, AgreesWithTheTableOfTheCaseStudy) {
  for (const Chart& chart : charts())
    for (std::uint32_t c = 0; c < chart.expected.size(); ++c) {
      const double p = to_double(q(chart.expected[c]));
      const RareEstimate found = estimate(chart.run(), c, 3);
      EXPECT_NEAR(found.probability, p, 6 * found.standard_error + 1e-12) << chart.name << c;
      EXPECT_LT(found.standard_error, 0.006);
    }
}

TEST(Rare, WhatNeverComesIsExtinct) {
  const Overlooked road(3);
  Overlooked impossible = road;
  impossible.judge.categories.emplace_back("impossible");
  const RareEstimate found = estimate(impossible.run(), 2, 1);
  EXPECT_EQ(found.probability, 0);
  EXPECT_EQ(found.extinct, 16U);
}

TEST(Rare, TeamsNeverChangeABit) {
  const Overlooked road(12);
  for (const std::uint32_t category : {0U, 1U}) {
    const RareEstimate alone = estimate(road.run(), category, 3, 300);
    for (const unsigned size : {2U, 4U, 20U})
      ThreadTeam(size).run([&](Team& team) {
        util::Budget budget;
        RareOptions options;
        options.particles = 300;
        options.category = category;
        options.seed = 3;
        options.team = &team;
        const RareEstimate shared = estimate_rare(road.run(), options, budget);
        EXPECT_EQ(shared.probability, alone.probability);
        EXPECT_EQ(shared.standard_error, alone.standard_error);
        EXPECT_EQ(shared.interval.low, alone.interval.low);
        EXPECT_EQ(shared.extinct, alone.extinct);
        EXPECT_EQ(shared.survival, alone.survival);
      });
  }
}

TEST(Width, StopsWhenEveryIntervalIsNarrowEnough) {
  const Chart chart = charts()[0];
  util::Budget budget;
  const sim::Run run = chart.run();
  const Sampler sampler(run, budget);
  WidthOptions wanted;
  wanted.width = 0.004;
  SampleOptions options;
  options.seed = 5;
  const WidthOutcome found = sample_to_width(sampler, wanted, options, budget);
  EXPECT_TRUE(found.reached);
  EXPECT_GT(found.confidence, 0.95);
  for (std::size_t c = 0; c < chart.expected.size(); ++c) {
    const Interval interval = wilson(found.outcome.count[c], found.outcome.traces, found.confidence);
    EXPECT_LE(interval.high - interval.low, 0.004);
    EXPECT_LE(interval.low, to_double(q(chart.expected[c])));
    EXPECT_GE(interval.high, to_double(q(chart.expected[c])));
  }
  options.traces = found.outcome.traces;
  EXPECT_EQ(sampler.sample(options, budget), found.outcome);  // the same traces as in one go
}

TEST(Width, GivesUpAtTheBound) {
  const Chart chart = charts()[0];
  util::Budget budget;
  const sim::Run run = chart.run();
  const Sampler sampler(run, budget);
  WidthOptions wanted;
  wanted.width = 1e-6;
  wanted.most = 10'000;
  const WidthOutcome found = sample_to_width(sampler, wanted, {}, budget);
  EXPECT_FALSE(found.reached);
  EXPECT_EQ(found.outcome.traces, 10'000U);
}

}  // namespace
}  // namespace heed::sim
