#include "routes.h"

#include <utility>

namespace heed::strategy {

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
