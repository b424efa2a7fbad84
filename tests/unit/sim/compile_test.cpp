#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heed/util/diagnostic.h>

#include <algorithm>

#include "unit/sim/case_study.h"
#include "unit/sim/paths.h"

namespace heed::sim {
namespace {

using namespace case_study;

Chain compiled(const ProfileSpec& profile) {
  util::Budget budget;
  return compile(profile, budget);
}

/// Reported cells for persistent features with these onsets (5 = never): sign, red, octagon, stop sign.
std::vector<std::uint64_t> shown(const std::vector<int>& onsets) {
  std::vector<std::uint64_t> result(5);
  for (int cell = 0; cell < 5; ++cell)
    for (std::size_t f = 0; f < onsets.size(); ++f)
      if (onsets[f] <= cell) result[static_cast<std::size_t>(cell)] |= std::uint64_t{1} << f;
  return result;
}

// The prose: u in eighths against v = 4, 5, 6, 7, 8 eighths; one coin per feature and cell.
std::vector<std::uint64_t> first_profile(int eighth, unsigned red_coins, unsigned octagon_coins,
                                         unsigned stop_coins) {
  bool sign = false, red = false, octagon = false, stop = false;
  std::vector<std::uint64_t> result;
  for (int cell = 0; cell < 5; ++cell) {
    const bool sign_before = sign, part_before = red || octagon;
    sign = eighth < 4 + cell;
    red = red || (sign_before && (red_coins >> cell & 1));
    octagon = octagon || (sign_before && (octagon_coins >> cell & 1));
    stop = stop || (cell >= 2 && part_before && (stop_coins >> cell & 1));
    if (cell == 4) sign = red = octagon = stop = true;
    result.push_back(sign + 2U * red + 4U * octagon + 8U * stop);
  }
  return result;
}

TEST(Compile, FirstProfileIsItsProse) {
  SequenceLaw law;
  for (int eighth = 0; eighth < 8; ++eighth)
    for (unsigned red = 0; red < 16; ++red)
      for (unsigned octagon = 0; octagon < 16; ++octagon)
        for (unsigned stop = 0; stop < 16; ++stop)
          law[first_profile(eighth, red, octagon, stop)] += Rational(1, 8 * 4096);
  EXPECT_EQ(sequences(compiled(p1())), law);
}

TEST(Compile, FirstProfileReadsTheWholeBeforeAPartWithSevenSixtyFourths) {
  Rational early;
  for (const auto& [sequence, probability] : sequences(compiled(p1())))
    if (std::any_of(sequence.begin(), sequence.end(),
                    [](std::uint64_t seen) { return (seen & 8) != 0 && (seen & 6) != 6; }))
      early += probability;
  EXPECT_EQ(fraction(early), "7/64");
}

TEST(Compile, SecondProfileIsItsProse) {
  SequenceLaw law;
  for (int sign = 0; sign <= 2; ++sign)
    for (int order = 0; order < 2; ++order)
      law[shown({sign, sign + 1 + order, sign + 2 - order, sign + 3})] += Rational(1, 6);
  EXPECT_EQ(sequences(compiled(p2())), law);
}

TEST(Compile, ThirdProfileIsItsProse) {
  SequenceLaw law;
  for (int sign = 0; sign <= 3; ++sign)
    for (int octagon = sign; octagon <= 5; ++octagon)
      for (int red = octagon; red <= 5; ++red)
        for (int stop = red; stop <= 5; ++stop)
          law[shown({sign, red, octagon, stop})] +=
              Rational(1, 4) * Rational(1, 6 - sign) * Rational(1, 6 - octagon) * Rational(1, 6 - red);
  EXPECT_EQ(sequences(compiled(p3())), law);
}

TEST(Compile, ChainsAreWellFormed) {
  for (const ProfileSpec& profile : {p1(), p2(), p3()}) {
    const Chain chain = compiled(profile);
    std::uint32_t final_states = 0;
    for (std::uint32_t state = 0; state < chain.state_count(); ++state) {
      Rational sum;
      for (std::uint32_t i = chain.first[state]; i < chain.first[state + 1]; ++i) {
        sum += chain.steps[i].probability;
        EXPECT_GT(chain.steps[i].probability, 0);
        EXPECT_GT(chain.steps[i].next, state);
        if (i > chain.first[state]) {
          EXPECT_LT(std::pair(chain.steps[i - 1].seen, chain.steps[i - 1].next),
                    std::pair(chain.steps[i].seen, chain.steps[i].next));
        }
      }
      if (chain.first[state] == chain.first[state + 1])
        ++final_states;
      else
        EXPECT_EQ(sum, 1);
    }
    EXPECT_EQ(final_states, 1U);
    EXPECT_EQ(chain.features, (std::vector<std::string>{"sign", "red", "octagon", "stop_sign"}));
  }
}

// Independent geometric features need no memory but "visible or not": 2^n states per layer at most.
TEST(Compile, ForgetsWhatNoRuleNeeds) {
  ProfileSpec profile;
  profile.cells = 200;
  for (const char* name : {"a", "b", "c"})
    profile.features.push_back(feature(name, GeometricOnset{q("1/3"), 0}));
  EXPECT_LE(compiled(profile).state_count(), 200U * 8U + 1U);
}

TEST(Compile, AbsentFeaturesNeverAppearAndCountAsNever) {
  for (const auto& [sequence, probability] : sequences(compiled(without(p1(), {"octagon"}))))
    for (const std::uint64_t seen : sequence) EXPECT_EQ(seen & 4, 0U);
  // P3 without octagon: nothing follows. P2 without red: octagon stays at sign + 1 or sign + 2.
  for (const auto& [sequence, probability] : sequences(compiled(without(p3(), {"octagon"}))))
    EXPECT_LE(sequence.back(), 1U);
  SequenceLaw law;
  for (int sign = 0; sign <= 2; ++sign)
    for (int place = 1; place <= 2; ++place) law[shown({sign, 5, sign + place, sign + 3})] += Rational(1, 6);
  EXPECT_EQ(sequences(compiled(without(p2(), {"red"}))), law);
}

TEST(Compile, NothingOnTheRoad) {
  const SequenceLaw law = sequences(compiled(without(p1(), {"sign", "red", "octagon", "stop_sign"})));
  EXPECT_EQ(law, (SequenceLaw{{{0, 0, 0, 0, 0}, 1}}));
}

TEST(Compile, LooksAheadByDrawingAhead) {
  ProfileSpec profile;
  profile.cells = 3;
  profile.features = {feature("herald", FixedOnset{at("sign - 1")}),
                      feature("sign", UniformOnset{0, at("never")}),
                      feature("echo", UniformOnset{0, at("sign")})};
  SequenceLaw law;
  for (int sign = 0; sign <= 3; ++sign)
    for (int echo = 0; echo <= sign; ++echo) {
      std::vector<std::uint64_t> sequence(3);
      for (int cell = 0; cell < 3; ++cell)
        sequence[static_cast<std::size_t>(cell)] =
            (sign < 3 && sign - 1 <= cell) + 2U * (sign <= cell) + 4U * (echo <= cell);
      law[sequence] += Rational(1, 4) * Rational(1, sign + 1);
    }
  EXPECT_EQ(sequences(compiled(profile)), law);
}

TEST(Compile, TooLargeIsALimitNotACrash) {
  ProfileSpec profile;
  profile.cells = 10;
  for (int i = 0; i < 30; ++i)
    profile.features.push_back(feature(fmt::format("f{}", i), UniformOnset{0, 10}));
  util::Budget budget;
  EXPECT_THROW((void)compile(profile, budget), util::LimitExceeded);
}

std::string code(const ProfileSpec& profile) {
  try {
    (void)compiled(profile);
  } catch (const util::InputError& error) {
    return error.diagnostic().code;
  }
  return "fine";
}

ProfileSpec single(Onset onset) {
  ProfileSpec profile;
  profile.features = {feature("f", std::move(onset))};
  return profile;
}

TEST(Compile, RefusesBadNumbers) {
  EXPECT_EQ(code(single(GeometricOnset{q("3/2"), 0})), "probability-range");
  EXPECT_EQ(code(single(GeometricOnset{-1, 0})), "probability-range");
  EXPECT_EQ(code(single(LinearOnset{1, q("1/2")})), "probability-range");
  EXPECT_EQ(code(single(TableOnset{{q("1/2"), q("0.499")}, 0, 0})), "probability-sum");
  EXPECT_EQ(code(single(TableOnset{{q("1/2"), q("0.501")}, 0, 0})), "probability-sum");
  EXPECT_EQ(code(single(TableOnset{{q("1/3"), q("1/3")}, q("1/3"), 0})), "fine");
  EXPECT_EQ(code(single(UniformOnset{3, 1})), "empty-range");
  ProfileSpec noisy = single(FixedOnset{0});
  noisy.features[0].detection = 2;
  EXPECT_EQ(code(noisy), "probability-range");
}

TEST(Compile, SaysWhatATableLacks) {
  try {
    (void)compiled(single(TableOnset{{q("1/2"), q("0.4")}, 0, 0}));
    FAIL();
  } catch (const util::InputError& error) {
    EXPECT_THAT(error.diagnostic().message, testing::HasSubstr("adds up to 9/10"));
    EXPECT_THAT(error.diagnostic().hint, testing::HasSubstr("1/10"));
  }
}

TEST(Compile, RefusesBadReferences) {
  ProfileSpec profile = single(FixedOnset{at("g + 1")});
  EXPECT_EQ(code(profile), "unknown-feature");
  profile.features.push_back(feature("g", FixedOnset{at("min(2, f)")}));
  try {
    (void)compiled(profile);
    FAIL();
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "cyclic-onsets");
    EXPECT_THAT(error.diagnostic().message, testing::HasSubstr("f -> g -> f"));
  }
  EXPECT_EQ(code(single(FixedOnset{at("f")})), "cyclic-onsets");
  profile = single(FixedOnset{0});
  profile.features.push_back(feature("f", FixedOnset{1}));
  EXPECT_EQ(code(profile), "duplicate-feature");
}

TEST(Compile, NamesOnlyTheCircle) {
  ProfileSpec profile;
  profile.features = {feature("a", FixedOnset{at("b")}), feature("b", FixedOnset{at("c")}),
                      feature("c", FixedOnset{at("b + 1")})};
  try {
    (void)compiled(profile);
    FAIL();
  } catch (const util::InputError& error) {
    EXPECT_THAT(error.diagnostic().message, testing::EndsWith(": b -> c -> b"));
  }
}

TEST(Compile, PointsAtTheUnknownName) {
  const util::SourceText source("x.toml", "max(1, sgn)", 7, 20);
  ProfileSpec profile = single(FixedOnset{parse_onset(source)});
  profile.features.push_back(feature("sign", FixedOnset{0}));
  try {
    (void)compiled(profile);
    FAIL();
  } catch (const util::InputError& error) {
    EXPECT_EQ(to_string(error.diagnostic().location), "x.toml:7:27");
    EXPECT_EQ(error.diagnostic().hint, "did you mean 'sign'?");
  }
}

TEST(Compile, RefusesBadShufflesAndFrames) {
  ProfileSpec profile = p2();
  profile.shuffles[0].at.pop_back();
  EXPECT_EQ(code(profile), "bad-shuffle");
  profile = p2();
  profile.shuffles.push_back(profile.shuffles[0]);
  EXPECT_EQ(code(profile), "bad-shuffle");
  profile = p2();
  profile.shuffles.clear();
  EXPECT_EQ(code(profile), "bad-shuffle");
  profile = p2();
  profile.shuffles[0].features[1] = "octogon";
  EXPECT_EQ(code(profile), "unknown-feature");
  profile = p2();
  profile.features[1].onset = FixedOnset{0};
  EXPECT_EQ(code(profile), "duplicate-feature");
  profile = p1();
  profile.everything_visible_in = 5;
  EXPECT_EQ(code(profile), "bad-cells");
  profile.cells = 0;
  EXPECT_EQ(code(profile), "bad-cells");
  profile = {};
  for (int i = 0; i < 65; ++i) profile.features.push_back(feature(fmt::format("f{}", i), FixedOnset{0}));
  EXPECT_EQ(code(profile), "too-many-features");
}

// Visible all the way, read well only from near by: 1/2, 3/4, 1.
TEST(Compile, DetectionThatGrowsWithNearness) {
  ProfileSpec profile;
  profile.cells = 3;
  profile.features = {feature("sign", FixedOnset{0})};
  profile.features[0].detection = q("1/2");
  profile.features[0].detection_at_end = 1;
  util::Budget budget;
  EXPECT_EQ(sequences(compile(profile, budget)),
            (SequenceLaw{{{0, 0, 1}, q("1/8")}, {{0, 1, 1}, q("3/8")}, {{1, 1, 1}, q("1/2")}}));
  profile.features[0].persistent = false;
  EXPECT_EQ(sequences(compile(profile, budget)),
            (SequenceLaw{
                {{0, 0, 1}, q("1/8")}, {{0, 1, 1}, q("3/8")}, {{1, 0, 1}, q("1/8")}, {{1, 1, 1}, q("3/8")}}));
}

}  // namespace
}  // namespace heed::sim
