#pragma once

#include "walk.h"

#include <heed/game/game.h>
#include <heed/game/solve.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace heed::strategy {

/// Functions of a state's future besides the legal inputs, in this order; the updates of the memories' bits
/// follow.
enum Slot : std::size_t { Moves, Waits, Met, Updates };

/// Places in \p bits from the top of the diagrams down. In this order a walk touches few nodes.
[[nodiscard]] std::vector<std::size_t> by_level(const game::Game& game, const std::vector<bdd::Var>& bits);

/// Where steps lead. A step is what is left of the functions over the step to come (the rules of all goals,
/// the columns) once its inputs are put in, and an answer. What a state needs of its future is of one goal
/// alone, and the legal inputs stand apart: many states share one of the two alone.
class Steps {
 public:
  Steps(const game::Game& game, const game::Region& region, util::Budget& budget);

  /// Over X': the legal inputs in one state.
  CofactorTable& legal() { return legal_; }
  /// Over X': all else of the future of one state, by Slot.
  CofactorTable& rules() { return rules_; }
  /// Over X: the futures of all goals, then definitions and goals without Next.
  CofactorTable& futures() { return futures_; }
  /// What is left of the futures before any input has its value.
  [[nodiscard]] CofactorTable::Id root() const { return root_; }
  /// Answers by number: outputs, then memories.
  [[nodiscard]] const BitWords& answers() const { return answers_; }
  std::uint32_t number_answer(const std::vector<bool>& bits) { return answers_.number(bits); }

  /// The number of a step, and whether it is new. \param future  With all inputs put in. \param bits  An
  /// answer.
  std::pair<std::uint32_t, bool> number(CofactorTable::Id future, std::uint32_t bits);
  /// The definitions and goals that hold after it, by number.
  [[nodiscard]] std::uint32_t columns(std::uint32_t step) const { return columns_of_[step]; }
  [[nodiscard]] bool column(std::uint32_t columns, std::size_t i) const { return columns_.bit(columns, i); }
  /// The goal to follow after \p goal: goals that the new state meets are done; one that all states meet is
  /// as good as any.
  [[nodiscard]] std::uint32_t goal_after(std::uint32_t step, std::size_t goal) const {
    return goals_after_[columns_of_[step] * goals_ + goal];
  }
  /// Whether leads_to() was asked for it before.
  [[nodiscard]] bool is_known(const End& end) const {
    return rule_of_[end.step * goals_ + end.goal] != CofactorTable::none;
  }
  /// What is left of the rules of one goal after a step: the key of the state that the step leads to.
  Future leads_to(const End& end);

 private:
  [[nodiscard]] std::uint32_t evaluate_columns(CofactorTable::Id future, std::uint32_t bits);
  [[nodiscard]] std::uint32_t next_goal(std::size_t goal, const std::vector<bool>& shown) const;
  [[nodiscard]] CofactorTable::Id legal_after(CofactorTable::Id future, const bdd::Bdd& cube);
  [[nodiscard]] const bdd::Bdd& cube_of(std::uint32_t bits);

  const game::Game& game_;
  std::size_t goals_;
  std::size_t updates_;
  std::vector<bdd::Bdd> legal_parts_;  ///< Of the legal inputs; first in the vectors of futures_.
  std::size_t columns_at_;             ///< There.
  CofactorTable legal_, rules_, futures_;
  CofactorTable::Id root_ = 0;
  /// By goal: where in a vector of futures_ the functions by Slot stand.
  std::vector<std::vector<std::uint32_t>> places_of_;
  std::vector<bdd::Var> answer_bits_;      ///< Current: outputs, then memories.
  std::vector<std::size_t> answer_order_;  ///< Places in answer_bits_, from the bottom up.
  std::vector<bdd::Bdd> cube_;             ///< By length, of the answer that was last asked for:
  std::uint32_t cube_bits_ = 0;
  BitWords answers_, columns_;
  std::vector<bool> assignment_;  ///< By variable, for evaluation.
  util::WordTable steps_{2};      ///< A future and an answer, and by number:
  std::vector<std::uint32_t> columns_of_;
  std::vector<CofactorTable::Id> legal_of_;  ///< The inputs that may come then, or none yet.
  std::vector<CofactorTable::Id> rule_of_;   ///< By step and goal: what is left of the rule, or none yet.
  std::vector<std::uint32_t> goals_after_;   ///< By columns and goal.
};

}  // namespace heed::strategy
