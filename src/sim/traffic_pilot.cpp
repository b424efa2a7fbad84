#include <heed/sim/traffic.h>

#include <algorithm>
#include <utility>

namespace heed::sim {
namespace {

/// Cells are entered a hair early rather than a step late: positions are sums of rounded steps.
constexpr double hair = 1e-3;
/// A car that halts this close before a cell has arrived there.
constexpr double arrived = 0.25;
constexpr double standstill = 1e-3;

}  // namespace

double braking_deceleration(double speed, double distance, double most) {
  if (distance <= 0) return most;
  return std::min(most, speed * speed / (2 * distance));
}

void Pilot::read_cells(const CarState& state) {
  const double close = state.speed <= standstill ? arrived : hair;
  while (cell_ < setting_.cells) {
    const double place = -static_cast<double>(setting_.cells - 1 - cell_) * setting_.cell;
    if (state.position < place - close) return;
    manoeuvre_ = decide_(cell_++);
  }
}

/// The halt at the line, or behind it: \returns whether it lasts.
bool Pilot::stands(const CarState& state) {
  if (manoeuvre_.kind == Manoeuvre::Kind::Stop && state.speed <= standstill) halted_ = true;
  if (!halted_ || stood_ >= setting_.halt_seconds) return false;
  stood_ += setting_.step;
  return true;
}

double Pilot::wanted_acceleration(const CarState& state) const {
  if (manoeuvre_.kind == Manoeuvre::Kind::Stop)
    return -braking_deceleration(state.speed, -state.position, setting_.most_deceleration);
  const double level =
      manoeuvre_.kind == Manoeuvre::Kind::Slow ? std::min(manoeuvre_.speed, setting_.speed) : setting_.speed;
  return std::clamp((level - state.speed) / setting_.step, -setting_.comfortable_deceleration,
                    setting_.acceleration);
}

double Pilot::next_speed(const CarState& state) {
  read_cells(state);
  // Behind the line the sign has been dealt with.
  if (cell_ == setting_.cells) {
    if (stands(state)) return acceleration_ = 0;
    if (halted_ || manoeuvre_.kind == Manoeuvre::Kind::Slow) manoeuvre_ = {};
  }
  double acceleration = wanted_acceleration(state);
  if (setting_.brake_seconds > 0) {
    const double growth = setting_.most_deceleration / setting_.brake_seconds * setting_.step;
    acceleration = std::max(acceleration, std::min(acceleration_, 0.0) - growth);
  }
  const double next = std::max(0.0, state.speed + acceleration * setting_.step);
  acceleration_ = (next - state.speed) / setting_.step;
  return next;
}

}  // namespace heed::sim
