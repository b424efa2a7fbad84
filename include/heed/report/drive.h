#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What `heed drive` found, as plain values, and its writers: tables, pictures, documents
/// (docs/formats/drive.md). Same value, same bytes.
namespace heed::report {

/// One road, driven once. SI units.
struct DriveRoad {
  std::uint64_t road = 0;
  std::size_t outcome = 0;                    ///< Into DriveResult::outcomes.
  std::optional<std::uint32_t> cells_left{};  ///< Where the controller first reacted; none: it never did.
  std::optional<double> overshoot{};          ///< Of the halt, behind the line; none: the car never halted.
  double line_speed = 0, peak_deceleration = 0, peak_jerk = 0, time_lost = 0;
  std::optional<double> least_gap{}, least_time{};  ///< To the cars behind; time: to collision.
  double follower_deceleration = 0;
  bool collision = false, conflict = false;
};

/// One controller under one profile.
struct DriveRun {
  std::string profile, controller;
  std::vector<DriveRoad> roads{};
};

struct DrivePoint {
  double metres;  ///< From the line, negative before it.
  double kmh;
};

/// The way of one car that the picture shows.
struct DriveTrace {
  std::string profile, controller;
  std::uint64_t road = 0;
  std::size_t outcome = 0;
  std::optional<std::uint32_t> cells_left{};
  std::vector<DrivePoint> points{};
};

struct DriveController {
  std::string name, title;
  bool beside = false;  ///< Shown beside the main comparison.
};

struct DriveProfile {
  std::string name, title;
};

struct DriveResult {
  std::string scenario, command;
  std::string thing;  ///< What stands at the line.
  std::uint64_t seed = 1, roads = 0;
  double cell_metres = 10, speed_kmh = 50, most_deceleration = 9, conflict_seconds = 1;
  std::uint32_t cells = 5;  ///< Of the longest profile.
  std::uint32_t followers = 1;
  std::vector<std::pair<std::string, double>> setting{};  ///< Keys of [drive] and what held.
  std::vector<std::string> outcomes{};
  std::size_t miss = 0;
  std::vector<DriveController> controllers{};
  std::vector<DriveProfile> profiles{};
  std::vector<DriveRun> runs{};      ///< By profile, then controller.
  std::vector<DriveTrace> traces{};  ///< By controller.
  std::vector<std::pair<std::string, std::string>> versions{};
};

/// Mean, 95th percentile and maximum of some figure; zeros where nothing was counted.
struct DriveSpread {
  std::uint64_t count = 0;
  double least = 0, mean = 0, percentile = 0, most = 0;
};

/// \param values  In any order. The percentile is the smallest value that 95 % of all do not exceed.
[[nodiscard]] DriveSpread spread(std::vector<double> values);

/// A halt this far behind the line, in metres, counts as one at it.
inline constexpr double at_the_line = 0.1;
/// Braking harder than this, in m/s^2, is an emergency.
inline constexpr double emergency_braking = 6;

/// One run in a line.
struct DriveSummary {
  std::uint64_t roads = 0;
  std::vector<std::uint64_t> outcomes{};
  std::uint64_t at_line = 0, over_line = 0, passed = 0;  ///< Halts at the line, behind it, not at all.
  std::uint64_t emergencies = 0, conflicts = 0, collisions = 0;
  DriveSpread overshoot{};     ///< Of those that halted over the line.
  DriveSpread deceleration{};  ///< Peak, of those that halted.
  DriveSpread jerk{};          ///< Peak, of those that halted.
  DriveSpread line_speed{};    ///< Of those that never halted.
  DriveSpread time_lost{};     ///< Of all.
};
[[nodiscard]] DriveSummary summarise(const DriveRun& run, std::size_t outcomes);

/// The answer in sentences: the last controller of the main comparison beside the others, over all profiles.
[[nodiscard]] std::vector<std::string> headline_of(const DriveResult& result);

/// One abstract outcome, and what became of it in metres, over all runs.
struct DriveOutcome {
  std::size_t outcome = 0;
  std::optional<std::uint32_t> cells_left{};
  double distance = 0,
         deceleration = 0;  ///< In the abstract: n cells, v^2 / (2 n cell); 0 where n is 0 or none.
  std::uint64_t roads = 0, passed = 0, conflicts = 0, collisions = 0;
  DriveSpread peak{};  ///< Peak deceleration of those that halted.
  DriveSpread halt{};  ///< Place of the halt, behind the line.
};
/// Early reactions first, none at all last; only what occurred.
[[nodiscard]] std::vector<DriveOutcome> side_by_side(const DriveResult& result);

/// One line for each road of each run, after a head.
[[nodiscard]] std::string to_csv(const DriveResult& result);
/// One line for each run, after a head.
[[nodiscard]] std::string summary_csv(const DriveResult& result);
[[nodiscard]] std::string to_json(const DriveResult& result);
/// Plain text for the terminal. Ends with a line feed.
[[nodiscard]] std::string to_text(const DriveResult& result, std::size_t width = 100);

/// Pictures, each one SVG document of its own: light and dark as the reader has it, no script, no request.
/// Speed over distance: a road of each outcome, one panel for each controller.
[[nodiscard]] std::string speed_svg(const DriveResult& result);
/// How often the car braked how hard: one panel for each controller and profile.
[[nodiscard]] std::string braking_svg(const DriveResult& result);
/// The abstract "stop in n" beside the metres that were driven.
[[nodiscard]] std::string metres_svg(const DriveResult& result);

}  // namespace heed::report
