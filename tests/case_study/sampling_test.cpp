// Samples agree with the exact figures over the scenario's profiles and the synthesized machines, and would
// not agree with figures that are a little wrong.
#include "workshop.h"

#include <heed/job/evaluate.h>
#include <heed/sim/rational.h>
#include <heed/sim/sample.h>
#include <heed/sim/statistics.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace case_study {
namespace {

constexpr double refused = 1e-6;

/// The nine charts of the main comparison, ready to be drawn from.
class Sampling : public testing::Test {
 protected:
  Sampling() : outcome_(run_job(example_.scenario(), example_.path("out"))) {
    world_ = job::load_world(outcome_.scenario, {}, budget_);
    for (const char* name : {"base", "tree", "awareness"})
      machines_.push_back(read_controller(example_.path(std::string("out/") + name + ".controller.json")));
    stop_ = world_.knowledge.catalogue.entity("StopSign");
  }

  /// Calls \p work(profile, machine) for each chart.
  template <class Work>
  void for_each_chart(Work work) {
    for (const job::ProfilePart& profile : outcome_.scenario.profiles)
      for (const model::Mealy& machine : machines_) work(profile, machine);
  }

  [[nodiscard]] job::Evaluation evaluate(const job::ProfilePart& profile, const model::Mealy& machine,
                                         std::uint64_t seed) {
    job::EvaluateOptions options;
    options.traces = 10'000;
    options.seed = seed;
    return job::evaluate(outcome_.scenario, world_, profile, machine, stop_, options, budget_);
  }

  static std::vector<double> doubles(const std::vector<sim::Rational>& exact) {
    std::vector<double> out;
    for (const sim::Rational& p : exact) out.push_back(sim::to_double(p));
    return out;
  }

  /// Moves .02 of the mass from the likeliest outcome to the next likely one.
  static std::vector<double> corrupted(std::vector<double> exact) {
    const auto most = std::max_element(exact.begin(), exact.end());
    auto next = exact.end();
    for (auto it = exact.begin(); it != exact.end(); ++it)
      if (it != most && (next == exact.end() || *it > *next)) next = it;
    *most -= .02;
    *next += .02;
    return exact;
  }

  const Example example_;
  util::Budget budget_;
  Outcome outcome_;
  job::World world_;
  std::vector<model::Mealy> machines_;
  std::size_t stop_ = 0;
};

TEST_F(Sampling, HundredSeedsPerChartAgree) {
  for_each_chart([&](const job::ProfilePart& profile, const model::Mealy& machine) {
    double smallest = 1, smallest_corrupted = 1;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const job::Evaluation found = evaluate(profile, machine, seed);
      const std::vector<double> exact = doubles(found.exact.probability);
      ASSERT_EQ(found.sampled.traces, 10'000U);
      smallest = std::min(smallest, sim::chi_square(found.sampled.count, exact).p_value);
      smallest_corrupted =
          std::min(smallest_corrupted, sim::chi_square(found.sampled.count, corrupted(exact)).p_value);
    }
    EXPECT_GT(smallest, refused) << profile.spec.name << ' ' << machine.name;
    EXPECT_LT(smallest_corrupted, refused) << profile.spec.name << ' ' << machine.name;
  });
}

TEST_F(Sampling, IntervalsCoverAsTheySay) {
  std::uint64_t covered = 0, covered_corrupted = 0, all = 0;
  for_each_chart([&](const job::ProfilePart& profile, const model::Mealy& machine) {
    const std::vector<double> exact = doubles(evaluate(profile, machine, 1).exact.probability);
    const std::vector<double> wrong = corrupted(exact);
    const job::Approach way = job::approach(profile, world_, machine, stop_, budget_);
    const sim::Judge judge = job::make_judge(outcome_.scenario, world_, machine, false);
    const sim::Sampler sampler(sim::Run{way.chain, machine, way.binding, judge}, budget_);
    for (std::uint64_t seed = 1; seed <= 2'000; ++seed) {
      sim::SampleOptions options;
      options.traces = 10'000;
      options.seed = seed;
      const sim::SampleOutcome sampled = sampler.sample(options, budget_);
      for (std::size_t c = 0; c < exact.size(); ++c) {
        if (exact[c] <= 0 || exact[c] >= 1) continue;
        const sim::Interval interval = sim::wilson(sampled.count[c], sampled.traces);
        ++all;
        covered += interval.low <= exact[c] && exact[c] <= interval.high ? 1 : 0;
        covered_corrupted += interval.low <= wrong[c] && wrong[c] <= interval.high ? 1 : 0;
      }
    }
  });
  const double share = static_cast<double>(covered) / static_cast<double>(all);
  EXPECT_GE(share, .93);
  EXPECT_LE(share, .97);
  EXPECT_LT(static_cast<double>(covered_corrupted) / static_cast<double>(all), .93);
}

}  // namespace
}  // namespace case_study
