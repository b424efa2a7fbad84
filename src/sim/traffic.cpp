// The closed loop: all roads of a batch stand side by side in one simulation, and each car's pilot is asked
// before every step.
#include <heed/sim/traffic.h>
#include <heed/util/random.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace heed::sim {
namespace {

/// The drivers' stream is none that perception draws from: those have the seed itself as key.
constexpr std::uint64_t drivers_key = 0x9E3779B97F4A7C15;

/// From the start to the horizon: a cell or a little more, a whole number of steps, so that a car at full
/// speed enters the first cell at the end of a step.
double lead_in(const RoadSetting& setting) {
  const double way = setting.speed * setting.step;
  return std::ceil(setting.cell / way - 1e-9) * way;
}

double start_of(const RoadSetting& setting) {
  return -static_cast<double>(setting.cells - 1) * setting.cell - lead_in(setting);
}

TrafficPlan plan_of(const RoadSetting& setting, const RoadBatch& batch) {
  TrafficPlan plan;
  plan.roads = batch.count;
  const double room = car_length + standstill_gap + setting.longest_headway * setting.speed;
  plan.begin = start_of(setting) - (setting.followers + 1) * room;
  plan.end = drive_end(setting) + setting.speed * setting.step + 1;
  plan.speed = setting.speed;
  plan.step = setting.step;
  for (std::uint32_t road = 0; road < batch.count; ++road) {
    util::CounterRandom random(batch.seed + drivers_key, batch.first + road);
    TrafficCar car{road,
                   start_of(setting),
                   setting.speed,
                   true,
                   setting.acceleration,
                   setting.most_deceleration,
                   setting.most_deceleration};
    plan.cars.push_back(car);
    const auto between = [&](double low, double high) { return low + random.uniform() * (high - low); };
    for (std::uint32_t k = 0; k < setting.followers; ++k) {
      car.driven = false;
      car.deceleration = setting.follower_deceleration;
      car.emergency = std::max(setting.most_deceleration, setting.follower_deceleration);
      car.headway = between(setting.shortest_headway, setting.longest_headway);
      car.reaction = between(setting.shortest_reaction, setting.longest_reaction);
      car.position -= car_length + standstill_gap + car.headway * setting.speed;
      plan.cars.push_back(car);
    }
  }
  return plan;
}

/// No drive lasts longer: slow levels are at least a tenth of the speed.
std::size_t most_steps(const RoadSetting& setting) {
  const double way = drive_end(setting) - start_of(setting);
  return static_cast<std::size_t>((20 * way / setting.speed + setting.halt_seconds + 60) / setting.step);
}

}  // namespace

std::vector<Trajectory> drive_roads(TrafficEngine& engine, const RoadSetting& setting, const RoadBatch& batch,
                                    const std::function<Manoeuvre(std::uint32_t, std::uint32_t)>& decide,
                                    util::Budget& budget) {
  const std::size_t cars = 1 + setting.followers;
  const double end = drive_end(setting);
  const TrafficPlan plan = plan_of(setting, batch);
  std::vector<Trajectory> roads(batch.count, Trajectory{setting.step, cars, {}});
  std::vector<Pilot> pilots;
  for (std::uint32_t road = 0; road < batch.count; ++road)
    pilots.emplace_back(setting, [&decide, road](std::uint32_t cell) { return decide(road, cell); });
  engine.start(plan);
  std::vector<std::uint32_t> driving(batch.count);
  for (std::uint32_t road = 0; road < batch.count; ++road) driving[road] = road;
  for (std::size_t step = 0; !driving.empty(); ++step) {
    if (step > most_steps(setting)) throw std::runtime_error("a car does not arrive");
    std::erase_if(driving, [&](std::uint32_t road) {
      budget.check();
      for (std::size_t car = 0; car < cars; ++car)
        roads[road].states.push_back(engine.state(road * cars + car));
      const CarState& own = roads[road].at(step);
      if (own.position >= end) return true;
      engine.command(road * cars, pilots[road].next_speed(own));
      return false;
    });
    if (!driving.empty()) engine.advance();
  }
  return roads;
}

}  // namespace heed::sim
