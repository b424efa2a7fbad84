#pragma once

#include <heed/game/game.h>
#include <heed/model/symbolic.h>

#include <cstdint>
#include <vector>

namespace heed::strategy {

/// Gathers functions of a game and writes them down at once. Until then a Function stands for its place in
/// the list; resolve() makes it what it is in the diagrams.
class DiagramWriter {
 public:
  explicit DiagramWriter(const game::Game& game) : game_(game) {}

  [[nodiscard]] model::Function add(const bdd::Bdd& function);
  [[nodiscard]] std::vector<model::Function> add(const std::vector<bdd::Bdd>& functions);
  /// \pre called once, after every add()
  [[nodiscard]] model::Diagrams finish();
  void resolve(model::Function& place) const { place = roots_[place]; }
  void resolve(std::vector<model::Function>& places) const {
    for (model::Function& place : places) resolve(place);
  }
  void resolve(std::vector<model::Level>& levels) const {
    for (model::Level& level : levels) resolve(level.states);
  }

 private:
  const game::Game& game_;
  std::vector<bdd::Bdd> functions_;
  std::vector<model::Function> roots_;
};

}  // namespace heed::strategy
