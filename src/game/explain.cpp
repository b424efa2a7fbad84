#include <heed/game/explain.h>

#include "core.h"
#include "names.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::game {
namespace {

using bdd::Bdd;
using bdd::Var;

/// Plays one losing play: the environment moves so that the system leaves the regions in the order in which
/// the outermost fixpoint lost them, the system answers so that it leaves them as late as possible. Each step
/// goes to an earlier region, so the play ends, in a step without an answer or where a goal is out of reach.
class Play {
 public:
  Play(const Game& game, const Region& region, const ExplainOptions& options)
      : game_(game),
        region_(region),
        options_(options),
        assignment_(game.manager->variable_count()),
        announced_(game.manager->constant(true)) {}

  Defeat run() {
    if (start())
      for (std::size_t i = 0; i < options_.most_moves; ++i)
        if (!step()) break;
    return std::move(defeat_);
  }

 private:
  void say(std::string sentence) { defeat_.moves.push_back(std::move(sentence)); }

  /// Puts the values of the current variables of \p owner in one assignment of \p set into the play.
  void choose(Owner owner, const Bdd& set) {
    const std::vector<Var> bits = game_.bits(owner, false);
    const std::vector<bool> values = set.pick(bits);
    for (std::size_t i = 0; i < bits.size(); ++i) assignment_[bits[i]] = values[i];
  }

  [[nodiscard]] Bdd cube(std::initializer_list<Owner> owners) const {
    std::vector<bdd::Literal> literals;
    for (const Owner owner : owners)
      for (const Var bit : game_.bits(owner, false)) literals.push_back({bit, assignment_[bit]});
    return game_.manager->cube(literals);
  }

  [[nodiscard]] Bdd state() const { return cube({Owner::Input, Owner::Output, Owner::Memory}); }
  [[nodiscard]] std::string text(Owner owner) const { return values_text(game_, owner, assignment_); }
  [[nodiscard]] Values values(Owner owner) const { return values_of(game_, owner, assignment_); }

  [[nodiscard]] std::string answer_text() const {
    std::string answer = text(Owner::Output);
    if (!game_.updates.empty()) answer += fmt::format(" (with {})", text(Owner::Memory));
    return answer;
  }

  /// First observations whose best answer is lost in the earliest round: the shortest story.
  [[nodiscard]] Bdd earliest_lost(const Bdd& legal, const Bdd& possible) const {
    const Bdd chosen = game_.outputs & game_.memories;
    Bdd losing = legal.minus(possible.exists(chosen));
    for (auto iterate = region_.iterates.begin(); losing.is_false() && iterate != region_.iterates.end();
         ++iterate)
      losing = legal.minus(possible.and_exists(iterate->region, chosen));
    return losing;
  }

  /// A first observation that is lost, whoever chooses first.
  [[nodiscard]] Bdd losing_inputs(const Bdd& legal, const Bdd& possible) {
    const Bdd chosen = game_.outputs & game_.memories;
    if (game_.spec->initial == spec::InitialQuantifiers::ForallExists) return earliest_lost(legal, possible);
    Bdd unanswered = legal.minus(possible.and_exists(region_.winning, chosen));
    if (game_.spec->initial == spec::InitialQuantifiers::ForallForall)
      return unanswered | (legal & possible.minus(region_.winning).exists(chosen));
    if (game_.spec->initial != spec::InitialQuantifiers::ExistsForall || !unanswered.is_false())
      return unanswered;
    const std::vector<Var> bits = (game_.outputs & game_.memories).support_variables();
    announced_ = possible.exists(game_.inputs).pick_cube(bits);
    return legal.minus((possible & region_.winning & announced_).exists(chosen));
  }

  bool start() {
    const Bdd legal = game_.initial_inputs();
    if (legal.is_false()) {
      defeat_.losing_initial = "none: no first observation is legal";
      return false;
    }
    const Bdd possible = game_.initial_answer();
    const Bdd losing = losing_inputs(legal, possible);
    choose(Owner::Input, losing);
    choose(Owner::Memory, game_.memory_initial & game_.valid);
    defeat_.losing_initial = text(Owner::Input);
    const bool chooses_first = game_.spec->initial == spec::InitialQuantifiers::ExistsForall;
    say(fmt::format("{} the environment gives {}.",
                    chooses_first ? "After the system's first answer" : "At the first step",
                    text(Owner::Input)));
    std::vector<Part> parts{{game_.env_initial & game_.memory_initial, Part::no_clause}};
    parts.insert(parts.end(), game_.sys_initial.begin(), game_.sys_initial.end());
    const std::size_t safety = parts.size();
    parts.insert(parts.end(), game_.initial_safety.begin(), game_.initial_safety.end());
    const Bdd here = cube({Owner::Input});
    Bdd answers = possible & here & announced_;
    if (game_.spec->initial == spec::InitialQuantifiers::ForallForall && answers.intersects(!region_.winning))
      answers = answers.minus(region_.winning);
    return respond(answers, parts, here, safety);
  }

  /// The system's answer that survives longest; false when there is none.
  bool respond(const Bdd& answers, const std::vector<Part>& parts, const Bdd& here,
               std::size_t first_safety) {
    if (answers.is_false()) {
      say_conflict(parts, here, first_safety);
      return false;
    }
    Bdd best = answers;
    for (auto iterate = region_.iterates.rbegin(); iterate != region_.iterates.rend(); ++iterate) {
      if (!answers.intersects(iterate->region)) continue;
      best = answers & iterate->region;
      break;
    }
    const std::vector<Var> bits = (game_.outputs & game_.memories).support_variables();
    const Bdd picked = best & best.pick_cube(bits);
    choose(Owner::Memory, picked);
    choose(Owner::Output, picked & cube({Owner::Memory}));
    defeat_.turns.push_back({values(Owner::Input), values(Owner::Memory), values(Owner::Output)});
    say(fmt::format("The system holds out longest by answering {}.", answer_text()));
    return true;
  }

  void say_conflict(const std::vector<Part>& parts, const Bdd& here, std::size_t first_safety) {
    defeat_.turns.push_back({values(Owner::Input), values(Owner::Memory), {}});
    std::vector<Bdd> left;
    left.reserve(parts.size());
    for (const Part& part : parts) left.push_back(part.relation.cofactor(here));
    std::string clauses;
    for (const std::size_t i : minimal_conflict(left)) {
      if (parts[i].clause == Part::no_clause) continue;
      const auto& list = i < first_safety ? game_.spec->sys_init : game_.spec->sys_safety;
      defeat_.broken.push_back(list[parts[i].clause]);
      clauses += fmt::format("{}'{}'", clauses.empty() ? "" : " and ", clause_text(list[parts[i].clause]));
    }
    say(clauses.empty() ? "The system has no answer at all." : fmt::format("No answer keeps {}.", clauses));
  }

  /// The regions that the play is in and has not lost yet; the play is lost in the first that it is not in.
  [[nodiscard]] std::size_t lost_round() const {
    std::size_t n = 0;
    while (n < region_.iterates.size() && region_.iterates[n].region.evaluate(assignment_)) ++n;
    return n;
  }

  bool step() {
    const std::size_t n = lost_round();
    if (n == region_.iterates.size()) return false;
    const Bdd& region = n == 0 ? game_.valid : region_.iterates[n - 1].region;
    const Bdd here = state();
    Bdd legal = game_.manager->constant(true), moves = legal;
    for (const Bdd& part : game_.env_safety) legal &= put_in(part, here).cofactor(here);
    for (const Part& part : game_.sys_safety) moves &= put_in(part.relation, here).cofactor(here);
    const Bdd stay = moves & put_in(region.next(), here).cofactor(here);
    const Bdd losing = losing_moves(legal, stay, moves);
    if (losing.is_false()) {
      say_goal(region_.iterates[n].goal);
      return false;
    }
    return move(here, losing, moves);
  }

  /// Next inputs after which no answer stays. Moore: after an answer that is given before.
  [[nodiscard]] Bdd losing_moves(const Bdd& legal, const Bdd& stay, const Bdd& moves) {
    announced_ = game_.manager->constant(true);
    if (game_.spec->timing == spec::Timing::Mealy) return legal.minus(stay.exists(game_.next_outputs));
    if (!legal.implies(stay).forall(game_.next_inputs).is_false()) return game_.manager->constant(false);
    const std::vector<Var> bits = game_.bits(Owner::Output, true);
    const Bdd safe = legal.implies(moves).forall(game_.next_inputs);
    announced_ = safe.is_false() ? game_.manager->constant(true).pick_cube(bits) : safe.pick_cube(bits);
    return legal.minus((stay & announced_).exists(game_.next_outputs));
  }

  bool move(const Bdd& here, const Bdd& losing, const Bdd& moves) {
    // The next values become the current ones; the memories follow from the state left behind.
    std::vector<bdd::Literal> memories;
    const std::vector<Var> inputs = game_.bits(Owner::Input, true);
    const Bdd input = losing.pick_cube(inputs);
    const Bdd both = here & input;
    const std::vector<Var> next = game_.bits(Owner::Memory, true);
    for (std::size_t i = 0; i < next.size(); ++i)
      memories.push_back({next[i], game_.updates[i].cofactor(both).is_true()});
    const Bdd after = input & game_.manager->cube(memories);
    choose(Owner::Input, input.current());
    choose(Owner::Memory, after.current());
    say(fmt::format("Then the environment gives {}.", text(Owner::Input)));
    return respond((moves & announced_ & after).current(), game_.sys_safety, both & after, 0);
  }

  [[nodiscard]] Bdd put_in(const Bdd& relation, const Bdd& here) const {
    const std::vector<Var> next = game_.bits(Owner::Memory, true);
    std::vector<std::pair<Var, Bdd>> substitution;
    for (std::size_t i = 0; i < next.size(); ++i)
      substitution.emplace_back(next[i], game_.updates[i].cofactor(here));
    return substitution.empty() ? relation : relation.cofactor(here).compose(substitution);
  }

  void say_goal(std::size_t goal) {
    const std::size_t clause = game_.sys_justice[goal].clause;
    if (clause == Part::no_clause) return;
    defeat_.goal = game_.spec->sys_justice[clause];
    say(fmt::format(
        "From here the environment can keep all its assumptions for ever and the system can still not meet "
        "'{}' again and again.",
        goal_text(game_.spec->sys_justice[clause])));
  }

  const Game& game_;
  const Region& region_;
  ExplainOptions options_;
  std::vector<bool> assignment_;  ///< The state the play is in, by diagram variable; next ones unused.
  Bdd announced_;                 ///< What the system has to answer before it sees the inputs; true: nothing.
  Defeat defeat_;
};

}  // namespace

std::vector<std::size_t> minimal_conflict(const std::vector<Bdd>& parts) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < parts.size(); ++i) kept.push_back(i);
  for (std::size_t i = parts.size(); i-- > 0;) {
    std::vector<Bdd> rest;
    for (const std::size_t k : kept)
      if (k != i) rest.push_back(parts[k]);
    if (!rest.empty() && parts[i].manager().conjunction(rest).is_false())
      kept.erase(std::find(kept.begin(), kept.end(), i));
  }
  return kept;
}

Defeat explain(const Game& game, const Region& region, util::Budget& budget, const ExplainOptions& options) {
  Defeat defeat = Play(game, region, options).run();
  const std::uint64_t steps = std::max(options.core_steps, options.core_factor * region.steps);
  defeat.reasons = unrealizable_core(game, budget, steps);
  return defeat;
}

}  // namespace heed::game
