#pragma once

#include "walk.h"

#include <heed/game/game.h>

#include <cstdint>
#include <span>
#include <vector>

namespace heed::strategy {

/// Of the bits of \p owner, in the order of the variables.
[[nodiscard]] std::vector<Place> places(const game::Game& game, game::Owner owner);
/// Of the input bits, from the top of the diagrams down.
[[nodiscard]] std::vector<Place> input_route(const game::Game& game);

/// The letters that may come where a set of inputs is legal, as the tree of their beginnings in preorder:
/// many states share a set, and each of them follows the same branches with what is left of its own rules.
class Routes {
 public:
  struct Branch {
    std::uint32_t
        from;    ///< The branch that it continues; itself for the first, before any input has its value.
    bool value;  ///< What the next input bit is there.
    Letters::Id letter;  ///< Of a branch with all inputs, else none.
  };
  static constexpr Letters::Id none = UINT32_MAX;

  /// \param places  Of the input bits in the order of the walk.
  Routes(CofactorTable& legal, Letters& letters, std::vector<Place> places, model::Valuation lowest,
         model::MealyBuilder& builder);

  /// All branches where the inputs are legal that \p legal leaves, before any has its value. Valid until the
  /// next call. Linear in them at first, constant when asked again soon. \pre legal is not false
  [[nodiscard]] std::span<const Branch> of(CofactorTable::Id legal);

 private:
  struct Range {
    std::size_t first = 0;
    std::size_t count = 0;  ///< 0: not listed.
  };
  /// Some megabytes: then all are forgotten.
  static constexpr std::size_t most = std::size_t{1} << 18;

  void list(std::size_t depth, Letters::Id path, CofactorTable::Id legal, std::uint32_t here);

  CofactorTable& legal_;
  Letters& letters_;
  std::vector<Place> places_;
  model::Valuation letter_;  ///< Of the branch that is listed.
  model::MealyBuilder& builder_;
  std::size_t begin_ = 0;  ///< Of the tree that is listed.
  std::vector<Branch> branches_;
  std::vector<Range> ranges_;  ///< By vector of legal_.
};

}  // namespace heed::strategy
