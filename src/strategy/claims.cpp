#include "claims.h"

namespace heed::strategy {
namespace {

using bdd::Bdd;

/// The rounds of a defeat. The solver's rounds say what is lost in each; the chains are the steps of
///
///     nu X . Z & cpre((J_sys[j] & Z') | Y' | (!J_env[i] & X'))
///
/// with Z what was left before the round and Y what is left after it: a state that leaves X in step m leaves
/// it because the environment has a move after which no answer is in any of the three.
class Rounds {
 public:
  Rounds(const game::Game& game, const game::Region& region, util::Budget& budget, DiagramWriter& writer)
      : game_(game), region_(region), budget_(budget), writer_(writer), cpre_(game) {}

  std::vector<model::LosingRound> make() {
    std::vector<model::LosingRound> rounds;
    Bdd Z = region_.invariant;
    for (const game::Iterate& iterate : region_.iterates) {
      model::LosingRound round;
      round.lost = writer_.add(region_.invariant.minus(iterate.region));
      if (iterate.goal != game::Part::no_clause) {
        round.goal = static_cast<std::uint32_t>(iterate.goal);
        const game::Justice& J_sys = game_.sys_justice[iterate.goal];
        for (const game::Justice& J_env : game_.env_justice)
          round.chains.push_back(chain({J_sys, J_env}, Z, iterate.region));
      }
      rounds.push_back(std::move(round));
      Z = iterate.region;
    }
    return rounds;
  }

 private:
  struct Justices {
    const game::Justice& sys;
    const game::Justice& env;
  };

  std::vector<model::Function> chain(const Justices& justices, const Bdd& Z, const Bdd& Y) {
    std::vector<model::Function> sets;
    const bool fused = justices.sys.step || justices.env.step;
    const Bdd met =
        fused ? (justices.sys.relation & Z.next()) | Y.next()
              : (justices.sys.relation & cpre_.of_set(Z)) | (justices.env.relation & cpre_.of_set(Y));
    const Bdd lost = region_.invariant.minus(Y);
    Bdd X = Z;
    while (X.intersects(lost)) {
      budget_.check();
      const Bdd next = Z & (fused ? cpre_.of_relation(met | X.next().minus(justices.env.relation))
                                  : met | cpre_.of_set(X | Y).minus(justices.env.relation));
      if (next == X) break;
      X = next;
      sets.push_back(writer_.add(lost.minus(X)));
    }
    return sets;
  }

  const game::Game& game_;
  const game::Region& region_;
  util::Budget& budget_;
  DiagramWriter& writer_;
  game::Predecessor cpre_;
};

void resolve(model::Claim& claim, DiagramWriter& writer) {
  claim.diagrams = writer.finish();
  if (claim.realizable) writer.resolve(claim.winning);
  for (auto& ranks : claim.ranks) writer.resolve(ranks);
  for (model::LosingRound& round : claim.rounds) {
    writer.resolve(round.lost);
    for (auto& chain : round.chains) writer.resolve(chain);
  }
}

}  // namespace

std::vector<model::Level> levels_of(const game::Region& region, std::size_t goal, DiagramWriter& writer) {
  std::vector<model::Level> levels;
  Bdd below;
  const auto add = [&](const Bdd& upto, std::optional<std::uint32_t> assumption) {
    if (upto.is_false() || upto == below) return;
    levels.push_back({writer.add(upto), assumption});
    below = upto;
  };
  for (std::size_t k = 0; k < region.ranks[goal].size(); ++k) {
    const std::vector<Bdd>& waits = region.waits[goal][k];
    for (std::uint32_t i = 0; i < waits.size(); ++i) add(below.valid() ? below | waits[i] : waits[i], i);
    add(region.ranks[goal][k], std::nullopt);
  }
  return levels;
}

model::Claim make_claim(const game::Game& game, const game::Region& region, util::Budget& budget) {
  model::Claim claim;
  claim.inputs = game.spec->inputs;
  for (const auto& output : game.spec->outputs) claim.outputs.push_back(output.variable);
  for (const auto& memory : game.spec->memories) claim.memories.push_back(memory.variable);
  claim.realizable = region.realizable;
  DiagramWriter writer(game);
  if (region.realizable) {
    claim.winning = writer.add(region.winning);
    for (std::size_t goal = 0; goal < region.ranks.size(); ++goal)
      claim.ranks.push_back(levels_of(region, goal, writer));
  } else {
    claim.rounds = Rounds(game, region, budget, writer).make();
  }
  resolve(claim, writer);
  return claim;
}

}  // namespace heed::strategy
