#include "routes.h"

#include "steps.h"

#include <utility>

namespace heed::strategy {

std::vector<Place> places(const game::Game& game, game::Owner owner) {
  std::vector<Place> result;
  std::size_t index = 0;
  for (const game::Encoded& variable : game.variables) {
    if (variable.owner != owner) continue;
    for (std::size_t i = variable.bits.size(); i-- > 0;)
      result.push_back({index, static_cast<std::int32_t>(std::int64_t{1} << i)});
    ++index;
  }
  return result;
}

std::vector<Place> input_route(const game::Game& game) {
  const std::vector<Place> all = places(game, game::Owner::Input);
  std::vector<Place> route;
  for (const std::size_t i : by_level(game, game.bits(game::Owner::Input, true))) route.push_back(all[i]);
  return route;
}

Routes::Routes(CofactorTable& legal, Letters& letters, std::vector<Place> places, model::Valuation lowest,
               model::MealyBuilder& builder)
    : legal_(legal),
      letters_(letters),
      places_(std::move(places)),
      letter_(std::move(lowest)),
      builder_(builder) {
  branches_.reserve(usual);
}

void Routes::forget() {
  branches_.clear();
  ranges_.clear();
}

}  // namespace heed::strategy
