#include <heed/certify/certify.h>
#include <heed/util/diagnostic.h>

#include "ranking.h"
#include "vocabulary.h"

#include <fmt/format.h>

namespace heed::certify {
namespace {

using bdd::Bdd;

/// A winning claim: the ranks of every goal.
class Victory {
 public:
  Victory(const model::Claim& claim, const Board& board) : board_(board), findings_(board) {
    std::vector<model::Function> wanted{claim.winning};
    for (const auto& ranks : claim.ranks)
      for (const model::Level& level : ranks) wanted.push_back(level.states);
    functions_ = board.encoding().import(claim.diagrams, wanted);
  }

  Verdict run(const model::Claim& claim) {
    const bool shaped = shape(claim) && findings_.require(of_states(board_, functions_),
                                                          "a set of states depends on the next state");
    if (!shaped) return findings_.verdict();
    const Bdd winning = functions_.front() & board_.states;
    findings_.require(board_.wins_start(winning),
                      "the start is not won when the states are that are claimed");
    const Escapes escapes = [this](const Bdd& from, const Bdd& target) {
      return board_.escapes(from, target);
    };
    findings_.none(escapes(winning, winning.next()), "the environment forces the system out of what it wins");
    std::size_t next = 1;
    for (std::size_t goal = 0; goal < claim.ranks.size() && findings_.sound(); ++goal) {
      Ranking ranking{board_.sys_justice[goal], {}};
      for (const model::Level& level : claim.ranks[goal])
        ranking.ranks.push_back({functions_[next++], level.assumption});
      check_ranking(board_, winning, ranking, fmt::format("goal '{}'", ranking.met.text), escapes, findings_);
    }
    return findings_.verdict();
  }

 private:
  bool shape(const model::Claim& claim) {
    bool known = true;
    for (const auto& ranks : claim.ranks)
      for (const model::Level& level : ranks)
        known = known && (!level.assumption || *level.assumption < board_.env_justice.size());
    return findings_.require(claim.ranks.size() == board_.sys_justice.size(),
                             "there is not one ranking per goal") &&
           findings_.require(known, "a rank waits for an assumption that the specification does not have");
  }

  const Board& board_;
  Findings findings_;
  std::vector<Bdd> functions_;
};

/// A losing claim, round by round. With L the lost states after a round, L0 those before, j its goal and
/// D[i][m] the chain of assumption i, the environment can see to it from D[i][m] - D[i][m-1] - L0 that
/// whatever the system answers is
///
///     lost before:  L0'      or      !J_sys[j] & L' & (J_env[i] | D[i][m-1]')
///
/// A play that stays in L - L0 then meets every assumption again and again and never the goal.
class DefeatCheck {
 public:
  DefeatCheck(const model::Claim& claim, const Board& board) : board_(board), findings_(board) {
    std::vector<model::Function> wanted;
    for (const model::LosingRound& round : claim.rounds) {
      wanted.push_back(round.lost);
      for (const auto& chain : round.chains) wanted.insert(wanted.end(), chain.begin(), chain.end());
    }
    functions_ = board.encoding().import(claim.diagrams, wanted);
  }

  Verdict run(const model::Claim& claim) {
    const bool shaped = shape(claim) && findings_.require(of_states(board_, functions_),
                                                          "a set of states depends on the next state");
    if (!shaped) return findings_.verdict();
    before_ = board_.encoding().constant(false);
    for (std::size_t r = 0; r < claim.rounds.size() && findings_.sound(); ++r) {
      const Bdd lost = functions_[next_++] & board_.states;
      name_ = fmt::format("round {} of the defeat", r);
      findings_.require(before_.entails(lost), name_ + " does not contain the one before");
      check_round(claim.rounds[r], lost);
      before_ = lost;
    }
    findings_.require(!board_.wins_start(board_.states.minus(before_)),
                      "the start does not lie in what is claimed to be lost");
    return findings_.verdict();
  }

 private:
  bool shape(const model::Claim& claim) {
    bool shaped = true;
    for (const model::LosingRound& round : claim.rounds) {
      shaped = shaped && (!round.goal || *round.goal < board_.sys_justice.size());
      shaped = shaped && round.chains.size() == (round.goal ? board_.env_justice.size() : 0);
    }
    return findings_.require(shaped, "a round of the defeat does not fit the specification");
  }

  void check_round(const model::LosingRound& round, const Bdd& lost) {
    const Bdd fresh = lost.minus(before_);
    if (!round.goal) {
      forced(fresh, before_.next());
      return;
    }
    const Justice& J_sys = board_.sys_justice[*round.goal];
    Bdd open = fresh;
    if (!J_sys.step) {
      forced(fresh & J_sys.relation, before_.next());
      open = fresh.minus(J_sys.relation);
    }
    const Bdd unmet = J_sys.step ? lost.next().minus(J_sys.relation) : lost.next();
    for (std::size_t i = 0; i < round.chains.size() && findings_.sound(); ++i)
      check_chain(board_.env_justice[i], round.chains[i].size(), {lost, open, unmet, J_sys.step});
  }

  struct Round {
    Bdd lost, open, unmet;
    bool step;
  };

  void check_chain(const Justice& J_env, std::size_t length, const Round& round) {
    Bdd nearer = before_;
    for (std::size_t m = 0; m < length && findings_.sound(); ++m) {
      const Bdd set = (functions_[next_++] | before_) & round.lost;
      findings_.require(nearer.entails(set), "a chain of " + name_ + " does not grow");
      const Bdd layer = set.minus(nearer) & round.open;
      if (J_env.step || round.step) {
        forced(layer, before_.next() | (round.unmet & (J_env.relation | nearer.next())));
      } else {
        forced(layer & J_env.relation, round.unmet);
        forced(layer.minus(J_env.relation), nearer.next());
      }
      nearer = set;
    }
    findings_.none(round.open.minus(nearer), "a state of " + name_ + " is in no set of a chain");
  }

  /// From each state of \p from the environment can make every answer a step of \p wanted.
  void forced(const Bdd& from, const Bdd& wanted) {
    if (from.is_false()) return;
    findings_.none(from.minus(board_.escapes(from, !wanted)),
                   "in " + name_ + " the environment cannot force what is claimed");
  }

  const Board& board_;
  Findings findings_;
  std::vector<Bdd> functions_;
  std::size_t next_ = 0;
  Bdd before_;
  std::string name_;
};

}  // namespace

Verdict certify(const model::Claim& claim, const spec::Gr1& spec, util::Budget& budget) {
  spec::validate(spec);
  check_vocabulary(claim, spec);
  const Board board(spec, claim.diagrams.order, budget);
  if (claim.realizable) return Victory(claim, board).run(claim);
  return DefeatCheck(claim, board).run(claim);
}

}  // namespace heed::certify
