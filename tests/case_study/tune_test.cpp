// Policies side by side against the enumeration of traces, the drive past the catalogue, and the definitions
// of front and bound.
#include "enumeration.h"
#include "workshop.h"

#include <heed/job/evaluate.h>
#include <heed/job/tune.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace case_study {
namespace {

/// The tree's path, one level per step: each level holds what was seen when the one before had been walked.
bool octagon_after_sign(unsigned now, unsigned before) {
  return (before & Sign) != 0 && (now & Shape) != 0;
}

const std::map<std::string, Detects>& policies() {
  static const std::map<std::string, Detects> detects{
      {"read whole", base_detects},
      {"at least 2 of sign, red, octagon", two_of(Sign | Colour | Shape)},
      {"at least 1 of sign, red, octagon",
       [](unsigned now, unsigned) { return (now & (Sign | Colour | Shape)) != 0; }},
      {"tree sign -> red", tree_detects},
      {"tree sign -> octagon", octagon_after_sign},
      {"tree-or-full sign -> octagon",
       [](unsigned now, unsigned before) { return octagon_after_sign(now, before) || (now & Whole) != 0; }}};
  return detects;
}

class Tune : public testing::Test {
 protected:
  Tune() : scenario_(read_scenario(example_.scenario())), world_(job::load_world(scenario_, {}, budget_)) {}

  job::Tuning tuned(const job::TuneOptions& options) {
    return job::tune(scenario_, world_, options, budget_);
  }

  Example example_;
  util::Budget budget_;
  job::Scenario scenario_;
  job::World world_;
};

TEST_F(Tune, MissesAndDistancesAreThoseOfTheEnumeration) {
  const job::Tuning tuning = tuned({});
  std::size_t compared = 0;
  for (const job::TuneFigure& figure : tuning.figures) {
    const auto known = policies().find(tuning.policies[figure.policy]);
    if (known == policies().end()) continue;
    const std::string& profile = scenario_.profiles[figure.profile].spec.name;
    const auto where = detection(traces_of(profile), Sign | Colour | Shape | Whole, known->second);
    mpq_class distance = 0;
    for (unsigned location = 1; location < cells; ++location) distance += location * where[location];
    EXPECT_EQ(*figure.miss.exact, mpq_class(where[0] + where[5])) << profile << ' ' << known->first;
    EXPECT_EQ(*figure.distance.exact, distance) << profile << ' ' << known->first;
    ++compared;
  }
  EXPECT_EQ(compared, 3 * policies().size());
}

/// From v = 50 km/h to rest over n cells of 10 m: v^2 / (2 n 10 m), from the enumerated stops.
TEST_F(Tune, BrakingIsThatOfTheStops) {
  const mpq_class speed = mpq_class(50 * 5, 18), one_cell = speed * speed / 20;
  std::size_t compared = 0;
  const job::Tuning tuning = tuned({});
  for (const job::TuneFigure& figure : tuning.figures) {
    const auto known = policies().find(tuning.policies[figure.policy]);
    if (known == policies().end()) continue;
    const std::string& profile = scenario_.profiles[figure.profile].spec.name;
    const auto where = detection(traces_of(profile), Sign | Colour | Shape | Whole, known->second);
    mpq_class sum = 0, stops = 0, hardest = 0;
    for (unsigned n = cells - 1; n > 0; --n) {
      if (where[n] == 0) continue;
      hardest = one_cell / n;
      sum += where[n] * hardest;
      stops += where[n];
    }
    ASSERT_TRUE(figure.braking);
    EXPECT_EQ(*figure.braking->exact, mpq_class(sum / stops)) << profile << ' ' << known->first;
    EXPECT_EQ(*figure.hardest->exact, hardest) << profile << ' ' << known->first;
    ++compared;
  }
  EXPECT_EQ(compared, 3 * policies().size());
}

TEST_F(Tune, SimpleOnesAreAmongAllAndNameTheScenariosOwn) {
  job::TuneOptions options;
  const job::Tuning all = tuned(options);
  options.simple = true;
  const job::Tuning simple = tuned(options);
  EXPECT_LT(simple.policies.size(), all.policies.size() / 2);
  for (const job::TuneFigure& one : simple.figures) {
    const auto same = std::find_if(all.figures.begin(), all.figures.end(), [&](const job::TuneFigure& other) {
      return all.policies[other.policy] == simple.policies[one.policy] && other.profile == one.profile;
    });
    ASSERT_NE(same, all.figures.end()) << simple.policies[one.policy];
    EXPECT_EQ(*one.miss.exact, *same->miss.exact);
    EXPECT_EQ(*one.needless.exact, *same->needless.exact);
  }
  std::map<std::string, std::string> own;
  for (const job::OwnPolicy& one : simple.own)
    own[scenario_.controllers[one.controller].name.text] = simple.policies[one.policy];
  const std::map<std::string, std::string> expected{{"base", "read whole"},
                                                    {"tree", "tree sign -> red"},
                                                    {"awareness", "at least 2 of sign, red, octagon"},
                                                    {"tree-or-full", "tree-or-full sign -> red"}};
  EXPECT_EQ(own, expected);
}

TEST_F(Tune, NeedlessReactionsAreTheMeanOverTheCatalogue) {
  const Outcome run = run_job(example_.scenario(), example_.path("out"));
  std::map<std::string, std::pair<mpq_class, unsigned long>> sums;
  for (const report::CatalogueEntry& entry : run.result.catalogue)
    for (const report::Encounter& one : entry.encounters)
      if (one.controller == "awareness" && one.needless) {
        sums[one.profile].first += mpq_class(one.needless->exact);
        ++sums[one.profile].second;
      }
  std::size_t compared = 0;
  const job::Tuning tuning = tuned({});
  for (const job::TuneFigure& figure : tuning.figures) {
    if (tuning.policies[figure.policy] != "at least 2 of sign, red, octagon") continue;
    const auto& [sum, count] = sums.at(scenario_.profiles[figure.profile].spec.name);
    EXPECT_EQ(*figure.needless.exact, mpq_class(sum / count));
    ++compared;
  }
  EXPECT_EQ(compared, 3U);
}

TEST_F(Tune, TheFrontHasWhatNothingBeats) {
  const job::Tuning tuning = tuned({std::nullopt, {0, sim::Rational(1, 20)}});
  const auto no_worse = [](const job::TuneFigure& a, const job::TuneFigure& b) {
    return *a.miss.exact <= *b.miss.exact && *a.needless.exact <= *b.needless.exact &&
           *a.distance.exact >= *b.distance.exact;
  };
  std::size_t on_front = 0;
  for (const job::TuneFigure& one : tuning.figures) {
    const bool beaten = std::any_of(tuning.figures.begin(), tuning.figures.end(), [&](const auto& other) {
      return other.profile == one.profile && other.noise == one.noise && no_worse(other, one) &&
             !no_worse(one, other);
    });
    EXPECT_EQ(one.on_front, !beaten);
    on_front += one.on_front;
  }
  EXPECT_GT(on_front, 12U);
  EXPECT_LT(on_front, tuning.figures.size());
}

TEST_F(Tune, TheBestKeepsTheBoundEverywhereAndMissesLeast) {
  for (const char* bound : {"1/10", "3/5", "1", "0"}) {
    const mpq_class most(bound);
    const job::Tuning tuning = tuned({most, {0}});
    std::vector<mpq_class> needless(tuning.policies.size(), 0), miss(needless);
    for (const job::TuneFigure& one : tuning.figures) {
      needless[one.policy] = std::max(needless[one.policy], *one.needless.exact);
      miss[one.policy] = std::max(miss[one.policy], *one.miss.exact);
    }
    ASSERT_TRUE(tuning.best) << bound;
    EXPECT_LE(needless[*tuning.best], most) << bound;
    for (std::size_t p = 0; p < miss.size(); ++p)
      EXPECT_TRUE(needless[p] > most || miss[p] >= miss[*tuning.best]) << bound << ' ' << tuning.policies[p];
  }
}

TEST_F(Tune, NoiseIsThatOfTheProfile) {
  const job::Tuning tuning = tuned({std::nullopt, {sim::Rational(1, 50)}});
  (void)run_job(example_.scenario(), example_.path("out"));
  const model::Mealy machine = read_controller(example_.path("out/awareness.controller.json"));
  job::ProfilePart noisy = scenario_.profiles.front();
  for (sim::FeatureSpec& feature : noisy.spec.features) {
    feature.detection = sim::Rational(49, 50);
    feature.false_detection = sim::Rational(1, 50);
  }
  const auto stop = world_.knowledge.catalogue.entity("StopSign");
  const job::Evaluation found =
      job::evaluate(scenario_, world_, noisy, machine, stop, {0, 1, 1, true, 0}, budget_);
  for (const job::TuneFigure& figure : tuning.figures)
    if (figure.profile == 0 && tuning.policies[figure.policy] == "at least 2 of sign, red, octagon") {
      EXPECT_EQ(*figure.miss.exact,
                mpq_class(found.exact.probability.front() + found.exact.probability.back()));
    }
}

TEST(TuneElsewhere, WhatAScenarioDoesNotAllowIsLeftOut) {
  const Example example;
  std::istringstream lines(read(example.scenario()));
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (line.find("stop_sign") == std::string::npos) text += line + '\n';  // nothing is read as a whole
  const job::Scenario scenario = job::read_scenario(util::SourceText(example.scenario(), text));
  util::Budget budget;
  const job::World world = job::load_world(scenario, {}, budget);
  const job::Tuning tuning = job::tune(scenario, world, {}, budget);
  ASSERT_FALSE(tuning.left_out.empty());
  EXPECT_EQ(tuning.left_out.front().policy, "read whole");
  EXPECT_FALSE(tuning.left_out.front().reason.empty());
  EXPECT_EQ(std::count(tuning.policies.begin(), tuning.policies.end(), "read whole"), 0);
  EXPECT_FALSE(tuning.figures.empty());
}

}  // namespace
}  // namespace case_study
