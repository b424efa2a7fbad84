// The closed loop without a simulator: kinematics, the pilot, and what is measured of a drive.
#include <gtest/gtest.h>
#include <heed/sim/traffic.h>
#include <heed/util/diagnostic.h>

#include <cmath>

#include "unit/sim/frictionless.h"

namespace heed::sim {
namespace {

using Kind = Manoeuvre::Kind;

Manoeuvre stop() {
  return {Kind::Stop, 0};
}

/// Drives one road on which the car stops from \p cell on.
Trajectory stopping_from(const RoadSetting& setting, std::uint32_t cell) {
  Frictionless engine;
  util::Budget budget;
  return drive_roads(
             engine, setting, {},
             [&](std::uint32_t, std::uint32_t now) { return now >= cell ? stop() : Manoeuvre{}; }, budget)
      .front();
}

TEST(Traffic, BrakingHaltsAfterTheDistance) {
  const double speed = 50 / 3.6;
  EXPECT_NEAR(braking_deceleration(speed, 40, 9), 2.411, 1e-3);
  EXPECT_NEAR(braking_deceleration(speed, 30, 9), 3.215, 1e-3);
  EXPECT_NEAR(braking_deceleration(speed, 20, 9), 4.823, 1e-3);
  EXPECT_EQ(braking_deceleration(speed, 10, 9), 9) << "9.65 is more than the brakes can do";
  EXPECT_EQ(braking_deceleration(speed, 0, 9), 9);
  EXPECT_EQ(braking_deceleration(0, 10, 9), 0);
}

TEST(Traffic, AStopInNCellsHaltsAtTheLine) {
  RoadSetting setting;
  for (const std::uint32_t n : {4U, 3U, 2U}) {
    const RoadMeasure found = measure(stopping_from(setting, 4 - n), setting);
    ASSERT_TRUE(found.overshoot) << n;
    EXPECT_NEAR(*found.overshoot, 0, 0.01) << n;
    EXPECT_NEAR(found.peak_deceleration, setting.speed * setting.speed / (20.0 * n), 0.01) << n;
    EXPECT_NEAR(found.line_speed, 0, 0.3) << n;
  }
}

TEST(Traffic, TooLateHaltsBehindTheLine) {
  RoadSetting setting;
  const double braking = setting.speed * setting.speed / (2 * setting.most_deceleration);
  const RoadMeasure one = measure(stopping_from(setting, 3), setting);
  EXPECT_NEAR(*one.overshoot, braking - 10, 0.02);
  EXPECT_NEAR(one.line_speed, std::sqrt(2 * 9 * (braking - 10)), 0.1);
  const RoadMeasure none = measure(stopping_from(setting, 4), setting);
  EXPECT_NEAR(*none.overshoot, braking, 0.02);
  EXPECT_NEAR(none.line_speed, setting.speed, 0.01);
}

TEST(Traffic, BrakesThatTakeTimeHaltFartherBehind) {
  RoadSetting setting;
  setting.brake_seconds = 0.3;
  const RoadMeasure found = measure(stopping_from(setting, 3), setting);
  const double ideal = setting.speed * setting.speed / 18 - 10;
  // While they build up evenly, the car drives v t / 2 that full braking would have saved, less b t^2 / 24.
  EXPECT_NEAR(*found.overshoot, ideal + setting.speed * 0.15 - 9 * 0.09 / 24, 0.6);
  EXPECT_GT(*found.overshoot, ideal + 0.5);
}

TEST(Traffic, NobodyReactingPassesFreely) {
  RoadSetting setting;
  const RoadMeasure found = measure(stopping_from(setting, 99), setting);
  EXPECT_FALSE(found.overshoot);
  EXPECT_NEAR(found.line_speed, setting.speed, 1e-9);
  EXPECT_NEAR(found.time_lost, 0, 1e-6);
  EXPECT_EQ(found.peak_deceleration, 0);
}

TEST(Traffic, AHaltCostsItsTime) {
  RoadSetting setting;
  const double v = setting.speed;
  const RoadMeasure found = measure(stopping_from(setting, 0), setting);
  // Braking over 40 m and speeding up again each take twice as long as driving them; then the halt.
  const double lost = 40 / v + v / (2 * setting.acceleration) + setting.halt_seconds;
  EXPECT_NEAR(found.time_lost, lost, 0.2);
}

TEST(Traffic, CellsAreReadInTheirOrderWhereTheyBegin) {
  RoadSetting setting;
  setting.followers = 0;
  Frictionless engine;
  util::Budget budget;
  std::vector<std::pair<std::uint32_t, double>> asked;
  (void)drive_roads(
      engine, setting, {},
      [&](std::uint32_t, std::uint32_t cell) {
        asked.emplace_back(cell, engine.state(0).position);
        return Manoeuvre{};
      },
      budget);
  ASSERT_EQ(asked.size(), 5U);
  for (std::uint32_t cell = 0; cell < 5; ++cell) {
    EXPECT_EQ(asked[cell].first, cell);
    EXPECT_NEAR(asked[cell].second, -10.0 * (4 - cell), 2e-3);
  }
}

TEST(Traffic, WhatFlickersAwayLetsTheCarGoOn) {
  RoadSetting setting;
  Frictionless engine;
  util::Budget budget;
  const auto driven = drive_roads(
      engine, setting, {}, [](std::uint32_t, std::uint32_t cell) { return cell == 1 ? stop() : Manoeuvre{}; },
      budget);
  const RoadMeasure found = measure(driven.front(), setting);
  EXPECT_FALSE(found.overshoot);
  EXPECT_GT(found.peak_deceleration, 3);
  EXPECT_GT(found.time_lost, 0.1);
}

TEST(Traffic, ASlowerLevelIsReachedGentlyAndMakesStoppingGentler) {
  RoadSetting setting;
  Frictionless engine;
  util::Budget budget;
  const auto driven = drive_roads(
      engine, setting, {},
      [](std::uint32_t, std::uint32_t cell) {
        return cell < 3 ? Manoeuvre{Kind::Slow, 30 / 3.6} : stop();
      },
      budget);
  const RoadMeasure found = measure(driven.front(), setting);
  const double left = 30 / 3.6;
  // From 30 km/h over 10 m, less what the car drives before the step ends in which it enters the cell.
  EXPECT_GE(found.peak_deceleration, left * left / 20 - 1e-9);
  EXPECT_LE(found.peak_deceleration, left * left / 2 / (10 - left * setting.step) + 1e-9);
  EXPECT_NEAR(*found.overshoot, 0, 0.01);
  double slowest = setting.speed;
  for (std::size_t time = 0; time < driven.front().times(); ++time)
    if (driven.front().at(time).position < -10.1) slowest = std::min(slowest, driven.front().at(time).speed);
  EXPECT_NEAR(slowest, left, 1e-6);
}

TEST(Traffic, ARoadIsTheSameWhateverTheOthers) {
  RoadSetting setting;
  setting.followers = 2;
  util::Budget budget;
  const auto cruise = [](std::uint32_t, std::uint32_t) { return Manoeuvre{}; };
  Frictionless one, other;
  (void)drive_roads(one, setting, {7, 0, 5}, cruise, budget);
  (void)drive_roads(other, setting, {7, 3, 40}, cruise, budget);
  for (std::size_t car = 0; car < 3; ++car) {
    EXPECT_EQ(one.plan.cars[4 * 3 + car].position, other.plan.cars[1 * 3 + car].position);
    EXPECT_EQ(one.plan.cars[4 * 3 + car].headway, other.plan.cars[1 * 3 + car].headway);
  }
  EXPECT_NE(one.plan.cars[1].headway, one.plan.cars[4].headway);
  for (std::size_t car = 1; car < 3; ++car) {
    EXPECT_GE(one.plan.cars[car].headway, setting.shortest_headway);
    EXPECT_LE(one.plan.cars[car].headway, setting.longest_headway);
  }
}

/// Two cars at 10 m/s; the front one brakes at 5 m/s^2 at once, the other one never.
Trajectory crash() {
  Trajectory made{0.1, 2, {}};
  double front = -20, speed = 10, behind = -35;
  for (int step = 0; step <= 40; ++step) {
    made.states.push_back({front, speed});
    made.states.push_back({behind, 10});
    const double next = std::max(0.0, speed - 0.5);
    front += (speed + next) / 2 * 0.1;
    behind += 1;
    speed = next;
  }
  return made;
}

TEST(Traffic, RearEndsAreSeen) {
  RoadSetting setting;
  setting.step = 0.1;
  setting.speed = 10;
  setting.jerk_seconds = 0.2;
  const RoadMeasure found = measure(crash(), setting);
  EXPECT_TRUE(found.collision);
  EXPECT_TRUE(found.conflict);
  EXPECT_EQ(*found.least_time, 0);
  EXPECT_NEAR(*found.overshoot, -10, 1e-9) << "halts 10 m before the line: 100 / (2 * 5)";
  EXPECT_EQ(found.line_speed, 0);
  EXPECT_NEAR(found.peak_deceleration, 5, 1e-9);
  EXPECT_NEAR(found.peak_jerk, 5 / 0.2, 1e-9);
  EXPECT_EQ(found.follower_deceleration, 0);
  EXPECT_NEAR(*found.least_gap, -10 - 5 - 5, 1e-9) << "the one behind ends at 5 m";
}

TEST(Traffic, ACloseCallIsAConflictByItsThreshold) {
  Trajectory made{1, 2, {}};
  // 20 m apart and 4 m/s faster, then 16 m apart and as fast: 5 s to a collision.
  made.states = {{0, 6}, {-25, 10}, {6, 6}, {-15, 6}, {12, 6}, {-9, 6}};
  RoadSetting setting;
  setting.conflict_seconds = 4;
  EXPECT_FALSE(measure(made, setting).conflict);
  EXPECT_NEAR(*measure(made, setting).least_time, 5, 1e-9);
  EXPECT_NEAR(measure(made, setting).follower_deceleration, 4, 1e-9);
  setting.conflict_seconds = 5.5;
  EXPECT_TRUE(measure(made, setting).conflict);
  EXPECT_FALSE(measure(made, setting).collision);
}

TEST(Traffic, AMissingSimulatorSaysHowToGetIt) {
  try {
    (void)load_sumo("/nowhere/libheed_sumo.so");
    FAIL();
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "no-sumo");
    EXPECT_NE(error.diagnostic().hint.find("scripts/setup extras"), std::string::npos);
  }
}

TEST(Traffic, TimeRunsOutWhileDriving) {
  Frictionless engine;
  util::Budget budget;
  budget.cancel();
  EXPECT_THROW((void)drive_roads(
                   engine, {}, {}, [](std::uint32_t, std::uint32_t) { return Manoeuvre{}; }, budget),
               util::LimitExceeded);
}

}  // namespace
}  // namespace heed::sim
