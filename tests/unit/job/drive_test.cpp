// `heed drive`: the table [drive] of a scenario, and that what is driven is what is analysed.
#include <heed/job/drive.h>
#include <heed/job/evaluate.h>
#include <heed/sim/traffic.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "temporary_folder.h"

namespace heed::job {
namespace {

const std::string stop_sign = std::string(HEED_SOURCE_DIR) + "/examples/stop-sign/stop-sign.toml";
const std::string speed_levels = std::string(HEED_SOURCE_DIR) + "/examples/stop-sign/speed-levels.toml";
const std::string module_path = HEED_BINARY_DIR "/lib/heed/libheed_sumo.so";

/// The stop sign with a table [drive] of these lines.
Scenario scenario_with(const std::string& lines) {
  const std::string text = util::read_file(stop_sign).text() + "\n[drive]\n" + lines + "\n";
  return read_scenario(util::SourceText(stop_sign, text));
}

bool has_sumo() {
  try {
    (void)sim::load_sumo(module_path);
    return true;
  } catch (const util::InputError&) {
    return false;
  }
}

Driven driven(const std::string& path, std::uint32_t roads, const std::string& output = {}) {
  DriveOptions options;
  options.roads = roads;
  options.output = output;
  options.sumo = module_path;
  util::Budget budget;
  return drive(read_scenario(util::read_file(path)), options, budget);
}

TEST(Drive, EveryKeyHasADefault) {
  const Scenario scenario = read_scenario(util::read_file(stop_sign));
  EXPECT_EQ(scenario.drive.roads, 1000U);
  EXPECT_EQ(scenario.drive.setting.cell, 10) << "that of [evaluate]";
  EXPECT_NEAR(scenario.drive.setting.speed, 50 / 3.6, 1e-12);
  EXPECT_FALSE(scenario.drive.stop);
}

TEST(Drive, KeysAreRead) {
  const DrivePart part =
      scenario_with(
          "roads = 7\nseed = 3\ncell_metres = 20\nspeed_kmh = 72\nstep_seconds = 0.1\n"
          "most_deceleration = 8\nfollowers = 2\nheadway_seconds = [0.5, 1.5]\nbrake_seconds = 0\n"
          "reaction_seconds = 1\nslow = [{ when = \"X moving\", kmh = 36 }]\nstop = \"X stopping\"")
          .drive;
  EXPECT_EQ(part.roads, 7U);
  EXPECT_EQ(part.seed, 3U);
  EXPECT_EQ(part.setting.cell, 20);
  EXPECT_NEAR(part.setting.speed, 20, 1e-9);
  EXPECT_EQ(part.setting.followers, 2U);
  EXPECT_EQ(part.setting.shortest_headway, 0.5);
  EXPECT_EQ(part.setting.longest_headway, 1.5);
  EXPECT_EQ(part.setting.shortest_reaction, 1);
  EXPECT_EQ(part.setting.longest_reaction, 1);
  ASSERT_EQ(part.slow.size(), 1U);
  EXPECT_NEAR(part.slow[0].speed, 10, 1e-9);
  EXPECT_TRUE(part.stop);
}

TEST(Drive, BadValuesAreRefusedWhereTheyStand) {
  struct Case {
    std::string line, code;
  };
  const std::vector<Case> cases{{"roads = 0", "out-of-range"},
                                {"roads = 1.5", "wrong-type"},
                                {"cell_metres = 0", "out-of-range"},
                                {"speed_kmh = \"fast\"", "wrong-type"},
                                {"step_seconds = 0.0305", "bad-step"},
                                {"step_seconds = 0.5", "bad-step"},
                                {"most_deceleration = -9", "out-of-range"},
                                {"comfortable_deceleration = 10", "out-of-range"},
                                {"brake_seconds = -0.1", "out-of-range"},
                                {"followers = 6", "out-of-range"},
                                {"headway_seconds = [2, 1]", "out-of-range"},
                                {"headway_seconds = [1]", "out-of-range"},
                                {"reaction_seconds = -1", "out-of-range"},
                                {"slow = [{ when = \"X moving\", kmh = 60 }]", "out-of-range"},
                                {"slow = [{ when = \"X moving\", kmh = 4 }]", "out-of-range"},
                                {"slow = [{ when = \"X moving\" }]", "missing-key"},
                                {"rodas = 5", "unknown-key"},
                                {"seed = -1", "out-of-range"}};
  const std::string before = util::read_file(stop_sign).text();
  const auto line = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n') + 3);
  for (const Case& one : cases) {
    try {
      (void)scenario_with(one.line);
      FAIL() << one.line;
    } catch (const util::InputError& error) {
      EXPECT_EQ(error.diagnostic().code, one.code) << one.line;
      EXPECT_EQ(error.diagnostic().location.line, line) << one.line;
      EXPECT_GT(error.diagnostic().location.column, 0U) << one.line;
      EXPECT_FALSE(error.diagnostic().hint.empty()) << one.line;
    }
  }
}

TEST(Drive, WithoutTheSimulatorItSaysSo) {
  DriveOptions options;
  options.sumo = "/nowhere/libheed_sumo.so";
  util::Budget budget;
  try {
    (void)drive(read_scenario(util::read_file(stop_sign)), options, budget);
    FAIL();
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "no-sumo");
  }
}

TEST(Drive, AMachineThatDrivesOnNoRoadIsRefused) {
  const std::string path = std::string(HEED_SOURCE_DIR) + "/examples/warehouse/warehouse.toml";
  util::Budget budget;
  try {
    (void)drive(read_scenario(util::read_file(path)), {}, budget);
    FAIL();
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "no-road");
  }
}

TEST(Drive, NamesAreChecked) {
  DriveOptions options;
  options.profiles = {"P7"};
  util::Budget budget;
  EXPECT_THROW((void)drive(read_scenario(util::read_file(stop_sign)), options, budget), util::InputError);
}

TEST(Drive, FormulasAreCheckedAgainstThePlant) {
  if (!has_sumo()) GTEST_SKIP() << "built without SUMO (scripts/setup extras)";
  DriveOptions options;
  options.sumo = module_path;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"slow = [{ when = \"movng\", kmh = 30 }]", "moving"},
      {"stop = \"F stopping\"", "'F stopping' cannot be decided in one step"}};
  for (const auto& [line, told] : cases) {
    util::Budget budget;
    try {
      (void)drive(scenario_with(line), options, budget);
      FAIL() << line;
    } catch (const util::InputError& error) {
      EXPECT_NE(util::to_string(error.diagnostic()).find(told), std::string::npos) << error.what();
      EXPECT_GT(error.diagnostic().location.line, 100U);
    }
  }
}

/// How often each outcome occurs among the same draws without a road: as `heed simulate` counts.
std::vector<std::uint64_t> sampled(const Scenario& scenario, const World& world, const ProfilePart& profile,
                                   const model::Mealy& machine, std::uint64_t roads) {
  util::Budget budget;
  EvaluateOptions options;
  options.traces = roads;
  options.seed = scenario.evaluate->seed;
  const std::size_t thing = world.knowledge.catalogue.entity("StopSign");
  return evaluate(scenario, world, profile, machine, thing, options, budget).sampled.count;
}

void expect_sampled_outcomes(const std::string& path) {
  constexpr std::uint32_t roads = 200;
  const report::DriveResult result = driven(path, roads).result;
  const Scenario scenario = read_scenario(util::read_file(path));
  util::Budget budget;
  const World world = load_world(scenario, {}, budget);
  std::size_t compared = 0;
  for (const ControllerPart& part : scenario.controllers) {
    const auto machine = synthesize(design(scenario, world, part), Violation::Drop, budget).result.machine;
    for (const ProfilePart& profile : scenario.profiles)
      for (const report::DriveRun& run : result.runs) {
        if (run.profile != profile.spec.name || run.controller != part.name.text) continue;
        std::vector<std::uint64_t> counts(result.outcomes.size());
        for (const report::DriveRoad& road : run.roads) {
          ++counts[road.outcome];
          const std::string label = result.outcomes[road.outcome];
          EXPECT_EQ(label != "infeasible", road.cells_left.value_or(0) > 0);
          EXPECT_TRUE(label == "infeasible" || label == "stop in " + std::to_string(*road.cells_left));
        }
        EXPECT_EQ(counts.back(), 0U) << "an answer is never missing";
        counts.pop_back();
        EXPECT_EQ(counts, sampled(scenario, world, profile, *machine, roads))
            << run.profile << run.controller;
        ++compared;
      }
  }
  EXPECT_EQ(compared, result.runs.size());
}

TEST(Drive, OutcomesAreThoseOfTheSameDrawsWithoutARoad) {
  if (!has_sumo()) GTEST_SKIP() << "built without SUMO (scripts/setup extras)";
  expect_sampled_outcomes(stop_sign);
  expect_sampled_outcomes(speed_levels);
}

TEST(Drive, MetresFollowFromTheOutcome) {
  if (!has_sumo()) GTEST_SKIP() << "built without SUMO (scripts/setup extras)";
  const std::map<std::string, double> expected{
      {"stop in 4", 2.411}, {"stop in 3", 3.215}, {"stop in 2", 4.823}, {"stop in 1", 9}};
  const report::DriveResult result = driven(stop_sign, 300).result;
  for (const report::DriveRun& run : result.runs)
    for (const report::DriveRoad& road : run.roads) {
      const std::string label = result.outcomes[road.outcome];
      if (expected.contains(label)) {
        EXPECT_NEAR(road.peak_deceleration, expected.at(label), 0.02) << run.controller << road.road;
        ASSERT_TRUE(road.overshoot);
        EXPECT_NEAR(*road.overshoot, label == "stop in 1" ? 0.717 : 0, 0.02);
      } else {
        EXPECT_EQ(road.overshoot.has_value(), road.cells_left.has_value()) << "whoever reacts, halts";
      }
    }
}

TEST(Drive, SlowingDownEarlyMakesStoppingGentler) {
  if (!has_sumo()) GTEST_SKIP() << "built without SUMO (scripts/setup extras)";
  const report::DriveResult plain = driven(stop_sign, 300).result, levels = driven(speed_levels, 300).result;
  int gentler = 0, compared = 0;
  for (const report::DriveRun& run : levels.runs)
    for (const report::DriveRun& other : plain.runs) {
      if (run.profile != other.profile || run.controller != other.controller) continue;
      for (std::size_t i = 0; i < run.roads.size(); ++i) {
        ASSERT_EQ(run.roads[i].outcome, other.roads[i].outcome) << "the same draws, the same knowledge";
        if (!run.roads[i].overshoot) continue;
        ++compared;
        EXPECT_LE(run.roads[i].peak_deceleration, other.roads[i].peak_deceleration + 0.15);
        EXPECT_LE(*run.roads[i].overshoot, *other.roads[i].overshoot + 0.02);
        gentler += run.roads[i].peak_deceleration < other.roads[i].peak_deceleration - 0.5;
      }
    }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(gentler, compared / 4);
}

TEST(Drive, TheSameSeedGivesTheSameBytesAndEachRoadIsItsOwn) {
  if (!has_sumo()) GTEST_SKIP() << "built without SUMO (scripts/setup extras)";
  const test::TemporaryFolder folder;
  const auto once = driven(stop_sign, 60, folder.path("once")),
             again = driven(stop_sign, 60, folder.path("again"));
  for (const char* name : {"drive.csv", "drive-summary.csv", "drive.json", "drive-speed.svg",
                           "drive-braking.svg", "drive-metres.svg"}) {
    const std::string text = folder.read(std::string("once/") + name);
    EXPECT_GT(text.size(), 100U) << name;
    EXPECT_EQ(text, folder.read(std::string("again/") + name)) << name;
  }
  const auto fewer = driven(stop_sign, 20);
  for (std::size_t run = 0; run < fewer.result.runs.size(); ++run)
    for (std::size_t road = 0; road < 20; ++road) {
      const report::DriveRoad &a = fewer.result.runs[run].roads[road], &b = once.result.runs[run].roads[road];
      EXPECT_EQ(a.outcome, b.outcome);
      EXPECT_EQ(a.time_lost, b.time_lost);
      EXPECT_EQ(a.least_gap, b.least_gap) << run << ' ' << road;
      EXPECT_EQ(a.follower_deceleration, b.follower_deceleration);
    }
}

}  // namespace
}  // namespace heed::job
