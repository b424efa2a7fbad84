#pragma once

#include "cofactors.h"

#include <heed/model/mealy.h>
#include <heed/util/hash.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace heed::strategy {

/// All that a choice among answers depends on, but for the states that are there.
struct Situation {
  Cofactors::Id state, future;
  std::uint32_t goal;
  bool operator==(const Situation&) const = default;
};

struct SituationHash {
  std::size_t operator()(const Situation& at) const {
    return util::mix(util::mix(at.state, at.future), at.goal);
  }
};

/// The builder's numbers of input letters, found again by the path of the walk that leads to them: each state
/// lists the same letters, and a path costs nothing that the walk does not do anyway.
class LetterPaths {
 public:
  using Id = std::uint32_t;

  [[nodiscard]] Id step(Id path, bool value) {
    const Id known = nodes_[path].next[value ? 1 : 0];
    if (known != 0) return known;
    const auto added = static_cast<Id>(nodes_.size());
    nodes_.emplace_back();
    nodes_[path].next[value ? 1 : 0] = added;
    return added;
  }
  [[nodiscard]] std::uint32_t letter(Id path, const model::Valuation& letter, model::MealyBuilder& builder) {
    std::optional<std::uint32_t>& known = nodes_[path].letter;
    if (!known) known = builder.input_letter(letter);
    return *known;
  }

 private:
  struct Node {
    std::array<Id, 2> next{0, 0};
    std::optional<std::uint32_t> letter;
  };
  std::vector<Node> nodes_{Node{}};  ///< The root is 0, and nobody's successor.
};

}  // namespace heed::strategy
