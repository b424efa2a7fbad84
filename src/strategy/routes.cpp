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
      builder_(builder) {}

std::span<const Routes::Branch> Routes::of(CofactorTable::Id legal) {
  if (branches_.size() > most) {
    branches_.clear();
    ranges_.clear();
  }
  if (ranges_.size() <= legal) ranges_.resize(legal + 1);
  if (ranges_[legal].count == 0) {
    begin_ = branches_.size();
    branches_.push_back({0, false, none});
    list(0, Letters::root, legal, 0);
    ranges_[legal] = {begin_, branches_.size() - begin_};
  }
  return {branches_.data() + ranges_[legal].first, ranges_[legal].count};
}

void Routes::list(std::size_t depth, Letters::Id path, CofactorTable::Id legal, std::uint32_t here) {
  if (depth == places_.size()) {
    letters_.name(path, letter_, builder_);
    branches_.back().letter = path;
    return;
  }
  const Place& place = places_[depth];
  for (const bool value : {false, true}) {
    const CofactorTable::Id next = legal_.step(legal, value);
    if (legal_.is_false(next, 0)) continue;
    const auto branch = static_cast<std::uint32_t>(branches_.size() - begin_);
    branches_.push_back({here, value, none});
    if (value) letter_[place.variable] += place.weight;
    list(depth + 1, letters_.step(path, value), next, branch);
    if (value) letter_[place.variable] -= place.weight;
  }
}

}  // namespace heed::strategy
