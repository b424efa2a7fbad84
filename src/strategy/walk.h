#pragma once

#include <heed/bdd/cofactor_table.h>
#include <heed/model/mealy.h>
#include <heed/util/word_table.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace heed::strategy {

using bdd::CofactorTable;

/// Where a bit stands in a valuation.
struct Place {
  std::size_t variable;
  std::int32_t weight;
};

/// All that a reaction depends on, but for the states that are there.
struct Situation {
  CofactorTable::Id left;    ///< Of the state, once the observation is put in.
  CofactorTable::Id future;  ///< Of the step to come, once the observation is put in.
  std::uint32_t mode;        ///< The goal, and what was chosen before the observation came, by number.

  [[nodiscard]] std::array<std::uint32_t, 3> word() const { return {left, future, mode}; }
};

/// What is left of the functions of a state's future: the inputs that may come, and all others. They are
/// apart since many states share one of the two alone.
struct Future {
  CofactorTable::Id legal = 0;
  CofactorTable::Id rule = 0;
};

/// What follows from a situation.
struct Reaction {
  std::uint32_t output = 0;  ///< The builder's number of the letter.
  Future future;             ///< The next state's, with its goal.
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

/// A part of a list of answers.
struct Answers {
  std::uint32_t first = 0;
  std::uint32_t count = 0;  ///< 0: not listed yet.
};

/// A step by number, and the goal that is next.
struct End {
  std::uint32_t step;
  std::uint32_t goal;
};

/// Words of bits, numbered in the order of their discovery.
class BitWords {
 public:
  explicit BitWords(std::size_t bits) : bits_(bits), packed_((bits + 31) / 32), words_(packed_.size()) {}

  std::uint32_t number(const std::vector<bool>& word) {
    packed_.assign(packed_.size(), 0);
    for (std::size_t i = 0; i < bits_; ++i)
      if (word[i]) packed_[i / 32] |= 1U << (i % 32);
    return words_.number(std::span<const std::uint32_t>(packed_)).first;
  }
  [[nodiscard]] bool bit(std::uint32_t number, std::size_t i) const {
    return (words_[number][i / 32] >> (i % 32) & 1U) != 0;
  }
  [[nodiscard]] std::size_t bits() const { return bits_; }
  [[nodiscard]] std::size_t size() const { return words_.size(); }

 private:
  std::size_t bits_;
  std::vector<std::uint32_t> packed_;
  util::WordTable words_;
};

/// The input letters by the path of the walk that leads to them: each state lists the same letters, and a
/// path costs nothing that the walk does not do anyway.
class Letters {
 public:
  using Id = std::uint32_t;
  static constexpr Id root = 0;

  struct Leaf {
    std::uint32_t number;      ///< The builder's.
    CofactorTable::Id future;  ///< What is left of all goals' rules.
  };

  /// \param start  What is left of all goals' rules before any input bit has its value.
  Letters(CofactorTable& futures, CofactorTable::Id start)
      : futures_(futures), nodes_{Node{.future = start}} {}

  [[nodiscard]] Id step(Id path, bool value) {
    const Id known = nodes_[path].next[value ? 1 : 0];
    return known != root ? known : add(path, value);
  }
  /// Says which letter a path with all inputs spells.
  void name(Id path, const model::Valuation& letter, model::MealyBuilder& builder) {
    if (nodes_[path].letter == unknown) nodes_[path].letter = builder.input_letter(letter);
  }
  /// \pre name() was called for \p path
  [[nodiscard]] Leaf leaf(Id path) const { return {nodes_[path].letter, nodes_[path].future}; }

 private:
  static constexpr std::uint32_t unknown = UINT32_MAX;
  struct Node {
    std::array<Id, 2> next{root, root};
    CofactorTable::Id future;
    std::uint32_t letter = unknown;
  };

  Id add(Id path, bool value) {
    const auto added = static_cast<Id>(nodes_.size());
    nodes_.push_back({.future = futures_.step(nodes_[path].future, value)});
    nodes_[path].next[value ? 1 : 0] = added;
    return added;
  }

  CofactorTable& futures_;
  std::vector<Node> nodes_;
};

}  // namespace heed::strategy
