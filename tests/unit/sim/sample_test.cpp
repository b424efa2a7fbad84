#include <gtest/gtest.h>
#include <heed/sim/exact.h>
#include <heed/sim/sample.h>
#include <heed/sim/statistics.h>

#include <map>
#include <optional>

#include "../src/sim/sample_tables.h"
#include "unit/sim/case_study.h"
#include "unit/sim/thread_team.h"

namespace heed::sim {
namespace {

using namespace case_study;

struct Sampled {
  explicit Sampled(const Chart& chart) : sampler(chart.run(), budget) {
    for (const Rational& p : exact_outcome(chart.run(), budget).probability) exact.push_back(to_double(p));
  }
  SampleOutcome draw(const SampleOptions& options) { return sampler.sample(options, budget); }
  util::Budget budget;
  Sampler sampler;
  std::vector<double> exact;
};

/// The outcome of a trace by the definition: steps through the machine, row by row.
SampleOutcome judged(const Run& run, const std::vector<std::uint64_t>& trace) {
  SampleOutcome outcome;
  outcome.traces = 1;
  outcome.count.resize(run.judge.categories.size());
  std::uint32_t state = 0, category = Judge::none;
  bool missing = false;
  for (std::size_t step = 0; step <= trace.size() && !missing; ++step) {
    model::Valuation observation = run.binding.blank;
    for (const Binding::Wire& wire : run.binding.wires)
      if (step > 0 && (trace[step - 1] >> wire.feature & 1) != 0) observation[wire.input] = wire.value;
    const auto letter = run.machine.input_letter(observation);
    const auto* row = letter ? run.machine.find(state, *letter) : nullptr;
    missing = row == nullptr;
    if (missing) break;
    state = row->next;
    outcome.fallback |= row->fallback;
    if (category == Judge::none)
      category = run.judge.event[static_cast<std::size_t>(row - run.machine.transitions.data())];
  }
  outcome.missing = missing;
  outcome.undefined = missing && category == Judge::none;
  if (outcome.undefined == 0) ++outcome.count[category == Judge::none ? run.judge.never : category];
  return outcome;
}

/// A machine that knows only some observations, some of them as fallback; the road is noisy.
Chart patchy(std::uint32_t cells) {
  ProfileSpec profile;
  profile.name = "noisy";
  profile.cells = cells;
  profile.features = {feature("sign", UniformOnset{0, at("never")}),
                      feature("red", GeometricOnset{q("1/3"), at("sign")})};
  for (FeatureSpec& f : profile.features) f.detection = q("0.9"), f.false_detection = q("0.07");
  profile.persistent = false;
  model::MealyBuilder builder(
      "patchy",
      {{"sign", model::Domain::boolean(), {}, {}}, {"colour", model::Domain::integer(0, 3), {}, {}}}, {});
  for (int i = 0; i < 3; ++i) builder.add_state();
  for (std::uint32_t state = 0; state < 3; ++state) {
    builder.add(state, {0, 0}, {}, state);
    builder.add(state, {1, 0}, {}, (state + 1) % 3);
    if (state != 1) builder.add(state, {1, 3}, {}, 2, state == 2);
    if (state == 2) builder.add(state, {0, 3}, {}, 0, true);
  }
  util::Budget budget;
  Chart chart{"patchy", compile(profile, budget), builder.finish(), {{0, 0}, {{0, 0, 1}, {1, 1, 3}}}, {}, {}};
  chart.judgement = {{"no", "early", "late"}, {}, 0};
  for (std::size_t i = 0; i < chart.mealy.transitions.size(); ++i)
    chart.judgement.event.push_back(chart.mealy.transitions[i].fallback ? 1 : i == 5 ? 2 : Judge::none);
  return chart;
}

TEST(Sample, EveryTraceIsCountedAsItsDefinitionSays) {
  std::vector<Chart> all = charts();
  all.push_back(patchy(1));
  all.push_back(patchy(9));
  for (const Chart& chart : all) {
    Sampled sampled(chart);
    SampleOptions options;
    options.traces = 1;
    options.seed = 0x123456789abcdef0;
    for (std::uint64_t i = 0; i < 2'000; ++i) {
      options.first = i + (std::uint64_t{1} << 32) - 1'000;
      const auto trace = sampled.sampler.trace(options.seed, options.first);
      ASSERT_EQ(trace.size(), chart.chain.cells);
      ASSERT_EQ(sampled.draw(options), judged(chart.run(), trace)) << chart.name << " " << i;
    }
  }
}

TEST(Sample, RangesPutTogetherAreOneRun) {
  Sampled sampled(charts()[6]);
  SampleOptions options;
  options.traces = 10'007;
  options.seed = 7;
  const SampleOutcome whole = sampled.draw(options);
  std::vector<std::uint64_t> sum(whole.count.size());
  for (const auto& [first, traces] :
       std::vector<std::pair<std::uint64_t, std::uint64_t>>{{0, 3}, {3, 5'000}, {5'003, 5'004}}) {
    options.first = first;
    options.traces = traces;
    const SampleOutcome part = sampled.draw(options);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part.count[i];
  }
  EXPECT_EQ(sum, whole.count);
}

TEST(Sample, ThreadsNeverChangeACount) {
  std::vector<Chart> all = charts();
  all.push_back(patchy(9));
  for (const Chart& chart : all) {
    Sampled sampled(chart);
    SampleOptions options;
    options.traces = 100'003;
    const SampleOutcome one = sampled.draw(options);
    EXPECT_EQ(one.traces, options.traces);
    for (const unsigned threads : {2U, 3U, 4U, 0U}) {
      options.threads = threads;
      EXPECT_EQ(sampled.draw(options), one);
    }
  }
}

TEST(Sample, TeamsNeverChangeACount) {
  const Chart chart = patchy(6);
  util::Budget budget;
  const Sampler sampler(chart.run(), budget);
  for (const std::uint64_t traces : {0U, 2U, 10'007U}) {
    SampleOptions options{traces, 5, 11, 1, nullptr};
    const SampleOutcome alone = sampler.sample(options, budget);
    for (const unsigned size : {1U, 2U, 4U})
      ThreadTeam(size).run([&](Team& team) {
        util::Budget own;
        SampleOptions shared = options;
        shared.team = &team;
        shared.threads = team.rank() + 1;
        EXPECT_EQ(sampler.sample(shared, own), alone) << size << " members, " << traces << " traces";
      });
  }
}

TEST(Sample, SeedsDiffer) {
  Sampled sampled(charts()[0]);
  SampleOptions options;
  const SampleOutcome first = sampled.draw(options);
  options.seed = 2;
  EXPECT_NE(sampled.draw(options), first);
}

TEST(Sample, NoTraces) {
  Sampled sampled(charts()[0]);
  SampleOptions options;
  options.traces = 0;
  EXPECT_EQ(sampled.draw(options).traces, 0U);
}

TEST(Sample, AgreesWithTheExactDistributionForHundredSeeds) {
  for (const Chart& chart : charts()) {
    Sampled sampled(chart);
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SampleOptions options;
      options.seed = seed;
      EXPECT_GT(chi_square(sampled.draw(options).count, sampled.exact).p_value, 1e-6)
          << chart.name << " seed " << seed;
    }
  }
}

TEST(Sample, PatchyMachineAgreesInEveryFigure) {
  const Chart chart = patchy(9);
  Sampled sampled(chart);
  const ExactOutcome exact = exact_outcome(chart.run(), sampled.budget);
  SampleOptions options;
  options.traces = 1'000'000;
  const SampleOutcome outcome = sampled.draw(options);
  const auto check = [&](std::uint64_t count, const Rational& p) {
    EXPECT_GT(p, 0);
    EXPECT_LT(p, 1);
    const Interval interval = wilson(count, outcome.traces, 1 - 1e-6);
    EXPECT_LT(interval.low, to_double(p));
    EXPECT_GT(interval.high, to_double(p));
  };
  check(outcome.undefined, exact.undefined);
  check(outcome.missing, exact.missing);
  check(outcome.fallback, exact.fallback);
  for (std::size_t i = 0; i < exact.probability.size(); ++i) check(outcome.count[i], exact.probability[i]);
}

TEST(Sample, ACorruptedExactDistributionFails) {
  for (const Chart& chart : charts()) {
    Sampled sampled(chart);
    std::vector<std::uint64_t> pooled(sampled.exact.size());
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SampleOptions options;
      options.seed = seed;
      const SampleOutcome outcome = sampled.draw(options);
      for (std::size_t i = 0; i < pooled.size(); ++i) pooled[i] += outcome.count[i];
    }
    EXPECT_GT(chi_square(pooled, sampled.exact).p_value, 1e-6) << chart.name;
    sampled.exact[1] += 0.005;
    sampled.exact[2] -= 0.005;
    EXPECT_LT(chi_square(pooled, sampled.exact).p_value, 1e-6) << chart.name;
  }
}

TEST(Sample, WilsonIntervalsCoverNinetyFiveInHundred) {
  std::uint64_t covered = 0, bars = 0;
  for (const Chart& chart : charts()) {
    Sampled sampled(chart);
    for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
      SampleOptions options;
      options.seed = seed;
      const SampleOutcome outcome = sampled.draw(options);
      for (std::size_t i = 0; i < outcome.count.size(); ++i) {
        if (sampled.exact[i] <= 0 || sampled.exact[i] >= 1) continue;
        const Interval interval = wilson(outcome.count[i], outcome.traces);
        covered += interval.low <= sampled.exact[i] && sampled.exact[i] <= interval.high;
        ++bars;
      }
    }
  }
  EXPECT_EQ(bars, 2'000U * 34U);
  const double coverage = static_cast<double>(covered) / static_cast<double>(bars);
  EXPECT_GT(coverage, 0.93);
  EXPECT_LT(coverage, 0.97);
}

// What a 64-bit draw decides, also where its low half matters.
TEST(Sample, DrawsAreDecidedTheSameWayQuicklyAndCarefully) {
  const Chain chain{
      "thirds", {"f"}, 1, {0, 3, 3}, {{q("1/3"), 1, 0}, {q("1e-6"), 1, 1}, {q("2/3") - q("1e-6"), 1, 2}}};
  const std::vector<std::uint32_t> letters = {10, 11, 12};
  util::Budget budget;
  const DrawTable table(chain, letters, budget);
  const std::uint64_t third = UINT64_MAX / 3;  // floor(2^64 / 3)
  const std::vector<std::uint64_t> draws = {
      0, 1, third - 1, third, third + 1, third ^ 0xffffffff, std::uint64_t{1} << 63, UINT64_MAX};
  for (const std::uint64_t draw : draws) {
    const auto high = static_cast<std::uint32_t>(draw >> 32), low = static_cast<std::uint32_t>(draw);
    const std::uint32_t careful = table.careful(0, high, [low] { return low; }).letter;
    EXPECT_EQ(careful, 10 + table.step_index(0, draw));
    EXPECT_EQ(careful == 10, draw < third);
    const std::uint32_t quick = table.quick(0, high).letter;
    EXPECT_TRUE(quick == DrawTable::undecided || quick == careful);
  }
  EXPECT_EQ(table.quick(0, static_cast<std::uint32_t>(third >> 32)).letter, DrawTable::undecided);
}

}  // namespace
}  // namespace heed::sim
