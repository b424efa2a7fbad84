#include <heed/game/solve.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace heed::game {
namespace {

using bdd::Bdd;

/// Clusters stay below this many nodes: larger ones cost more to conjoin than the passes they save.
constexpr std::size_t cluster_nodes = 2500;

bool disjoint(const std::vector<bdd::Var>& support, const std::vector<bdd::Var>& variables) {
  return std::none_of(variables.begin(), variables.end(), [&](bdd::Var variable) {
    return std::binary_search(support.begin(), support.end(), variable);
  });
}

/// Neighbours in the list conjoined while the result stays small.
std::vector<Bdd> clustered(const std::vector<Bdd>& parts) {
  std::vector<Bdd> clusters;
  for (const Bdd& part : parts) {
    if (part.is_true()) continue;
    if (!clusters.empty()) {
      const Bdd joined = clusters.back() & part;
      if (joined.node_count() <= cluster_nodes) {
        clusters.back() = joined;
        continue;
      }
    }
    clusters.push_back(part);
  }
  return clusters;
}

/// Which variables of a cube each part has, and which of them no other part that is left has.
class Greedy {
 public:
  Greedy(const std::vector<Bdd>& parts, const std::vector<bdd::Var>& variables)
      : supports_(parts.size()), own_(parts.size(), 0), taken_(parts.size(), false) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (const bdd::Var variable : parts[i].support_variables()) {
        if (!std::binary_search(variables.begin(), variables.end(), variable)) continue;
        supports_[i].push_back(variable);
        users_[variable].push_back(i);
      }
    }
    for (auto& [variable, users] : users_) {
      left_[variable] = users.size();
      if (users.size() == 1) ++own_[users.front()];
    }
  }

  /// Most variables to quantify at once; among equals, fewest to keep.
  [[nodiscard]] bool better(std::size_t a, std::size_t b) const {
    if (own_[a] != own_[b]) return own_[a] > own_[b];
    return supports_[a].size() < supports_[b].size();
  }

  void take(std::size_t part) {
    taken_[part] = true;
    for (const bdd::Var variable : supports_[part]) {
      if (--left_[variable] != 1) continue;
      for (const std::size_t user : users_[variable]) own_[user] += taken_[user] ? 0 : 1;
    }
  }

 private:
  std::vector<std::vector<bdd::Var>> supports_;
  std::vector<std::size_t> own_;
  std::vector<bool> taken_;
  std::map<bdd::Var, std::vector<std::size_t>> users_;
  std::map<bdd::Var, std::size_t> left_;
};

/// The conjunct with most variables that no other one has comes first, and so on. \cite firman.20.acta
std::vector<Bdd> by_private_variables(const std::vector<Bdd>& parts, const std::vector<bdd::Var>& variables) {
  Greedy greedy(parts, variables);
  std::vector<std::size_t> left(parts.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<Bdd> order;
  while (!left.empty()) {
    const auto best = std::min_element(left.begin(), left.end(),
                                       [&](std::size_t a, std::size_t b) { return greedy.better(a, b); });
    greedy.take(*best);
    order.push_back(parts[*best]);
    left.erase(best);
  }
  return order;
}

}  // namespace

std::vector<Predecessor::Stage> Predecessor::schedule(std::vector<Bdd> parts, const Bdd& cube, bool greedy) {
  std::vector<Stage> stages;
  if (greedy) parts = by_private_variables(parts, cube.support_variables());
  parts = clustered(parts);
  std::vector<bdd::Var> open = cube.support_variables();
  std::vector<Bdd> cubes;
  bdd::Manager& manager = cube.manager();
  // From the back: a variable is quantified at the last stage that mentions it, or at the first.
  for (std::size_t i = parts.size(); i-- > 0;) {
    const std::vector<bdd::Var> support = parts[i].support_variables();
    std::vector<bdd::Var> here;
    std::vector<bdd::Var> earlier;
    for (const bdd::Var variable : open) {
      const bool mentioned = i == 0 || std::binary_search(support.begin(), support.end(), variable);
      (mentioned ? here : earlier).push_back(variable);
    }
    stages.push_back({parts[i], manager.cube(here)});
    open = std::move(earlier);
  }
  if (parts.empty()) stages.push_back({manager.constant(true), cube});
  std::reverse(stages.begin(), stages.end());
  return stages;
}

Predecessor::Predecessor(const Game& game, bool greedy_schedule)
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
                      greedy_schedule);
  std::vector<Bdd> updates;
  const std::vector<bdd::Var> next_memories = game.bits(Owner::Memory, true);
  for (std::size_t i = 0; i < next_memories.size(); ++i)
    updates.push_back(game.manager->variable(next_memories[i]).iff(game.updates[i]));
  memories_ = schedule(std::move(updates), game.next_memories, greedy_schedule);
}

Bdd Predecessor::without_outputs(Bdd target) const {
  for (const Stage& stage : outputs_) target = target.and_exists(stage.relation, stage.cube);
  return target;
}

Bdd Predecessor::close(const Bdd& answered) const {
  if (!moore_) {
    Bdd wins = answered & rest_;
    if (game_.updates.empty()) return game_.env_safety.implies_forall(wins, game_.next_inputs);
    wins = game_.env_safety.implies(wins);
    for (const Stage& stage : memories_) wins = wins.and_exists(stage.relation, stage.cube);
    return wins.forall(game_.next_inputs);
  }
  Bdd wins = game_.env_safety.implies(answered & rest_);
  for (const Stage& stage : memories_) wins = wins.and_exists(stage.relation, stage.cube);
  return wins.forall(game_.next_inputs).exists(game_.next_outputs);
}

Bdd Predecessor::of_set(const Bdd& target) const {
  ++computed_;
  const Stage& first = outputs_.front();
  Bdd answered = first.relation.and_exists_next(target, first.cube);
  for (std::size_t i = 1; i < outputs_.size(); ++i)
    answered = answered.and_exists(outputs_[i].relation, outputs_[i].cube);
  return close(answered);
}

Bdd Predecessor::of_relation(const Bdd& target) const {
  ++computed_;
  return close(without_outputs(target));
}

Bdd Predecessor::answers(const Bdd& target) const {
  return without_outputs(target) & rest_;
}

}  // namespace heed::game
