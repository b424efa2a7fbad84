#pragma once

#include <heed/sim/traffic.h>

#include <algorithm>
#include <string>
#include <vector>

namespace heed::sim {

/// A simulator for tests: a driven car has the speed that it is told within its limits, the others keep
/// theirs. The speed changes evenly within a step.
class Frictionless final : public TrafficEngine {
 public:
  void start(const TrafficPlan& given) override {
    plan = given;
    cars_.clear();
    for (const TrafficCar& car : plan.cars) cars_.push_back({{car.position, car.speed}, car.speed});
  }
  void advance() override {
    for (std::size_t i = 0; i < cars_.size(); ++i) {
      CarState& state = cars_[i].state;
      const double next = std::clamp(cars_[i].wanted, state.speed - plan.cars[i].deceleration * plan.step,
                                     state.speed + plan.cars[i].acceleration * plan.step);
      state.position += (state.speed + next) / 2 * plan.step;
      state.speed = next;
    }
  }
  CarState state(std::size_t car) override { return cars_[car].state; }
  void command(std::size_t car, double speed) override { cars_[car].wanted = speed; }
  std::string version() const override { return "frictionless"; }

  TrafficPlan plan;

 private:
  struct Car {
    CarState state;
    double wanted;
  };
  std::vector<Car> cars_;
};

}  // namespace heed::sim
