// Expectations along roads, and distances of reactions, against the enumeration of all traces: two signs one
// after the other, where what was seen at the end of the first approach is what was seen a step before the
// second.
#include "enumeration.h"
#include "workshop.h"

#include <heed/job/road.h>
#include <heed/sim/rational.h>

#include <gtest/gtest.h>

#include <array>

namespace case_study {
namespace {

struct Sign30 {
  const char* name;
  unsigned shows;  ///< What reaches the controller's inputs.
};
constexpr Sign30 stop{"StopSign", Sign | Colour | Shape | Whole};
constexpr Sign30 limit{"speed limit 30", Sign | Colour};

/// Where the first detection of an approach is, cells if nowhere; \p before goes along.
std::size_t first_detection(const Trace& trace, unsigned shows, const Detects& detects, unsigned& before) {
  std::size_t first = cells;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const unsigned now = trace.seen[cell] & shows;
    if (first == cells && detects(now, before)) first = cell;
    before = now;
  }
  return first;
}

struct Expected {
  mpq_class needless = 0, misses = 0;
};

Expected enumerated(const Traces& traces, const std::array<Sign30, 2>& road, const Detects& detects) {
  Expected expected;
  const auto count = [&](const Sign30& sign, std::size_t cell, const mpq_class& p) {
    if (sign.shows == stop.shows && cell + 1 >= cells) expected.misses += p;
    if (sign.shows == limit.shows && cell < cells) expected.needless += p;
  };
  for (const Trace& one : traces) {
    unsigned before = 0;
    count(road[0], first_detection(one, road[0].shows, detects, before), one.probability);
    for (const Trace& two : traces) {
      unsigned then = before;
      count(road[1], first_detection(two, road[1].shows, detects, then), one.probability * two.probability);
    }
  }
  return expected;
}

class Roads : public testing::Test {
 protected:
  Roads() : outcome_(run_job(example_.scenario(), example_.path("out"))) {
    world_ = job::load_world(outcome_.scenario, {}, budget_);
  }

  Example example_;
  Outcome outcome_;
  util::Budget budget_;
  job::World world_;
};

TEST_F(Roads, TwoSignsOneAfterTheOther) {
  const std::vector<std::pair<const char*, Detects>> controllers{
      {"base", base_detects}, {"tree", tree_detects}, {"awareness", two_of(Sign | Colour | Shape)}};
  job::Approaches approaches(world_, budget_);
  for (const auto& [name, detects] : controllers) {
    const model::Mealy machine =
        read_controller(example_.path(std::string("out/") + name + ".controller.json"));
    for (const job::ProfilePart& profile : outcome_.scenario.profiles)
      for (const auto& signs : {std::array{stop, stop}, std::array{limit, stop}, std::array{stop, limit}}) {
        job::RoadPart road;
        for (const Sign30& sign : signs) road.places.push_back({{{sign.name, {}}, 1}});
        road.length = 2;
        const Expected expected = enumerated(traces_of(profile.spec.name), signs, detects);
        const job::RoadEvaluation found =
            job::evaluate_road(outcome_.scenario, world_, profile, road, machine, approaches, budget_);
        const std::string what = profile.spec.name + " " + name + " " + signs[0].name + " " + signs[1].name;
        EXPECT_EQ(found.needless, expected.needless) << what;
        EXPECT_EQ(found.misses, expected.misses) << what;
        EXPECT_EQ(found.missing, 0) << what;
        EXPECT_FALSE(found.conflict) << what;
      }
  }
}

TEST_F(Roads, DistancesOfTheReactionAreThoseOfTheDistribution) {
  for (const report::Chart& chart : outcome_.result.charts) {
    mpq_class mean = 0;
    for (std::size_t n = 1; n < chart.bars.size(); ++n)
      mean += static_cast<unsigned long>(n) * mpq_class(chart.bars[n].exact.exact);
    ASSERT_TRUE(chart.reaction);
    EXPECT_EQ(chart.reaction->exact, mean.get_str()) << chart.profile << ' ' << chart.controller;
  }
}

/// Half nothing, a tenth stop signs, the rest any: by linearity where nothing is carried over, as for base.
TEST_F(Roads, TownAddsUpWhatTheCatalogueSays) {
  const auto& roads = outcome_.result.roads;
  ASSERT_EQ(roads.size(), 1U);
  for (const report::Drive& drive : roads.front().drives) {
    if (drive.controller != "base") continue;
    mpq_class misses = 0, leaves = 0, at_stop = 0;
    for (const report::CatalogueEntry& entry : outcome_.result.catalogue) {
      if (entry.name.empty()) continue;
      ++leaves;
      for (const report::Encounter& encounter : entry.encounters) {
        if (encounter.profile != drive.profile || encounter.controller != "base" || !encounter.miss) continue;
        misses += mpq_class(encounter.miss->exact);
        if (entry.label == "stop") at_stop = mpq_class(encounter.miss->exact);
      }
    }
    const mpq_class expected = 20 * (mpq_class(1, 10) * at_stop + mpq_class(2, 5) * misses / leaves);
    EXPECT_EQ(mpq_class(drive.misses.exact), expected) << drive.profile;
    EXPECT_EQ(mpq_class(drive.long_misses->exact), mpq_class(expected / 20)) << drive.profile;
    EXPECT_EQ(drive.needless.exact, "0");
  }
}

}  // namespace
}  // namespace case_study
