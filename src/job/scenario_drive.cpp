#include "scenario_drive.h"

#include <heed/logic/parse.h>
#include <heed/sim/rational.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace heed::job {
namespace {

constexpr double kmh = 1 / 3.6;

WrittenFormula formula(TomlTable& table, const std::string& key, const util::Limits& limits) {
  const util::SourceText source = table.source(key);
  return {logic::parse(source, limits), source.text()};
}

/// A number from 0 to \p high, both allowed.
double from_zero(TomlTable& table, const std::string& key, double otherwise, double high) {
  const double value = table.real(key, otherwise, -1e300, 1e300);
  if (value < 0 || value > high)
    table.fail(key, "out-of-range", fmt::format("'{}' is {}, expected 0 ... {}", key, value, high),
               fmt::format("choose a number from 0 to {}", high));
  return value;
}

/// `[0.6, 2]`, or one number for both; at least \p least seconds.
std::pair<double, double> read_span(TomlTable& table, const std::string& key,
                                    std::pair<double, double> otherwise, double least) {
  if (!table.has(key)) return otherwise;
  std::vector<double> values;
  if (table.is_array(key))
    for (const util::SourceText& text : table.scalars(key))
      values.push_back(sim::to_double(sim::parse_rational(text)));
  else
    values.assign(2, table.real(key, 1, -1e300, 1e300));
  constexpr double most = 20;
  const bool fine = values.size() == 2 && values[0] >= least && values[0] <= values[1] && values[1] <= most;
  if (!fine)
    table.fail(key, "out-of-range",
               fmt::format("'{}' must be two numbers of seconds, the shorter one first, from {} to {}", key,
                           least, most),
               fmt::format("such as {} = [{}, {}]", key, otherwise.first, otherwise.second));
  return {values[0], values[1]};
}

void read_step(TomlTable& table, sim::RoadSetting& setting) {
  const std::string key = "step_seconds";
  setting.step = table.real(key, setting.step, 0, 1);
  const double milliseconds = setting.step * 1000;
  if (std::abs(milliseconds - std::round(milliseconds)) > 1e-6 || milliseconds < 0.5)
    table.fail(key, "bad-step", fmt::format("'{}' is {}, expected whole milliseconds", key, setting.step),
               "such as 0.08 or 0.1");
  const double cell_seconds = setting.cell / setting.speed;
  if (setting.step > cell_seconds / 2)
    table.fail(
        key, "bad-step",
        fmt::format("'{}' is {}, but the car is through a cell in {:.3g} s: it would jump over what it is "
                    "to see there",
                    key, setting.step, cell_seconds),
        fmt::format("at most {:.3f}", std::floor(500 * cell_seconds) / 1000));
}

void read_levels(TomlTable& table, DrivePart& part, const util::Limits& limits) {
  for (TomlTable& level : table.tables("slow")) {
    SpeedLevelPart read{formula(level, "when", limits), 0};
    if (!level.has("kmh")) (void)level.word("kmh");
    const double fastest = part.setting.speed / kmh;
    const double value = level.real("kmh", 0, 0, 1e4);
    level.finish();
    if (value > fastest || value < fastest / 10)
      level.fail(
          "kmh", "out-of-range",
          fmt::format("'kmh' is {}, expected {:.3g} ... {:.3g}: a tenth of the speed of the road, or more",
                      value, fastest / 10, fastest),
          "a car that is to halt has 'stop'");
    read.speed = value * kmh;
    part.slow.push_back(std::move(read));
  }
}

void read_cars(TomlTable& table, sim::RoadSetting& setting) {
  setting.most_deceleration = table.real("most_deceleration", setting.most_deceleration, 0.1, 50);
  setting.comfortable_deceleration =
      table.real("comfortable_deceleration",
                 std::min(setting.comfortable_deceleration, setting.most_deceleration), 0.1 - 1e-9, 50);
  if (setting.comfortable_deceleration > setting.most_deceleration)
    table.fail("comfortable_deceleration", "out-of-range",
               fmt::format("'comfortable_deceleration' is {}, more than the brakes can do, {}",
                           setting.comfortable_deceleration, setting.most_deceleration),
               "see 'most_deceleration'");
  setting.acceleration = table.real("acceleration", setting.acceleration, 0.1, 50);
  setting.brake_seconds = from_zero(table, "brake_seconds", setting.brake_seconds, 5);
  setting.halt_seconds = from_zero(table, "halt_seconds", setting.halt_seconds, 600);
  setting.followers = static_cast<std::uint32_t>(table.integer("followers", setting.followers, 0, 5));
  std::tie(setting.shortest_headway, setting.longest_headway) =
      read_span(table, "headway_seconds", {setting.shortest_headway, setting.longest_headway}, 0.1);
  std::tie(setting.shortest_reaction, setting.longest_reaction) =
      read_span(table, "reaction_seconds", {setting.shortest_reaction, setting.longest_reaction}, 0);
  setting.follower_deceleration = table.real("follower_deceleration", setting.follower_deceleration, 0.1, 50);
  setting.conflict_seconds = from_zero(table, "conflict_seconds", setting.conflict_seconds, 60);
  setting.jerk_seconds = table.real("jerk_seconds", setting.jerk_seconds, 0, 10);
}

}  // namespace

DrivePart read_drive(TomlTable& root, const std::optional<EvaluatePart>& evaluate,
                     const util::Limits& limits) {
  DrivePart part;
  sim::RoadSetting& setting = part.setting;
  if (evaluate) {
    setting.cell = evaluate->cell_metres;
    setting.speed = evaluate->speed_kmh * kmh;
    part.wanted = evaluate->speed_wanted;
  }
  if (!root.has("drive")) return part;
  part.wanted = true;
  TomlTable table = root.table("drive");
  if (!evaluate)
    throw util::InputError(table.location(), "missing-key", "[drive] needs [evaluate] to say what counts",
                           "add [[profile]] and [evaluate] with event and outcomes");
  part.roads = static_cast<std::uint32_t>(table.integer("roads", part.roads, 1, 100'000));
  if (table.has("seed")) part.seed = static_cast<std::uint64_t>(table.integer("seed", 1, 0, INT64_MAX));
  setting.cell = table.real("cell_metres", setting.cell, 0.1, 1000);
  setting.speed = table.real("speed_kmh", setting.speed / kmh, 1, 400) * kmh;
  read_step(table, setting);
  read_cars(table, setting);
  if (table.has("stop")) part.stop = formula(table, "stop", limits);
  read_levels(table, part, limits);
  table.finish();
  return part;
}

}  // namespace heed::job
