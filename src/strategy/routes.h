#pragma once

#include "walk.h"

#include <heed/game/game.h>

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace heed::strategy {

/// Of the bits of \p owner, in the order of the variables.
[[nodiscard]] std::vector<Place> places(const game::Game& game, game::Owner owner);
/// Of the input bits, from the top of the diagrams down.
[[nodiscard]] std::vector<Place> input_route(const game::Game& game);

/// The letters that may come where a set of inputs is legal, as the tree of their beginnings: many states
/// share a set, and each of them follows the same branches with what is left of its own rules.
class Routes {
 public:
  /// A beginning; the last one before it that is shorter by a bit is the one that it continues.
  struct Branch {
    std::uint32_t depth;  ///< Input bits that have a value.
    bool value;           ///< Of the last of them.
    Letters::Id letter;   ///< Where all have one, else none.
  };
  static constexpr Letters::Id none = UINT32_MAX;

  /// \param places  Of the input bits in the order of the walk.
  Routes(CofactorTable& legal, Letters& letters, std::vector<Place> places, model::Valuation lowest,
         model::MealyBuilder& builder);

  /// Calls \p visit with every branch where the inputs are legal that \p legal leaves, before any has its
  /// value, in preorder. They are found on the way; sets of usual size are remembered. \pre legal is not
  /// false
  template <typename Visit>
  void each(CofactorTable::Id legal, Visit&& visit) {
    if (branches_.size() > most) forget();
    const auto known = ranges_.find(legal);
    if (known != ranges_.end()) {
      for (std::size_t i = known->second.begin; i < known->second.end; ++i) visit(branches_[i]);
      return;
    }
    const std::size_t begin = branches_.size();
    find({0, false, none}, Letters::root, legal, [&](const Branch& branch) {
      visit(branch);
      if (branches_.size() - begin <= most) branches_.push_back(branch);
    });
    if (branches_.size() - begin <= most)
      ranges_.emplace(legal, Range{begin, branches_.size()});
    else
      branches_.resize(begin);
  }

 private:
  struct Range {
    std::size_t begin, end;
  };
  /// Branches of one set that are remembered. With as many of all, some megabytes, all are forgotten.
  static constexpr std::size_t most = std::size_t{1} << 18;
  /// Few sets of letters need more.
  static constexpr std::size_t usual = std::size_t{1} << 14;

  /// \p branch and all that continue it.
  template <typename Found>
  void find(Branch branch, Letters::Id path, CofactorTable::Id legal, const Found& found) {
    if (branch.depth == places_.size()) {
      letters_.name(path, letter_, builder_);
      branch.letter = path;
      found(branch);
      return;
    }
    found(branch);
    const Place& place = places_[branch.depth];
    for (const bool value : {false, true}) {
      const CofactorTable::Id next = legal_.step(legal, value);
      if (legal_.is_false(next, 0)) continue;
      if (value) letter_[place.variable] += place.weight;
      find({branch.depth + 1, value, none}, letters_.step(path, value), next, found);
      if (value) letter_[place.variable] -= place.weight;
    }
  }
  void forget();

  CofactorTable& legal_;
  Letters& letters_;
  std::vector<Place> places_;
  model::Valuation letter_;  ///< Of the branch that is found.
  model::MealyBuilder& builder_;
  std::vector<Branch> branches_;
  std::unordered_map<CofactorTable::Id, Range> ranges_;
};

}  // namespace heed::strategy
