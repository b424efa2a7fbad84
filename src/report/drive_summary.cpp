#include <heed/report/drive.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace heed::report {
namespace {

struct Gathered {
  std::vector<double> peaks, halts;
};

/// Earliest reactions first, then none; among these by outcome.
std::pair<std::uint32_t, std::size_t> place(const DriveRoad& road) {
  return {road.cells_left ? UINT32_MAX - 1 - *road.cells_left : UINT32_MAX, road.outcome};
}

}  // namespace

DriveSpread spread(std::vector<double> values) {
  DriveSpread result;
  result.count = values.size();
  if (values.empty()) return result;
  std::sort(values.begin(), values.end());
  for (const double value : values) result.mean += value;
  result.mean /= static_cast<double>(values.size());
  result.least = values.front();
  result.most = values.back();
  const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(values.size())));
  result.percentile = values[std::max<std::size_t>(rank, 1) - 1];
  return result;
}

DriveSummary summarise(const DriveRun& run, std::size_t outcomes) {
  DriveSummary result;
  result.roads = run.roads.size();
  result.outcomes.resize(outcomes);
  std::vector<double> overshoots, peaks, jerks, speeds, lost;
  for (const DriveRoad& road : run.roads) {
    ++result.outcomes[road.outcome];
    lost.push_back(road.time_lost);
    if (road.collision) ++result.collisions;
    if (road.conflict) ++result.conflicts;
    if (road.peak_deceleration > emergency_braking) ++result.emergencies;
    if (!road.overshoot) {
      ++result.passed;
      speeds.push_back(road.line_speed);
      continue;
    }
    peaks.push_back(road.peak_deceleration);
    jerks.push_back(road.peak_jerk);
    const bool over = *road.overshoot > at_the_line;
    ++(over ? result.over_line : result.at_line);
    if (over) overshoots.push_back(*road.overshoot);
  }
  result.overshoot = spread(std::move(overshoots));
  result.deceleration = spread(std::move(peaks));
  result.jerk = spread(std::move(jerks));
  result.line_speed = spread(std::move(speeds));
  result.time_lost = spread(std::move(lost));
  return result;
}

std::vector<DriveOutcome> side_by_side(const DriveResult& result) {
  std::map<std::pair<std::uint32_t, std::size_t>, std::pair<DriveOutcome, Gathered>> rows;
  const double speed = result.speed_kmh / 3.6;
  for (const DriveRun& run : result.runs)
    for (const DriveRoad& road : run.roads) {
      auto& [row, gathered] = rows[place(road)];
      row.outcome = road.outcome;
      row.cells_left = road.cells_left;
      if (road.cells_left && *road.cells_left > 0) {
        row.distance = *road.cells_left * result.cell_metres;
        row.deceleration = speed * speed / (2 * row.distance);
      }
      ++row.roads;
      row.conflicts += road.conflict ? 1 : 0;
      row.collisions += road.collision ? 1 : 0;
      if (!road.overshoot) {
        ++row.passed;
        continue;
      }
      gathered.peaks.push_back(road.peak_deceleration);
      gathered.halts.push_back(*road.overshoot);
    }
  std::vector<DriveOutcome> out;
  for (auto& [key, value] : rows) {
    auto& [row, gathered] = value;
    row.peak = spread(std::move(gathered.peaks));
    row.halt = spread(std::move(gathered.halts));
    out.push_back(row);
  }
  return out;
}

}  // namespace heed::report
