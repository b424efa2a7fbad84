#pragma once

#include "cofactors.h"

#include <heed/model/mealy.h>
#include <heed/util/hash.h>

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace heed::strategy {

/// All that a reaction depends on, but for the states that are there.
struct Situation {
  Cofactors::Id left;    ///< Of the state, once the observation is put in.
  Cofactors::Id future;  ///< Of the step to come, once the observation is put in.
  std::uint32_t goal;
  std::uint32_t choice;  ///< What was chosen before the observation came, by number.
  bool operator==(const Situation&) const = default;
};

struct SituationHash {
  std::size_t operator()(const Situation& at) const {
    return util::mix((std::uint64_t{at.left} << 32) | at.future, (std::uint64_t{at.goal} << 32) | at.choice);
  }
};

/// What follows from a situation.
struct Reaction {
  std::uint32_t output = 0;  ///< The builder's number of the letter.
  Cofactors::Id future = 0;  ///< The next state's, with its goal.
  std::uint32_t goal = 0;
  bool waits = false;
  std::uint32_t next = unknown;  ///< The state, where no observation belongs to it.

  static constexpr std::uint32_t unknown = UINT32_MAX;
};

/// An answer to an observation: its bits by number, and whether it waits for an assumption or meets a goal of
/// the step.
struct Answer {
  std::uint32_t bits = 0;
  bool waits = false;
  bool met = false;
};

/// A step by its inputs and the answer, and the goal that is next.
struct End {
  Cofactors::Id future;  ///< Of all goals, the inputs put in.
  std::uint32_t bits;
  std::uint32_t goal;
  bool operator==(const End&) const = default;
};

struct EndHash {
  std::size_t operator()(const End& end) const {
    return util::mix((std::uint64_t{end.future} << 32) | end.bits, end.goal);
  }
};

/// Words of bits, numbered in the order of their discovery.
class Words {
 public:
  std::uint32_t number(std::vector<bool> word) {
    const auto [found, added] =
        numbers_.try_emplace(std::move(word), static_cast<std::uint32_t>(words_.size()));
    if (added) words_.push_back(&found->first);
    return found->second;
  }
  [[nodiscard]] const std::vector<bool>& operator[](std::uint32_t number) const { return *words_[number]; }
  [[nodiscard]] std::size_t size() const { return words_.size(); }

 private:
  std::unordered_map<std::vector<bool>, std::uint32_t> numbers_;
  std::vector<const std::vector<bool>*> words_;
};

/// The input letters by the path of the walk that leads to them: each state lists the same letters, and a
/// path costs nothing that the walk does not do anyway.
class Letters {
 public:
  using Id = std::uint32_t;
  static constexpr Id root = 0;

  struct Leaf {
    std::uint32_t number;  ///< The builder's.
    Cofactors::Id future;  ///< What is left of all goals' rules.
  };

  /// \param start  What is left of all goals' rules before any input bit has its value.
  Letters(Cofactors& futures, Cofactors::Id start) : futures_(futures), nodes_{Node{{0, 0}, start, {}}} {}

  [[nodiscard]] Id step(Id path, bool value) {
    const Id known = nodes_[path].next[value ? 1 : 0];
    if (known != root) return known;
    const auto added = static_cast<Id>(nodes_.size());
    nodes_.push_back({{0, 0}, futures_.step(nodes_[path].future, value), {}});
    nodes_[path].next[value ? 1 : 0] = added;
    return added;
  }
  [[nodiscard]] Leaf leaf(Id path, const model::Valuation& letter, model::MealyBuilder& builder) {
    Node& node = nodes_[path];
    if (!node.letter) node.letter = builder.input_letter(letter);
    return {*node.letter, node.future};
  }

 private:
  struct Node {
    std::array<Id, 2> next;
    Cofactors::Id future;
    std::optional<std::uint32_t> letter;
  };
  Cofactors& futures_;
  std::vector<Node> nodes_;
};

}  // namespace heed::strategy
