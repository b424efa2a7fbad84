#include "ranking.h"

#include <fmt/format.h>

namespace heed::certify {

using bdd::Bdd;

bool Findings::none(const Bdd& bad, const std::string& what) {
  ++verdict_.checks;
  if (bad.is_false()) return true;
  if (!sound()) return false;
  verdict_.fault =
      bad.is_true() ? what + ", everywhere" : fmt::format("{}, such as {}", what, board_.example(bad));
  return false;
}

bool Findings::require(bool holds, const std::string& what) {
  ++verdict_.checks;
  if (!holds && sound()) verdict_.fault = what;
  return holds;
}

Verdict Findings::verdict() const {
  Verdict result = verdict_;
  result.certified = sound();
  return result;
}

bool of_states(const Board& board, const std::vector<Bdd>& functions) {
  std::vector<bool> next(board.encoding().manager().variable_count(), false);
  for (const Owner owner : {Owner::Input, Owner::Output, Owner::Memory})
    for (const bdd::Var variable : board.encoding().bits(owner, true)) next[variable] = true;
  for (const Bdd& function : functions)
    for (const bdd::Var variable : function.support_variables())
      if (next[variable]) return false;
  return true;
}

namespace {

/// Long rankings have small sets with much in common, such as distances: many ranks in one look. Large sets
/// go one by one, since a set before a step and one after it have little in common.
class Block {
 public:
  explicit Block(const Board& board) : never_(board.encoding().constant(false)) { clear(); }

  [[nodiscard]] static bool takes(const Bdd& layer, const Bdd& below) {
    constexpr std::size_t most_nodes = 100;
    return layer.node_count() <= most_nodes && below.node_count() <= most_nodes;
  }
  void add(const Bdd& layer, const Bdd& below) {
    layers_.push_back(layer);
    steps_.push_back(layer.and_next(below));
  }
  [[nodiscard]] bool full() const { return layers_.size() == 256; }
  /// What escapes from the ranks taken, which are gone then.
  [[nodiscard]] Bdd lost(const Bdd& met, const Escapes& escapes) {
    if (layers_.empty()) return never_;
    bdd::Manager& manager = never_.manager();
    Bdd result = escapes(manager.disjunction(layers_), met | manager.disjunction(steps_));
    clear();
    return result;
  }

 private:
  void clear() {
    layers_.clear();
    steps_.clear();
  }
  Bdd never_;
  std::vector<Bdd> layers_, steps_;
};

}  // namespace

void check_ranking(const Board& board, const Bdd& winning, const Ranking& ranking, const std::string& name,
                   const Escapes& escapes, Findings& findings) {
  const Bdd never = board.encoding().constant(false);
  const Bdd met = ranking.met.step ? ranking.met.relation & winning.next() : never;
  // A goal of states is met by every step from where it holds.
  const Bdd unmet = ranking.met.step ? winning : winning.minus(ranking.met.relation);
  Bdd below = never;
  Block block(board);
  const auto look = [&](const Bdd& lost, std::size_t k) {
    findings.none(lost, fmt::format("from rank {} of {} the system does not come nearer", k, name));
  };
  for (std::size_t k = 0; k < ranking.ranks.size() && findings.sound(); ++k) {
    const auto& [states, assumption] = ranking.ranks[k];
    const Bdd upto = states & winning;
    findings.require(below.entails(upto),
                     fmt::format("rank {} of {} does not contain the one before", k, name));
    const Bdd layer = upto.minus(below) & unmet;
    const Bdd nearer = met | below.next();
    Bdd lost;
    if (layer.is_false()) {
      lost = never;
    } else if (!assumption && Block::takes(layer, below)) {
      block.add(layer, below);
      lost = block.full() ? block.lost(met, escapes) : never;
    } else if (!assumption) {
      lost = escapes(layer, nearer);
    } else if (const Justice& J_env = board.env_justice[*assumption]; J_env.step) {
      lost = escapes(layer, nearer | upto.next().minus(J_env.relation));
    } else {
      lost =
          escapes(layer & J_env.relation, nearer) | escapes(layer.minus(J_env.relation), met | upto.next());
    }
    look(lost, k);
    below = upto;
  }
  look(block.lost(met, escapes), ranking.ranks.size() - 1);
  findings.none(winning.minus(below), fmt::format("a state that is said to be won has no rank for {}", name));
}

}  // namespace heed::certify
