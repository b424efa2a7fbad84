#include <heed/report/drive.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "format.h"

namespace heed::report {
namespace {

using Json = nlohmann::ordered_json;

/// Three decimals: a millimetre, a thousandth of m/s^2. Never "-0.000".
double rounded(double value) {
  return std::round(value * 1000) / 1000 + 0.0;
}
std::string cell(double value) {
  return fmt::format("{:.3f}", rounded(value));
}
std::string cell(const std::optional<double>& value) {
  return value ? cell(*value) : std::string();
}

/// RFC 4180.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

Json spread_json(const DriveSpread& spread) {
  return {{"count", spread.count},
          {"least", rounded(spread.least)},
          {"mean", rounded(spread.mean)},
          {"percentile_95", rounded(spread.percentile)},
          {"most", rounded(spread.most)}};
}

Json run_json(const DriveResult& result, const DriveRun& run) {
  const DriveSummary sum = summarise(run, result.outcomes.size());
  Json outcomes = Json::object();
  for (std::size_t o = 0; o < result.outcomes.size(); ++o) outcomes[result.outcomes[o]] = sum.outcomes[o];
  return {{"profile", run.profile},
          {"controller", run.controller},
          {"roads", sum.roads},
          {"outcomes", std::move(outcomes)},
          {"halted_at_line", sum.at_line},
          {"halted_over_line", sum.over_line},
          {"passed", sum.passed},
          {"overshoot_m", spread_json(sum.overshoot)},
          {"line_speed_mps", spread_json(sum.line_speed)},
          {"peak_deceleration_mps2", spread_json(sum.deceleration)},
          {"emergencies", sum.emergencies},
          {"peak_jerk_mps3", spread_json(sum.jerk)},
          {"time_lost_s", spread_json(sum.time_lost)},
          {"conflicts", sum.conflicts},
          {"collisions", sum.collisions}};
}

Json outcome_json(const DriveResult& result, const DriveOutcome& row) {
  Json out{{"outcome", result.outcomes[row.outcome]}, {"cells_left", nullptr}, {"abstract", nullptr}};
  if (row.cells_left) out["cells_left"] = *row.cells_left;
  if (row.distance > 0)
    out["abstract"] = {{"distance_m", rounded(row.distance)},
                       {"deceleration_mps2", rounded(row.deceleration)}};
  out["roads"] = row.roads;
  out["passed"] = row.passed;
  out["peak_deceleration_mps2"] = spread_json(row.peak);
  out["halt_m"] = spread_json(row.halt);
  out["conflicts"] = row.conflicts;
  out["collisions"] = row.collisions;
  return out;
}

}  // namespace

std::string to_csv(const DriveResult& result) {
  std::string out =
      "profile,controller,road,outcome,cells_left,halted,overshoot_m,line_speed_mps,peak_deceleration_mps2,"
      "peak_jerk_mps3,time_lost_s,least_gap_m,least_time_to_collision_s,follower_deceleration_mps2,conflict,"
      "collision\n";
  for (const DriveRun& run : result.runs)
    for (const DriveRoad& road : run.roads)
      out +=
          fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", quoted(run.profile),
                      quoted(run.controller), road.road, quoted(result.outcomes[road.outcome]),
                      road.cells_left ? std::to_string(*road.cells_left) : "", road.overshoot ? 1 : 0,
                      cell(road.overshoot), cell(road.line_speed), cell(road.peak_deceleration),
                      cell(road.peak_jerk), cell(road.time_lost), cell(road.least_gap), cell(road.least_time),
                      cell(road.follower_deceleration), road.conflict ? 1 : 0, road.collision ? 1 : 0);
  return out;
}

std::string summary_csv(const DriveResult& result) {
  std::string out = "profile,controller,roads";
  for (const std::string& outcome : result.outcomes) out += ',' + quoted(outcome);
  out +=
      ",halted_at_line,halted_over_line,passed,overshoot_mean_m,overshoot_most_m,line_speed_mean_mps,"
      "peak_deceleration_mean_mps2,peak_deceleration_95_mps2,peak_deceleration_most_mps2,emergencies,"
      "peak_jerk_mean_mps3,peak_jerk_most_mps3,time_lost_mean_s,time_lost_most_s,conflicts,collisions\n";
  for (const DriveRun& run : result.runs) {
    const DriveSummary sum = summarise(run, result.outcomes.size());
    out += fmt::format("{},{},{}", quoted(run.profile), quoted(run.controller), sum.roads);
    for (const std::uint64_t count : sum.outcomes) out += fmt::format(",{}", count);
    out +=
        fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", sum.at_line, sum.over_line,
                    sum.passed, cell(sum.overshoot.mean), cell(sum.overshoot.most), cell(sum.line_speed.mean),
                    cell(sum.deceleration.mean), cell(sum.deceleration.percentile),
                    cell(sum.deceleration.most), sum.emergencies, cell(sum.jerk.mean), cell(sum.jerk.most),
                    cell(sum.time_lost.mean), cell(sum.time_lost.most), sum.conflicts, sum.collisions);
  }
  return out;
}

std::string to_json(const DriveResult& result) {
  Json out{{"heed", "drive"},           {"version", 1},          {"scenario", result.scenario},
           {"command", result.command}, {"thing", result.thing}, {"seed", result.seed},
           {"roads", result.roads}};
  Json setting = Json::object();
  for (const auto& [key, value] : result.setting) setting[key] = rounded(value);
  out["setting"] = std::move(setting);
  Json outcomes = Json::array(), runs = Json::array(), versions = Json::object();
  for (const DriveOutcome& row : side_by_side(result)) outcomes.push_back(outcome_json(result, row));
  for (const DriveRun& run : result.runs) runs.push_back(run_json(result, run));
  for (const auto& [name, version] : result.versions) versions[name] = version;
  out["headline"] = headline_of(result);
  out["outcomes"] = std::move(outcomes);
  out["runs"] = std::move(runs);
  out["versions"] = std::move(versions);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace heed::report
