#include <heed/sim/traffic.h>

#include <algorithm>
#include <cmath>

namespace heed::sim {
namespace {

constexpr double standstill = 1e-3;
/// Cars that come closer more slowly than this, in m/s, are following each other.
constexpr double following = 0.1;

/// The first time at which the car stands; as many as there are where it never does.
std::size_t halt_of(const Trajectory& trajectory) {
  std::size_t time = 0;
  while (time < trajectory.times() && trajectory.at(time).speed > standstill) ++time;
  return time;
}

double acceleration(const Trajectory& trajectory, std::size_t time, std::size_t car = 0) {
  return (trajectory.at(time + 1, car).speed - trajectory.at(time, car).speed) / trajectory.step;
}

/// Constant acceleration within a step: v^2 is linear in the way.
double speed_between(const CarState& before, const CarState& after, double position) {
  const double way = after.position - before.position;
  if (way <= 0) return after.speed;
  const double share = (position - before.position) / way;
  return std::sqrt(std::max(
      0.0, before.speed * before.speed + share * (after.speed * after.speed - before.speed * before.speed)));
}

/// Seconds into the step until \p position.
double time_between(const CarState& before, const CarState& after, double position) {
  const double mean = (before.speed + speed_between(before, after, position)) / 2;
  return mean > 0 ? (position - before.position) / mean : 0;
}

void measure_car(const Trajectory& trajectory, const RoadSetting& setting, RoadMeasure& result) {
  const std::size_t halt = halt_of(trajectory), times = trajectory.times();
  if (halt < times) result.overshoot = trajectory.at(halt).position;
  const auto window =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(setting.jerk_seconds / trajectory.step)));
  // One step more than up to the halt: that the braking ends is felt, too.
  const std::size_t last = std::min(halt + 1, times - 1);
  for (std::size_t time = 0; time < last; ++time) {
    const double now = acceleration(trajectory, time);
    result.peak_deceleration = std::max(result.peak_deceleration, -now);
    const double before = time >= window ? acceleration(trajectory, time - window) : 0;
    result.peak_jerk =
        std::max(result.peak_jerk, std::abs(now - before) / (static_cast<double>(window) * trajectory.step));
  }
}

void measure_way(const Trajectory& trajectory, const RoadSetting& setting, RoadMeasure& result) {
  const double end = drive_end(setting);
  const double freely = (end - trajectory.at(0).position) / setting.speed;
  for (std::size_t time = 0; time + 1 < trajectory.times(); ++time) {
    const CarState &before = trajectory.at(time), &after = trajectory.at(time + 1);
    const bool halted_early = result.overshoot && *result.overshoot <= 0;
    if (before.position < 0 && after.position >= 0 && !halted_early)
      result.line_speed = speed_between(before, after, 0);
    if (before.position < end && after.position >= end)
      result.time_lost =
          static_cast<double>(time) * trajectory.step + time_between(before, after, end) - freely;
  }
}

void measure_followers(const Trajectory& trajectory, RoadMeasure& result) {
  for (std::size_t car = 1; car < trajectory.cars; ++car)
    for (std::size_t time = 0; time < trajectory.times(); ++time) {
      const CarState &front = trajectory.at(time, car - 1), &behind = trajectory.at(time, car);
      const double gap = front.position - car_length - behind.position;
      result.least_gap = std::min(result.least_gap.value_or(gap), gap);
      const double closing = behind.speed - front.speed;
      if (gap <= 0) result.collision = true;
      if (closing > following) {
        const double left = std::max(gap, 0.0) / closing;
        result.least_time = std::min(result.least_time.value_or(left), left);
      }
      if (time + 1 < trajectory.times())
        result.follower_deceleration =
            std::max(result.follower_deceleration, -acceleration(trajectory, time, car));
    }
}

}  // namespace

double drive_end(const RoadSetting& setting) {
  const double square = setting.speed * setting.speed;
  const double late =
      square / (2 * setting.most_deceleration) + setting.speed * (setting.brake_seconds + setting.step);
  return std::ceil(late + square / (2 * setting.acceleration));
}

RoadMeasure measure(const Trajectory& trajectory, const RoadSetting& setting) {
  RoadMeasure result;
  measure_car(trajectory, setting, result);
  measure_way(trajectory, setting, result);
  measure_followers(trajectory, result);
  result.conflict = result.collision || (result.least_time && *result.least_time < setting.conflict_seconds);
  return result;
}

}  // namespace heed::sim
