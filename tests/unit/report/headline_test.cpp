#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heed/report/result.h>

#include "unit/report/sample.h"

namespace heed::report {

namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Headline, SaysTheFiguresOfTheCaseStudy) {
  const std::vector<std::string> expected{
      "Awareness misses 297, 0 and 475 of 1,000 approaches (P1, P2, P3) and reacts needlessly to 2 of 8 "
      "signs",
      "What “at least 2” costs: past what asks for no reaction (mean over 43 things) it reacts in 51.2 % "
      "everywhere",
      "None of the 2 other policies compared makes fewer errors of one kind without more of the other",
      "The fewest misses with needless reactions in 10 % at most: “tree-or-full”, which misses 36.7 % (P1), "
      "16.7 % (P2) and reacts needlessly in 0 % everywhere",
      "It reacts needlessly to 2 of 8 signs, at worst with probability 50 % (No entry); base 0, perception "
      "tree 1",
      "Awareness misses the stop sign least often in all 3 perception profiles",
      "Awareness misses the stop sign in 29.7 % of approaches in P1 (perception tree 40.6 %, base 62.5 %)",
      "Awareness misses the stop sign in 0 % of approaches in P2 (perception tree 16.7 %, base 66.7 %)",
      "Awareness misses the stop sign in 47.5 % of approaches in P3 (perception tree 78.9 %, base 90.1 %)",
      "All 3 controllers passed the independent check",
      "90,000 sampled traces agree with the exact figures (smallest p of 9 charts = 0.3)"};
  EXPECT_EQ(headline_of(sample::result()), expected);
}

TEST(Headline, ChoosesTheSubjectByItsMisses) {
  RunResult result = sample::result();
  result.subject.clear();
  EXPECT_THAT(headline_of(result), Contains(HasSubstr("Awareness misses the stop sign least often")));
}

TEST(Headline, DoesNotClaimWhatTheFiguresDoNotSay) {
  RunResult result = sample::result();
  result.subject = "tree";
  EXPECT_THAT(headline_of(result),
              Contains("Perception tree misses the stop sign least often in 0 of 3 perception profiles"));
  result.subject = "awareness";
  result.charts[2].bars[0].exact.value = 0.5;
  EXPECT_THAT(headline_of(result),
              Contains("Awareness misses the stop sign least often in 2 of 3 perception profiles"));
}

TEST(Headline, ControllersBesideDoNotCompete) {
  RunResult result = sample::result();
  result.controllers[1].beside = true;
  EXPECT_THAT(headline_of(result),
              Contains("Awareness misses the stop sign in 0 % of approaches in P2 (base 66.7 %)"));
}

TEST(Headline, SaysWhatIsRefutedOrImpossible) {
  RunResult result = sample::result();
  result.controllers[0].verdict = Verdict::Refuted;
  result.controllers[1].verdict = Verdict::Unrealizable;
  result.controllers[1].reasons = {"the car cannot stop from M1"};
  const auto sentences = headline_of(result);
  EXPECT_THAT(sentences, Contains("Base is refuted by the independent check"));
  EXPECT_THAT(sentences, Contains("No controller exists for perception tree: the car cannot stop from M1"));
  EXPECT_THAT(sentences, Contains("1 of 3 controllers passed the independent check"));
  EXPECT_THAT(sentences, Not(Contains(HasSubstr("base 66.7"))));
}

TEST(Headline, IsShortWhereNothingCanBeBuilt) {
  RunResult result = sample::result();
  for (Controller& controller : result.controllers) {
    controller.verdict = Verdict::Unrealizable;
    controller.reasons = {"in M1 there is no way out"};
  }
  result.charts.clear();
  const auto sentences = headline_of(result);
  ASSERT_EQ(sentences.size(), 4U);
  EXPECT_EQ(sentences[0], "No controller exists");
  EXPECT_EQ(sentences[1], "Base: in M1 there is no way out");
}

TEST(Headline, AdmitsThatSamplingContradicts) {
  RunResult result = sample::result();
  result.charts[4].p_value = 1e-9;
  EXPECT_THAT(headline_of(result),
              Contains("Sampling contradicts the exact figures in 1 chart (smallest p = 1e-09)"));
}

TEST(Headline, NeverRoundsToACertainty) {
  RunResult result = sample::result();
  result.charts[5].bars[0].exact = {"1/100000", 1e-5, 0};
  EXPECT_THAT(headline_of(result), Contains(HasSubstr("in <0.1 % of approaches in P2")));
}

TEST(Headline, NamesThePolicyThatIsBetterInBoth) {
  RunResult result = sample::result();
  for (TunedPolicy& one : result.tuning.figures)
    if (one.policy == "tree-or-full") one.miss = sample::rational("0");
  EXPECT_THAT(headline_of(result), Contains("“tree-or-full” is better in both: it misses 0 % everywhere and "
                                            "reacts needlessly in 0 % everywhere"));
  result.tuning = {};
  EXPECT_THAT(headline_of(result), Not(Contains(HasSubstr("costs: past"))));
}

TEST(Headline, StopsOnTheOpenRoad) {
  RunResult result = sample::result();
  result.catalogue[0].encounters[8].needless = Number{"1/2", 0.5, 0};
  EXPECT_THAT(headline_of(result), Contains("It also reacts where there is no sign at all"));
}

TEST(Headline, EmptyWhereThereIsNothingToSay) {
  EXPECT_TRUE(headline_of(RunResult{}).empty());
}

TEST(SpeedPicture, DecelerationIsThatOfTheEnergy) {
  const SpeedPicture picture = speed_picture(10, 50, 4);
  ASSERT_EQ(picture.curves.size(), 4u);
  const double joules_per_kilogram = (50 / 3.6) * (50 / 3.6) / 2;
  for (const SpeedCurve& curve : picture.curves) {
    EXPECT_NEAR(curve.deceleration * 10 * curve.cells, joules_per_kilogram, 1e-9);
    EXPECT_EQ(curve.points.front().metres_to_sign, 40);
    EXPECT_EQ(curve.points.front().kmh, 50);
    EXPECT_EQ(curve.points.back().metres_to_sign, 0);
    EXPECT_EQ(curve.points.back().kmh, 0);
    for (const SpeedCurve::Point& point : curve.points) {
      const double left = std::min(1.0, point.metres_to_sign / (10 * curve.cells));
      EXPECT_NEAR(point.kmh, 50 * std::sqrt(left), 1e-9);
    }
  }
  EXPECT_NEAR(picture.curves[0].deceleration, 9.645, 1e-3);
}

}  // namespace

}  // namespace heed::report
