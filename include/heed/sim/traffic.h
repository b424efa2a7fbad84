#pragma once

#include <heed/util/limits.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace heed::sim {

/// A car where the traffic begins. Positions are those of its front, in metres from the line, negative before
/// it; SI units throughout.
struct TrafficCar {
  std::uint32_t road = 0;
  double position = 0, speed = 0;
  bool driven = false;  ///< By commands; else the simulator's driver does.
  double acceleration = 2.6;
  double deceleration = 4.5;  ///< Most that its driver uses by choice; of a driven car: can at all.
  double emergency = 9;       ///< What the brakes can do.
  double headway = 1;         ///< Seconds that its driver keeps to the car in front.
  double reaction = 0;        ///< Seconds between two decisions of its driver; 0: each step.
};

/// Parallel roads of one lane; the cars of one never meet those of another.
struct TrafficPlan {
  std::uint32_t roads = 1;
  double begin = -100, end = 100;  ///< Of each road, from the line.
  double speed = 10;               ///< Speed limit.
  double step = 0.1;               ///< Seconds, whole milliseconds.
  std::vector<TrafficCar> cars;    ///< Of one road: the first one in front.
};

struct CarState {
  double position = 0, speed = 0;
};

/// Length of every car, and the gap that a driver keeps at a standstill, in metres.
inline constexpr double car_length = 5, standstill_gap = 2.5;

/// The simulator itself refuses something: it cannot write its files, or does not understand them.
class TrafficError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A simulator of traffic. Each of its functions throws TrafficError.
class TrafficEngine {
 public:
  TrafficEngine() = default;
  TrafficEngine(const TrafficEngine&) = delete;
  TrafficEngine& operator=(const TrafficEngine&) = delete;
  virtual ~TrafficEngine() = default;

  /// Begins anew, at time 0.
  virtual void start(const TrafficPlan& plan) = 0;
  /// One step of TrafficPlan::step.
  virtual void advance() = 0;
  /// \param car  Index into TrafficPlan::cars, still on its road.
  [[nodiscard]] virtual CarState state(std::size_t car) = 0;
  /// The speed that a driven car is to have after the next step, within its limits.
  virtual void command(std::size_t car, double speed) = 0;
  [[nodiscard]] virtual std::string version() const = 0;
};

/// SUMO in this process, if this program was built with it and it is installed: a module of its own, loaded
/// when asked for, so that no other use of heed pays for SUMO's 200 libraries. One at a time.
/// \param module  Where it is; empty: beside the program (../lib/heed), or where it was built.
/// \throws util::InputError `no-sumo`  what is missing, and how to get it
[[nodiscard]] std::unique_ptr<TrafficEngine> load_sumo(const std::string& module = {});

/// What the car is to do from now on.
struct Manoeuvre {
  enum class Kind : std::uint8_t { Cruise, Slow, Stop };
  Kind kind = Kind::Cruise;
  double speed = 0;  ///< Of Slow.
};

/// A road, the car on it and those behind it. SI units.
struct RoadSetting {
  double cell = 10;
  std::uint32_t cells = 5;  ///< Cell c is entered (cells - 1 - c) * cell before the line, the last one at it.
  double speed = 50 / 3.6;
  double step = 0.08;
  double most_deceleration = 9;
  double comfortable_deceleration = 2.5;  ///< Towards a slower level.
  double acceleration = 2.6;
  double brake_seconds = 0;  ///< Until the brakes are at most_deceleration; what they do grows evenly.
  double halt_seconds = 2;   ///< How long the car stands.
  std::uint32_t followers = 1;
  double shortest_headway = 0.6, longest_headway = 2;  ///< Each driver behind has one of these, uniformly.
  double follower_deceleration = 4.5;                  ///< What drivers use, and expect of the car in front.
  double shortest_reaction = 0.5, longest_reaction = 1.5;  ///< And one of these, in seconds.
  double conflict_seconds = 1;                             ///< A time to collision below this is a conflict.
  double jerk_seconds = 0.4;  ///< Over which the change of the acceleration is taken.
};

/// The deceleration that halts a car after \p distance, at most \p most; that much where the line is behind.
[[nodiscard]] double braking_deceleration(double speed, double distance, double most);

/// What was seen of one road: the states of its cars, the car itself first, step by step.
struct Trajectory {
  double step = 0.1;
  std::size_t cars = 1;
  std::vector<CarState> states;  ///< [time * cars + car]

  [[nodiscard]] std::size_t times() const { return states.size() / cars; }
  [[nodiscard]] const CarState& at(std::size_t time, std::size_t car = 0) const {
    return states[time * cars + car];
  }
};

/// What one drive was like.
struct RoadMeasure {
  std::optional<double> overshoot;   ///< Where the car halted, in metres behind the line; none: it never did.
  double line_speed = 0;             ///< With which the front passed the line; 0: it halted before or at it.
  double peak_deceleration = 0;      ///< Of the car, up to its standstill.
  double peak_jerk = 0;              ///< |change of acceleration| / jerk_seconds, the same.
  double time_lost = 0;              ///< Against driving past freely.
  std::optional<double> least_gap;   ///< Between two cars; none: nobody drives behind.
  std::optional<double> least_time;  ///< To collision, where a car ever came closer to the one in front.
  double follower_deceleration = 0;  ///< The hardest of any driver behind.
  bool collision = false;            ///< Some gap was used up.
  bool conflict = false;             ///< A collision, or least_time below conflict_seconds.
};

/// \pre at least one state for each car, the same step as in \p setting. The car ends the drive behind
/// drive_end(setting).
[[nodiscard]] RoadMeasure measure(const Trajectory& trajectory, const RoadSetting& setting);

/// Where a drive ends, in metres behind the line: any car that stopped at the line or as late as it can is at
/// full speed again.
[[nodiscard]] double drive_end(const RoadSetting& setting);

/// The car's pilot: turns manoeuvres into speeds. One for each drive.
class Pilot {
 public:
  /// Asked once for each cell, when the car enters it, in their order.
  using Decide = std::function<Manoeuvre(std::uint32_t cell)>;
  Pilot(const RoadSetting& setting, Decide decide) : setting_(setting), decide_(std::move(decide)) {}

  /// The speed at the end of the next step of a car that is in \p state now.
  [[nodiscard]] double next_speed(const CarState& state);

 private:
  void read_cells(const CarState& state);
  [[nodiscard]] bool stands(const CarState& state);
  [[nodiscard]] double wanted_acceleration(const CarState& state) const;

  RoadSetting setting_;
  Decide decide_;
  Manoeuvre manoeuvre_;
  std::uint32_t cell_ = 0;   ///< The next one to be entered.
  double acceleration_ = 0;  ///< Of the step before.
  double stood_ = 0;         ///< Seconds.
  bool halted_ = false;
};

/// Which roads are driven. Road i is the same whatever the number of roads: what is drawn for it, the
/// drivers behind, is a function of (seed, i).
struct RoadBatch {
  std::uint64_t seed = 1, first = 0;
  std::uint32_t count = 1;
};

/// Drives down \p batch in one simulation. \param decide  (road of the batch, cell) to manoeuvre; asked in an
/// order that depends on where cars are. Cost: roads x cars x steps.
/// \throws util::LimitExceeded  the budget's; TrafficError  of the engine
[[nodiscard]] std::vector<Trajectory> drive_roads(
    TrafficEngine& engine, const RoadSetting& setting, const RoadBatch& batch,
    const std::function<Manoeuvre(std::uint32_t, std::uint32_t)>& decide, util::Budget& budget);

}  // namespace heed::sim
