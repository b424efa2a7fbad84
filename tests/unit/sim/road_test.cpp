// Expectations over roads against enumeration of everything that may be reported, and against sampling.
#include <gtest/gtest.h>
#include <heed/sim/exact.h>
#include <heed/sim/road.h>
#include <heed/util/random.h>

#include <cmath>

#include "../src/sim/long_run.h"
#include "unit/sim/lumping_cases.h"
#include "unit/sim/paths.h"

namespace heed::sim {
namespace {

using namespace case_study;
using lumping_cases::Case;
using lumping_cases::Maker;

/// Two kinds of things: that of the random profile, and one that lacks its first feature.
struct Setting {
  explicit Setting(std::uint64_t seed) : made(Maker(seed).make()) {
    made.profile.cells = 2;
    made.profile.everything_visible_in.reset();
    util::Budget budget;
    there = compile(made.profile, budget);
    lacking = compile(without(made.profile, {made.profile.features.front().name}), budget);
    for (std::size_t t = 0; t < made.machine.transitions.size(); ++t) conflict.push_back(t % 7 == 3);
  }
  [[nodiscard]] RoadRun run() const {
    return {made.machine, {{&there, &made.wiring}, {&lacking, &made.wiring}}, made.judgement, conflict};
  }

  Case made;
  Chain there, lacking;
  std::vector<bool> conflict;
};

/// One drive, step by step, as the definition says.
struct Drive {
  explicit Drive(const Setting& setting) : setting_(setting) { take(setting.made.wiring.blank); }

  void approach(const std::vector<std::uint64_t>& sequence) {
    category = Judge::none;
    conflict_now = false;
    for (const std::uint64_t seen : sequence) {
      model::Valuation values = setting_.made.wiring.blank;
      for (const Binding::Wire& wire : setting_.made.wiring.wires)
        if (seen >> wire.feature & 1) values[wire.input] = wire.value;
      take(values);
    }
    if (category == Judge::none && !missing) category = setting_.made.judgement.never;
  }

  std::uint32_t category = Judge::none;
  bool conflict_now = false, missing = false;

 private:
  void take(const model::Valuation& values) {
    const auto letter = setting_.made.machine.input_letter(values);
    const auto* row = letter && !missing ? setting_.made.machine.find(state_, *letter) : nullptr;
    missing = row == nullptr;
    if (missing) return;
    const auto index = static_cast<std::size_t>(row - setting_.made.machine.transitions.data());
    state_ = row->next;
    if (category == Judge::none) category = setting_.made.judgement.event[index];
    conflict_now = conflict_now || setting_.conflict[index];
  }

  const Setting& setting_;
  std::uint32_t state_ = 0;
};

RoadOutcome nothing(const Setting& setting) {
  RoadOutcome outcome;
  outcome.expected.assign(2, std::vector<Rational>(setting.made.judgement.categories.size(), 0));
  return outcome;
}

void count(const Drive& drive, std::size_t kind, const Rational& p, bool& conflicted, RoadOutcome& outcome) {
  if (drive.category != Judge::none) outcome.expected[kind][drive.category] += p;
  if (drive.conflict_now) outcome.conflicts += p;
  if (drive.conflict_now && !conflicted) outcome.conflict += p;
  conflicted = conflicted || drive.conflict_now;
  if (drive.missing) outcome.missing += p;
}

/// Every kind and every sequence of reports at two places.
RoadOutcome enumerated(const Setting& setting, const std::vector<Draw>& places) {
  RoadOutcome outcome = nothing(setting);
  const std::vector<SequenceLaw> laws{sequences(setting.there), sequences(setting.lacking)};
  if (Drive(setting).missing) {
    outcome.missing = 1;
    return outcome;
  }
  for (std::size_t first = 0; first < 2; ++first)
    for (const auto& [one, p] : laws[first]) {
      Drive drive(setting);
      drive.approach(one);
      bool conflicted = false;
      const Rational share = places[0][first] * p;
      count(drive, first, share, conflicted, outcome);
      if (drive.missing) continue;
      for (std::size_t second = 0; second < 2; ++second)
        for (const auto& [two, r] : laws[second]) {
          Drive further = drive;
          further.approach(two);
          bool before = conflicted;
          count(further, second, share * places[1][second] * r, before, outcome);
        }
    }
  return outcome;
}

void expect_same(const RoadOutcome& found, const RoadOutcome& expected, std::uint64_t seed) {
  EXPECT_EQ(found.expected, expected.expected) << "seed " << seed;
  EXPECT_EQ(found.conflicts, expected.conflicts) << "seed " << seed;
  EXPECT_EQ(found.conflict, expected.conflict) << "seed " << seed;
  EXPECT_EQ(found.missing, expected.missing) << "seed " << seed;
}

TEST(Road, EqualsTheEnumeration) {
  const std::vector<Draw> places{{q("1/4"), q("3/4")}, {q("2/3"), q("1/3")}};
  int conflicts = 0, endings = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const Setting setting(seed);
    util::Budget budget;
    const RoadOutcome expected = enumerated(setting, places);
    expect_same(RoadAnalysis(setting.run(), budget).over(places), expected, seed);
    conflicts += expected.conflict > 0 && expected.conflict != expected.conflicts;
    endings += expected.missing > 0 && expected.missing < 1;
    if (HasFailure()) break;
  }
  EXPECT_GT(conflicts, 20);
  EXPECT_GT(endings, 10);
}

TEST(Road, OneApproachIsTheExactOutcome) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Setting setting(seed);
    util::Budget budget;
    const RoadOutcome found = RoadAnalysis(setting.run(), budget).over({{1, 0}});
    const ExactOutcome one = exact_outcome(
        {setting.there, setting.made.machine, setting.made.wiring, setting.made.judgement}, budget);
    Rational events = 0;
    for (const Rational& p : one.event_at) events += p;
    // An event in the blank observation belongs to no approach.
    if (one.event_at.front() == 0) {
      EXPECT_EQ(found.expected[0], one.probability) << "seed " << seed;
    }
    EXPECT_EQ(found.missing, one.missing) << "seed " << seed;
    EXPECT_LE(events, 1);
  }
}

// The average over places 25 ... 72 is near the long run's where what came before has been forgotten; all
// periods up to 4 divide 48.
TEST(Road, LongRunIsWhatLongRoadsTendTo) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Setting setting(seed);
    util::Budget budget;
    RoadAnalysis analysis(setting.run(), budget);
    const Draw draw{q("1/2"), q("1/2")};
    const auto found = analysis.in_the_long_run({draw});
    ASSERT_TRUE(found);
    const RoadOutcome some = analysis.over(std::vector<Draw>(24, draw));
    const RoadOutcome more = analysis.over(std::vector<Draw>(72, draw));
    if (more.missing != some.missing) continue;
    ++compared;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t c = 0; c < some.expected[k].size(); ++c)
        EXPECT_NEAR(to_double(found->expected[k][c]),
                    to_double(Rational(more.expected[k][c] - some.expected[k][c])) / 48, 2e-3)
            << "seed " << seed;
    if (HasFailure()) break;
  }
  EXPECT_GT(compared, 25);
}

TEST(Road, SharesOfAChainWithAPeriodAndTwoEndsByHand) {
  // 0 leaves for {1, 2}, which swap, with 1/4, for 3, which stays, with 1/4, else waits.
  const TransitionMatrix matrix{{q("1/2"), q("1/4"), 0, q("1/4")}, {0, 0, 1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}};
  util::Budget budget;
  EXPECT_EQ(long_run_shares(matrix, budget), (std::vector<Rational>{0, q("1/4"), q("1/4"), q("1/2")}));
  // Recurrent as a whole: weights 2 : 3.
  EXPECT_EQ(long_run_shares({{q("1/2"), q("1/2")}, {q("1/3"), q("2/3")}}, budget),
            (std::vector<Rational>{q("2/5"), q("3/5")}));
  EXPECT_EQ(long_run_shares({{1}}, budget), (std::vector<Rational>{1}));
}

/// One sequence of reports by chance.
std::vector<std::uint64_t> drawn(const Chain& chain, util::CounterRandom& random) {
  std::vector<std::uint64_t> sequence;
  for (std::uint32_t state = 0; sequence.size() < chain.cells;) {
    double u = random() * 0x1p-32;
    std::uint32_t i = chain.first[state];
    for (; i + 1 < chain.first[state + 1] && u >= to_double(chain.steps[i].probability); ++i)
      u -= to_double(chain.steps[i].probability);
    sequence.push_back(chain.steps[i].seen);
    state = chain.steps[i].next;
  }
  return sequence;
}

// Three places, 20,000 drives: five standard errors, seeds fixed.
TEST(Road, SamplesAgreeWithTheExpectations) {
  const std::vector<Draw> places(3, {q("1/2"), q("1/2")});
  for (const std::uint64_t seed : {2U, 5U, 11U, 17U}) {
    const Setting setting(seed);
    util::Budget budget;
    const RoadOutcome exact = RoadAnalysis(setting.run(), budget).over(places);
    std::vector<double> sum(setting.made.judgement.categories.size()), squares(sum.size());
    constexpr int drives = 20'000;
    for (int i = 0; i < drives; ++i) {
      util::CounterRandom random(seed, static_cast<std::uint64_t>(i));
      std::vector<double> here(sum.size());
      Drive drive(setting);
      for (std::size_t place = 0; place < places.size() && !drive.missing; ++place) {
        const bool lacks = random.below(2) == 1;
        drive.approach(drawn(lacks ? setting.lacking : setting.there, random));
        if (lacks && drive.category != Judge::none) ++here[drive.category];
      }
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += here[c], squares[c] += here[c] * here[c];
    }
    for (std::size_t c = 0; c < sum.size(); ++c) {
      const double mean = sum[c] / drives;
      const double error = std::sqrt((squares[c] / drives - mean * mean) / drives);
      EXPECT_NEAR(to_double(exact.expected[1][c]), mean, 5 * error + 1e-9) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace heed::sim
