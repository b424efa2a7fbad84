#include <heed/report/result.h>

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace heed::report {

namespace {

/// Under constant deceleration v(d) = v0 sqrt(d / braking distance): steep near the end, hence several points
/// a cell.
constexpr unsigned points_per_cell = 8;

SpeedCurve curve(double cell_metres, double speed_kmh, unsigned horizon_cells, unsigned cells) {
  const double metres_per_second = speed_kmh / 3.6;
  const double braking = cells * cell_metres;
  SpeedCurve result;
  result.label = fmt::format("stop in {}", cells);
  result.cells = cells;
  result.deceleration = metres_per_second * metres_per_second / (2 * braking);
  if (cells < horizon_cells) result.points.push_back({horizon_cells * cell_metres, speed_kmh});
  const unsigned steps = cells * points_per_cell;
  for (unsigned i = 0; i <= steps; ++i) {
    const double left = static_cast<double>(steps - i) / steps;
    result.points.push_back({braking * left, speed_kmh * std::sqrt(left)});
  }
  return result;
}

}  // namespace

SpeedPicture speed_picture(double cell_metres, double speed_kmh, unsigned horizon_cells) {
  assert(cell_metres > 0 && speed_kmh >= 0);
  SpeedPicture picture{cell_metres, speed_kmh, horizon_cells, {}};
  for (unsigned cells = 1; cells <= horizon_cells; ++cells)
    picture.curves.push_back(curve(cell_metres, speed_kmh, horizon_cells, cells));
  return picture;
}

}  // namespace heed::report
