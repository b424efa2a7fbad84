// One feature read as another: by hand where that is short, else samples against the exact distribution. The
// chains themselves are held against an enumeration in random_profile_test.cpp.
#include <gtest/gtest.h>
#include <heed/sim/exact.h>
#include <heed/sim/lumping.h>
#include <heed/sim/sample.h>
#include <heed/sim/statistics.h>
#include <heed/util/diagnostic.h>

#include "unit/sim/case_study.h"
#include "unit/sim/paths.h"

namespace heed::sim {
namespace {

using namespace case_study;

ProfileSpec two_cells(bool persistent, bool per_approach) {
  ProfileSpec profile;
  profile.cells = 2;
  profile.persistent = persistent;
  profile.features = {feature("f", FixedOnset{0}), feature("g", FixedOnset{0})};
  profile.features[1].absent = true;
  profile.misreadings = {{"f", "g", q("1/4"), {}, per_approach}};
  return profile;
}

SequenceLaw law(const ProfileSpec& profile) {
  util::Budget budget;
  return sequences(compile(profile, budget));
}

TEST(Misreading, EachCellAnewWhereNothingStays) {
  const SequenceLaw expected{
      {{1, 1}, q("9/16")}, {{1, 2}, q("3/16")}, {{2, 1}, q("3/16")}, {{2, 2}, q("1/16")}};
  EXPECT_EQ(law(two_cells(false, false)), expected);
}

TEST(Misreading, TheFirstRightReadingStays) {
  const SequenceLaw expected{{{1, 1}, q("3/4")}, {{2, 1}, q("3/16")}, {{2, 2}, q("1/16")}};
  EXPECT_EQ(law(two_cells(true, false)), expected);
}

TEST(Misreading, OnceForTheWholeApproach) {
  const SequenceLaw expected{{{1, 1}, q("3/4")}, {{2, 2}, q("1/4")}};
  EXPECT_EQ(law(two_cells(true, true)), expected);
  EXPECT_EQ(law(two_cells(false, true)), expected);
}

TEST(Misreading, NearerIsReadBetter) {
  ProfileSpec profile = two_cells(false, false);
  profile.misreadings[0].probability_at_end = 0;
  const SequenceLaw expected{{{1, 1}, q("3/4")}, {{2, 1}, q("1/4")}};
  EXPECT_EQ(law(profile), expected);
}

TEST(Misreading, WhatIsNotThereIsNotMisread) {
  ProfileSpec profile = two_cells(false, false);
  profile.features[0].replaced = true;
  profile.features[0].false_detection = q("1/2");
  for (const auto& [reports, probability] : law(profile))
    for (const std::uint64_t seen : reports) EXPECT_EQ(seen & 2, 0U);
}

void expect_refused(ProfileSpec profile, const std::vector<Misreading>& misreadings,
                    const std::string& code) {
  profile.misreadings = misreadings;
  util::Budget budget;
  try {
    (void)compile(profile, budget);
    ADD_FAILURE() << code;
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, code);
  }
}

TEST(Misreading, RefusesWhatDoesNotAddUp) {
  const ProfileSpec profile = p1();
  expect_refused(profile, {{"red", "sign", q("1/2")}, {"red", "octagon", q("2/3")}}, "probability-sum");
  expect_refused(profile, {{"red", "sign", q("0"), q("1/2")}, {"red", "octagon", q("0"), q("2/3")}},
                 "probability-sum");
  expect_refused(profile, {{"red", "red", q("1/2")}}, "misread-as-itself");
  expect_refused(profile, {{"red", "reed", q("1/2")}}, "unknown-feature");
  expect_refused(profile, {{"red", "sign", q("3/2")}}, "probability-range");
  expect_refused(profile, {{"red", "sign", q("1/9")}, {"red", "sign", q("1/9")}}, "duplicate-feature");
}

/// The case study's profiles, their parts misread in both ways.
std::vector<Chart> misread_charts() {
  std::vector<Chart> all;
  for (ProfileSpec profile : {p1(), p2(), p3()}) {
    profile.misreadings = {{"octagon", "stop_sign", q("1/5"), q("1/20")},
                           {"sign", "red", q("1/10"), {}, true},
                           {"red", "octagon", q("1/4")}};
    all.push_back(chart(profile, "base", base, {}));
    all.push_back(chart(profile, "tree", tree, {}));
    all.push_back(chart(profile, "awareness", awareness, {}));
  }
  return all;
}

TEST(Misreading, SamplesAgreeAndACorruptedAnalysisFails) {
  for (const Chart& chart : misread_charts()) {
    util::Budget budget;
    const Sampler sampler(chart.run(), budget);
    std::vector<double> exact;
    for (const Rational& p : exact_outcome(chart.run(), budget).probability) exact.push_back(to_double(p));
    std::vector<std::uint64_t> pooled(exact.size());
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const SampleOutcome drawn = sampler.sample({10'000, seed, 0, 1, nullptr}, budget);
      EXPECT_GT(chi_square(drawn.count, exact).p_value, 1e-6) << chart.name << " seed " << seed;
      for (std::size_t i = 0; i < pooled.size(); ++i) pooled[i] += drawn.count[i];
    }
    EXPECT_GT(chi_square(pooled, exact).p_value, 1e-6) << chart.name;
    exact[0] += 0.005;
    exact[1] -= 0.005;
    EXPECT_LT(chi_square(pooled, exact).p_value, 1e-6) << chart.name;
  }
}

TEST(Misreading, LumpsAsItIs) {
  ProfileSpec profile = p3();
  profile.misreadings = {{"octagon", "red", q("1/5")}, {"red", "stop_sign", q("1/3"), {}, true}};
  const Chart made = chart(profile, "awareness", awareness, {});
  util::Budget budget;
  const auto lumped = lumped_outcome(profile, made.mealy, made.wiring, made.judgement, {}, budget);
  const ExactOutcome whole = exact_outcome(made.run(), budget);
  for (std::size_t c = 0; c < whole.probability.size(); ++c)
    EXPECT_EQ(*lumped.probability[c].exact, whole.probability[c]);
}

}  // namespace
}  // namespace heed::sim
