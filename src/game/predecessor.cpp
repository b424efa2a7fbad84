#include "schedule.h"

#include <heed/game/solve.h>

#include <algorithm>

/// With rho_s split into what mentions Y' and the rest, and the environment's choice in the form
/// `exists` so that both quantifiers meet conjunctions:
///
///     answered(T) = exists Y' . rho_s with Y' & T         (Moore: without the quantifier)
///     forced(S)   = exists X' M' . rho_e & M' = update & S
///     cpre(T)     = ! forced(! answered(T)) & ! forced(! rest)
///
/// The last term is the same for every T: it is computed once.
namespace heed::game {
namespace {

using bdd::Bdd;

bool disjoint(const std::vector<bdd::Var>& support, const std::vector<bdd::Var>& variables) {
  return std::none_of(variables.begin(), variables.end(), [&](bdd::Var variable) {
    return std::binary_search(support.begin(), support.end(), variable);
  });
}

}  // namespace

Predecessor::Predecessor(const Game& game, const Techniques& techniques)
    : game_(game), moore_(game.spec->timing == spec::Timing::Moore), rest_(game.manager->constant(true)) {
  const std::vector<bdd::Var> next_outputs = game.bits(Owner::Output, true);
  std::vector<Bdd> with_outputs;
  for (const Part& part : game.sys_safety) {
    if (disjoint(part.relation.support_variables(), next_outputs))
      rest_ &= part.relation;
    else
      with_outputs.push_back(part.relation);
  }
  outputs_ = schedule(std::move(with_outputs), moore_ ? game.manager->constant(true) : game.next_outputs,
                      techniques);
  std::vector<Bdd> moves = techniques.partition_environment
                               ? game.env_steps
                               : std::vector<Bdd>{game.manager->conjunction(game.env_safety)};
  const std::vector<bdd::Var> next_memories = game.bits(Owner::Memory, true);
  for (std::size_t i = 0; i < next_memories.size(); ++i)
    moves.push_back(game.manager->variable(next_memories[i]).iff(game.updates[i]));
  moves_ = schedule(std::move(moves), game.next_inputs & game.next_memories, techniques);
  doomed_ = forced(!rest_);
}

Bdd Predecessor::forced(Bdd steps) const {
  for (const Stage& stage : moves_) steps = steps.and_exists(stage.relation, stage.cube);
  return steps;
}

Bdd Predecessor::answered(const Bdd& target) const {
  const Stage& first = outputs_.front();
  Bdd pairs = first.relation.and_exists_next(target, first.cube);
  for (std::size_t i = 1; i < outputs_.size(); ++i)
    pairs = pairs.and_exists(outputs_[i].relation, outputs_[i].cube);
  return pairs;
}

Bdd Predecessor::answered_in(Bdd target) const {
  for (const Stage& stage : outputs_) target = target.and_exists(stage.relation, stage.cube);
  return target;
}

Bdd Predecessor::close(const Bdd& answered) const {
  const Bdd wins = !(forced(!answered) | doomed_);
  return moore_ ? wins.exists(game_.next_outputs) : wins;
}

Bdd Predecessor::of_set(const Bdd& target) const {
  ++computed_;
  return close(answered(target));
}

Bdd Predecessor::of_relation(const Bdd& target) const {
  ++computed_;
  return close(answered_in(target));
}

Bdd Predecessor::answers(const Bdd& target) const {
  return answered_in(target) & rest_;
}

}  // namespace heed::game
