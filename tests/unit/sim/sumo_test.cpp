// The closed loop in SUMO itself; skipped where this build has none.
#include <gtest/gtest.h>
#include <heed/sim/traffic.h>
#include <heed/util/diagnostic.h>

#include <array>
#include <cmath>

#include "unit/sim/frictionless.h"

namespace heed::sim {
namespace {

std::unique_ptr<TrafficEngine> sumo() {
  try {
    return load_sumo(HEED_BINARY_DIR "/lib/heed/libheed_sumo.so");
  } catch (const util::InputError&) {
    return nullptr;
  }
}

/// Road i stops with i mod 6 cells to go; 5: never.
Manoeuvre by_road(std::uint32_t road, std::uint32_t cell) {
  const std::uint32_t n = road % 6;
  return n < 5 && 4 - cell <= n ? Manoeuvre{Manoeuvre::Kind::Stop, 0} : Manoeuvre{};
}

std::vector<Trajectory> drive(TrafficEngine& engine, const RoadSetting& setting, const RoadBatch& batch) {
  util::Budget budget;
  return drive_roads(engine, setting, batch, by_road, budget);
}

bool same(const CarState& a, const CarState& b, double tolerance) {
  return std::abs(a.position - b.position) <= tolerance && std::abs(a.speed - b.speed) <= tolerance;
}

#define NEEDS_SUMO(engine)    \
  const auto engine = sumo(); \
  if (!engine) GTEST_SKIP() << "built without SUMO (scripts/setup extras)"

TEST(Sumo, DecelerationsAreThoseMeasuredBefore) {
  NEEDS_SUMO(engine);
  const RoadSetting setting;
  const auto roads = drive(*engine, setting, {1, 0, 6});
  // What a car under TraCI was seen to do on such a road, n = 1 ... 4: heed's brakes end at 9 m/s^2.
  constexpr std::array<double, 4> seen{8.7, 4.6, 3.2, 2.4};
  for (std::size_t n = 1; n <= 4; ++n)
    EXPECT_NEAR(measure(roads[n], setting).peak_deceleration / seen[n - 1], 1, 0.06) << n;
  EXPECT_NEAR(*measure(roads[0], setting).overshoot, setting.speed * setting.speed / 18, 0.05);
  EXPECT_FALSE(measure(roads[5], setting).overshoot);
}

TEST(Sumo, TheCarMovesByTheLawsOfMotion) {
  NEEDS_SUMO(engine);
  RoadSetting setting;
  setting.followers = 0;
  Frictionless ideal;
  const auto roads = drive(*engine, setting, {1, 0, 6});
  const auto expected = drive(ideal, setting, {1, 0, 6});
  for (std::size_t road = 0; road < roads.size(); ++road) {
    ASSERT_EQ(roads[road].times(), expected[road].times()) << road;
    for (std::size_t time = 0; time < roads[road].times(); ++time)
      ASSERT_TRUE(same(roads[road].at(time), expected[road].at(time), 0.02)) << road << ' ' << time;
  }
}

TEST(Sumo, WhoDrivesBehindDoesNotMoveTheCar) {
  NEEDS_SUMO(engine);
  RoadSetting alone, followed;
  alone.followers = 0;
  followed.followers = 3;
  const auto without = drive(*engine, alone, {1, 0, 12}), with = drive(*engine, followed, {1, 0, 12});
  for (std::size_t road = 0; road < without.size(); ++road) {
    ASSERT_EQ(without[road].times(), with[road].times());
    for (std::size_t time = 0; time < without[road].times(); ++time)
      ASSERT_TRUE(same(without[road].at(time), with[road].at(time), 1e-9)) << road << ' ' << time;
  }
}

TEST(Sumo, AgainIsTheSameAndEachRoadIsItsOwn) {
  NEEDS_SUMO(engine);
  const RoadSetting setting;
  const auto once = drive(*engine, setting, {3, 0, 30}), again = drive(*engine, setting, {3, 0, 30});
  const auto later = drive(*engine, setting, {3, 12, 6});  // 12 is a multiple of 6: the same decisions
  for (std::size_t road = 0; road < once.size(); ++road) {
    ASSERT_EQ(once[road].times(), again[road].times());
    for (std::size_t i = 0; i < once[road].states.size(); ++i)
      ASSERT_TRUE(same(once[road].states[i], again[road].states[i], 0));
  }
  for (std::size_t road = 0; road < later.size(); ++road) {
    ASSERT_EQ(once[road + 12].times(), later[road].times());
    for (std::size_t i = 0; i < later[road].states.size(); ++i)
      ASSERT_TRUE(same(once[road + 12].states[i], later[road].states[i], 0)) << road;
  }
}

TEST(Sumo, DriversBehindBrakeAndHarderBrakingEndangersThemMore) {
  NEEDS_SUMO(engine);
  const RoadSetting setting;
  const auto roads = drive(*engine, setting, {1, 0, 300});
  std::array<int, 6> conflicts{}, count{};
  for (std::size_t road = 0; road < roads.size(); ++road) {
    const RoadMeasure found = measure(roads[road], setting);
    ++count[road % 6];
    conflicts[road % 6] += found.conflict;
    EXPECT_EQ(found.follower_deceleration > 1, road % 6 != 5) << road;
  }
  EXPECT_EQ(conflicts[5], 0) << "nobody brakes";
  EXPECT_GT(conflicts[1], 4 * conflicts[3] + 10);
}

TEST(Sumo, OneAtATime) {
  NEEDS_SUMO(engine);
  EXPECT_THROW((void)load_sumo(HEED_BINARY_DIR "/lib/heed/libheed_sumo.so"), TrafficError);
}

}  // namespace
}  // namespace heed::sim
