#include <heed/report/result.h>

#include <fmt/format.h>

#include <cassert>

namespace heed::report {

namespace {

///  Points at equal times: under constant deceleration the speed then falls by equal amounts, v = v0 (1 - t),
///  and what
/// is left of the distance is (1 - t)^2, so that the steep end gets as many points as it needs.
constexpr unsigned steps = 32;

SpeedCurve curve(double cell_metres, double speed_kmh, unsigned horizon_cells, unsigned cells) {
  const double metres_per_second = speed_kmh / 3.6;
  const double braking = cells * cell_metres;
  SpeedCurve result;
  result.label = fmt::format("stop in {}", cells);
  result.cells = cells;
  result.deceleration = metres_per_second * metres_per_second / (2 * braking);
  if (cells < horizon_cells) result.points.push_back({horizon_cells * cell_metres, speed_kmh});
  for (unsigned i = 0; i <= steps; ++i) {
    const double left = static_cast<double>(steps - i) / steps;
    result.points.push_back({braking * left * left, speed_kmh * left});
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
