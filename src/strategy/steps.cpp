#include "steps.h"

#include "rules.h"

#include <algorithm>

namespace heed::strategy {

namespace {

using bdd::Bdd;
using bdd::Var;
using game::Owner;

std::vector<Var> ordered_inputs(const game::Game& game, bool next) {
  const std::vector<Var> bits = game.bits(Owner::Input, next);
  std::vector<Var> order;
  order.reserve(bits.size());
  for (const std::size_t i : by_level(game, game.bits(Owner::Input, true))) order.push_back(bits[i]);
  return order;
}

std::vector<Var> answer_bits(const game::Game& game) {
  std::vector<Var> bits;
  for (const Owner owner : {Owner::Output, Owner::Memory})
    for (const Var variable : game.bits(owner, false)) bits.push_back(variable);
  return bits;
}

}  // namespace

std::vector<std::size_t> by_level(const game::Game& game, const std::vector<Var>& bits) {
  std::vector<std::size_t> order(bits.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return game.manager->level(bits[a]) < game.manager->level(bits[b]);
  });
  return order;
}

Steps::Steps(const game::Game& game, const game::Region& region, util::Budget& budget)
    : game_(game),
      goals_(game.sys_justice.size()),
      updates_(game.updates.size()),
      legal_parts_(legal_inputs(game)),
      columns_at_(legal_parts_.size() + updates_ + 3 * goals_),
      legal_(*game.manager, ordered_inputs(game, true), 1),
      rules_(*game.manager, ordered_inputs(game, true), Updates + updates_),
      futures_(*game.manager, ordered_inputs(game, false), columns_at_ + game.definitions.size() + goals_),
      answer_bits_(answer_bits(game)),
      answer_order_(by_level(game, answer_bits_)),
      answers_(answer_bits_.size()),
      columns_(game.definitions.size() + goals_),
      assignment_(game.manager->variable_count()) {
  const Bdd never = game.manager->constant(false);
  std::vector<Bdd> roots = legal_parts_, columns = game.definitions;
  roots.insert(roots.end(), game.updates.begin(), game.updates.end());
  const std::vector<Rule> rules = make_rules(game, region, budget);
  for (std::size_t goal = 0; goal < goals_; ++goal) {
    const game::Justice& justice = game.sys_justice[goal];
    roots.insert(roots.end(),
                 {rules[goal].moves, rules[goal].waits, justice.step ? justice.relation : never});
    columns.push_back(justice.step ? never : justice.relation);
    places_of_.emplace_back();
    const std::size_t updates_at = legal_parts_.size(), goals_at = updates_at + updates_;
    for (const std::size_t i : {Moves, Waits, Met})
      places_of_.back().push_back(static_cast<std::uint32_t>(goals_at + 3 * goal + i));
    for (std::size_t i = 0; i < updates_; ++i)
      places_of_.back().push_back(static_cast<std::uint32_t>(updates_at + i));
  }
  roots.insert(roots.end(), columns.begin(), columns.end());
  root_ = futures_.root(roots);
  std::reverse(answer_order_.begin(), answer_order_.end());
  cube_.push_back(game.manager->constant(true));
}

std::pair<std::uint32_t, bool> Steps::number(CofactorTable::Id future, std::uint32_t bits) {
  const auto [step, added] = steps_.number(std::array{future, bits});
  if (added) {
    columns_of_.push_back(evaluate_columns(future, bits));
    legal_of_.push_back(CofactorTable::none);
    rule_of_.resize(rule_of_.size() + goals_, CofactorTable::none);
  }
  return {step, added};
}

std::uint32_t Steps::evaluate_columns(CofactorTable::Id future, std::uint32_t bits) {
  for (std::size_t i = 0; i < answer_bits_.size(); ++i) assignment_[answer_bits_[i]] = answers_.bit(bits, i);
  std::vector<bool> shown(columns_.bits());
  for (std::size_t i = 0; i < shown.size(); ++i)
    shown[i] = futures_.evaluate(future, columns_at_ + i, assignment_);
  const std::uint32_t columns = columns_.number(shown);
  if (goals_after_.size() < columns_.size() * goals_)
    for (std::size_t goal = 0; goal < goals_; ++goal) goals_after_.push_back(next_goal(goal, shown));
  return columns;
}

std::uint32_t Steps::next_goal(std::size_t goal, const std::vector<bool>& shown) const {
  for (std::size_t i = 0; i < goals_; ++i) {
    const std::size_t candidate = (goal + i) % goals_;
    if (!shown[game_.definitions.size() + candidate]) return static_cast<std::uint32_t>(candidate);
  }
  return static_cast<std::uint32_t>(goal);
}

Future Steps::leads_to(const End& end) {
  CofactorTable::Id &legal = legal_of_[end.step], &rule = rule_of_[end.step * goals_ + end.goal];
  if (rule == CofactorTable::none) {
    const auto step = steps_[end.step];
    const Bdd& cube = cube_of(step[1]);
    if (legal == CofactorTable::none) legal = legal_after(step[0], cube);
    rule = rules_.root(futures_, step[0], places_of_[end.goal], cube);
  }
  return {legal, rule};
}

CofactorTable::Id Steps::legal_after(CofactorTable::Id future, const Bdd& cube) {
  constexpr std::array<std::uint32_t, 1> only{0};
  if (legal_parts_.size() == 1) return legal_.root(futures_, future, only, cube);
  std::array<Bdd, 1> legal{game_.manager->constant(true)};
  for (std::size_t i = 0; i < legal_parts_.size(); ++i)
    legal[0] &= futures_.function(future, i).cofactor(cube);
  return legal_.root(legal);
}

/// As a conjunction of literals, put together from the bottom up. Answers that are met one after the other
/// often differ near the top alone.
const Bdd& Steps::cube_of(std::uint32_t bits) {
  std::size_t from = cube_.size() - 1;
  for (std::size_t i = 0; i < from; ++i)
    if (answers_.bit(bits, answer_order_[i]) != answers_.bit(cube_bits_, answer_order_[i])) from = i;
  for (std::size_t i = from; i < answer_order_.size(); ++i) {
    const std::size_t k = answer_order_[i];
    const Bdd literal = game_.manager->literal(answer_bits_[k], answers_.bit(bits, k));
    if (cube_.size() == i + 1) cube_.emplace_back();
    cube_[i + 1] = literal & cube_[i];
  }
  cube_bits_ = bits;
  return cube_.back();
}

}  // namespace heed::strategy
