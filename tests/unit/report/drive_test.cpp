#include <gtest/gtest.h>
#include <heed/report/drive.h>

#include <nlohmann/json.hpp>

#include <algorithm>

#include "unit/report/xml.h"

namespace heed::report {
namespace {

DriveRoad road(std::uint64_t index, std::size_t outcome, std::optional<std::uint32_t> cells_left,
               std::optional<double> overshoot, double peak) {
  DriveRoad made;
  made.road = index;
  made.outcome = outcome;
  made.cells_left = cells_left;
  made.overshoot = overshoot;
  made.peak_deceleration = peak;
  made.peak_jerk = 2 * peak;
  made.time_lost = 1.5;
  made.least_gap = 2.5;
  return made;
}

/// Two controllers, one profile: `early` halts, `late` overshoots and misses.
DriveResult sample(const std::string& word = "early") {
  DriveResult result;
  result.scenario = word;
  result.command = "heed drive x.toml";
  result.thing = word;
  result.roads = 4;
  result.outcomes = {word + " missed", "stop in 2", "no answer"};
  result.controllers = {{"a", word}, {"b", "late"}};
  result.profiles = {{"P", word}};
  result.setting = {{"cell_metres", 10}};
  result.runs = {
      {"P",
       "a",
       {road(0, 1, 2, 0.0004, 4.8), road(1, 1, 2, -0.0001, 4.8), road(2, 1, 2, 0, 4.8),
        road(3, 1, 2, 0, 4.9)}},
      {"P",
       "b",
       {road(0, 0, 0, 10.7, 9), road(1, 0, 0, 8.7, 9), road(2, 0, {}, {}, 0), road(3, 1, 2, 0, 4.8)}}};
  result.runs[1].roads[0].collision = result.runs[1].roads[0].conflict = true;
  result.runs[1].roads[1].conflict = true;
  result.runs[1].roads[2].line_speed = 13.9;
  result.traces = {{"P", "a", 0, 1, 2, {{-50, 50}, {-20, 50}, {-5, 25}, {0, 0}}},
                   {"P", "b", 2, 0, {}, {{-50, 50}, {20, 50}}}};
  return result;
}

TEST(DriveReport, ASpreadIsOrderFree) {
  const DriveSpread found = spread({3, 1, 2});
  EXPECT_EQ(found.count, 3U);
  EXPECT_EQ(found.least, 1);
  EXPECT_EQ(found.mean, 2);
  EXPECT_EQ(found.percentile, 3);
  EXPECT_EQ(found.most, 3);
  std::vector<double> many(100);
  for (int i = 0; i < 100; ++i) many[99 - i] = i + 1;
  EXPECT_EQ(spread(many).percentile, 95);
  EXPECT_EQ(spread({}).count, 0U);
}

TEST(DriveReport, ARunIsSummedUp) {
  const DriveSummary sum = summarise(sample().runs[1], 3);
  EXPECT_EQ(sum.outcomes, (std::vector<std::uint64_t>{3, 1, 0}));
  EXPECT_EQ(sum.at_line, 1U);
  EXPECT_EQ(sum.over_line, 2U);
  EXPECT_EQ(sum.passed, 1U);
  EXPECT_EQ(sum.emergencies, 2U);
  EXPECT_EQ(sum.conflicts, 2U);
  EXPECT_EQ(sum.collisions, 1U);
  EXPECT_EQ(sum.overshoot.most, 10.7);
  EXPECT_NEAR(sum.overshoot.mean, 9.7, 1e-9);
  EXPECT_NEAR(sum.deceleration.mean, (9 + 9 + 4.8) / 3, 1e-9);
  EXPECT_EQ(sum.line_speed.mean, 13.9);
  EXPECT_EQ(sum.time_lost.count, 4U);
}

TEST(DriveReport, AbstractAndDrivenStandSideBySide) {
  const auto rows = side_by_side(sample());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].cells_left, 2U);
  EXPECT_EQ(rows[0].roads, 5U);
  EXPECT_EQ(rows[0].distance, 20);
  EXPECT_NEAR(rows[0].deceleration, 4.823, 1e-3);
  EXPECT_EQ(rows[0].peak.least, 4.8);
  EXPECT_EQ(rows[0].peak.most, 4.9);
  EXPECT_EQ(rows[1].cells_left, 0U);
  EXPECT_EQ(rows[1].distance, 0);
  EXPECT_EQ(rows[1].conflicts, 2U);
  EXPECT_FALSE(rows[2].cells_left);
  EXPECT_EQ(rows[2].passed, 1U);
}

TEST(DriveReport, TheTableHasALineForEachRoad) {
  const std::string csv = to_csv(sample("say \"early\", now"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 9);
  EXPECT_NE(csv.find("\nP,a,0,stop in 2,2,1,0.000,0.000,4.800,9.600,1.500,2.500,,0.000,0,0\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("\nP,a,1,stop in 2,2,1,0.000,"), std::string::npos) << "no -0.000";
  EXPECT_NE(csv.find("\nP,b,2,\"say \"\"early\"\", now missed\",,0,,13.900,"), std::string::npos) << csv;
  const std::string head = csv.substr(0, csv.find('\n'));
  EXPECT_EQ(std::count(head.begin(), head.end(), ','), 15);
}

TEST(DriveReport, TheSummaryHasALineForEachRun) {
  const std::string csv = summary_csv(sample());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  std::size_t begin = 0;
  std::vector<std::ptrdiff_t> commas;
  for (std::size_t end = csv.find('\n'); end != std::string::npos; end = csv.find('\n', begin)) {
    commas.push_back(std::count(csv.begin() + begin, csv.begin() + end, ','));
    begin = end + 1;
  }
  EXPECT_EQ(commas, std::vector<std::ptrdiff_t>(3, commas[0]));
}

TEST(DriveReport, TheDocumentIsJson) {
  const auto document = nlohmann::json::parse(to_json(sample("\"\\\n\xff")));
  EXPECT_EQ(document["heed"], "drive");
  EXPECT_EQ(document["runs"].size(), 2U);
  EXPECT_EQ(document["runs"][1]["halted_over_line"], 2);
  EXPECT_EQ(document["runs"][1]["overshoot_m"]["most"], 10.7);
  EXPECT_EQ(document["outcomes"][0]["abstract"]["deceleration_mps2"], 4.823);
  EXPECT_TRUE(document["outcomes"][2]["cells_left"].is_null());
}

TEST(DriveReport, PicturesAreWellFormedWhateverTheyAreTold) {
  const std::string hostile = "<script>alert('x')</script>&\"]]> \x01\xff\xE2\x80\xAE";
  for (const DriveResult& result : {sample(), sample(hostile), DriveResult{}})
    for (const std::string& picture : {speed_svg(result), braking_svg(result), metres_svg(result)}) {
      EXPECT_EQ(test::XmlReader(picture).flaw(), "");
      EXPECT_EQ(picture.find("<script"), std::string::npos);
      EXPECT_NE(picture.find("prefers-color-scheme: dark"), std::string::npos);
      EXPECT_EQ(picture.find("nan"), std::string::npos);
      EXPECT_EQ(picture.find("inf\""), std::string::npos);
      EXPECT_EQ(picture.find("url("), std::string::npos) << "asks for nothing";
    }
}

TEST(DriveReport, TheAnswerComesFirst) {
  DriveResult result = sample();
  result.controllers[1].beside = true;
  const auto sentences = headline_of(result);
  ASSERT_EQ(sentences.size(), 4U);
  EXPECT_EQ(sentences[0], "Of all roads early halts at the line on 100 % (late 25 %)");
  EXPECT_EQ(sentences[1], "It drives past without a halt on 0 % (late 25 %)");
  EXPECT_EQ(sentences[2], "It brakes harder than 6 m/s² on 0 % (late 50 %)");
  EXPECT_EQ(sentences[3], "A car behind comes within 1 s of a collision on 0 % (late 50 %)");
  result.controllers[1].beside = false;
  EXPECT_EQ(headline_of(result)[0], "Of all roads late halts at the line on 25 % (early 100 %)");
  result.followers = 0;
  EXPECT_EQ(headline_of(result).size(), 3U) << "nobody behind, nothing to say of them";
  EXPECT_TRUE(headline_of({}).empty());
}

TEST(DriveReport, TheTextFitsItsWidth) {
  const std::string text = to_text(sample("a controller with a very long name, longer than any column"));
  EXPECT_NE(text.find("10.7"), std::string::npos);
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const std::string line = text.substr(begin, end - begin);
    const auto bytes_of_more =
        std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) == 0x80; });
    EXPECT_LE(line.size() - static_cast<std::size_t>(bytes_of_more), 100U) << line;
    begin = end + 1;
  }
}

}  // namespace
}  // namespace heed::report
