#include "simplify.h"

#include "schedule.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

/// - A conjunct of rho_s that speaks of the next state alone and holds at the start holds in every state of
///   every play: sets of states are kept inside it instead (state_invariants).
/// - An output bit y that the invariants determine, y = f, is no choice: f is put in for y and f' for y'
///   (functional_outputs). Every derived symbol and most of what other tools' preprocessors add is one.
/// - A next variable whose current one nothing reads is quantified where it stands (unread_variables).
namespace heed::game {
namespace {

using bdd::Bdd;

/// What an elimination may make of the diagrams that it changes: this many times their nodes, and some.
constexpr std::size_t most_growth = 2, some_nodes = 100;
/// Nodes of the invariants about one variable; more is not looked at.
constexpr std::size_t most_invariant_nodes = 5'000;

class Simplifier {
 public:
  Simplifier(const Game& game, const Techniques& techniques)
      : techniques_(techniques), game_(game), eliminated_(game.manager->constant(true)) {}

  Simplified run() {
    if (techniques_.state_invariants) take_invariants();
    Bdd invariant = game_.valid;
    for (const Bdd& part : invariants_) invariant &= part;
    if (techniques_.functional_outputs) put_in_functions();
    if (techniques_.state_invariants) {
      game_.valid = game_.valid.exists(eliminated_);
      for (const Bdd& part : invariants_) game_.valid &= part;
    }
    if (techniques_.unread_variables) drop_unread();
    return {std::move(game_), std::move(invariant)};
  }

 private:
  void take_invariants() {
    const Bdd start = game_.initial_answer();
    std::vector<Part> steps;
    for (Part& part : game_.sys_safety) {
      const Bdd here = speaks_of_next(part.relation) ? part.relation.current() : Bdd();
      if (here.valid() && start.entails(here))
        invariants_.push_back(here);
      else
        steps.push_back(std::move(part));
    }
    game_.sys_safety = std::move(steps);
  }

  /// Alone; every bit of a game is the current or next one of a pair, in this order of numbers.
  [[nodiscard]] bool speaks_of_next(const Bdd& relation) const {
    const auto support = relation.support_variables();
    return std::all_of(support.begin(), support.end(),
                       [&](bdd::Var v) { return game_.manager->partner(v) < v; });
  }

  void put_in_functions() {
    const bool moore = game_.spec->timing == spec::Timing::Moore;
    for (bool again = true; again;) {
      again = false;
      for (const bdd::Var output : game_.bits(Owner::Output, false)) {
        if (eliminated_.depends_on(output)) continue;
        const auto function = function_of(output);
        // A Moore machine answers before it sees X', so it can only follow its own outputs.
        if (!function || (moore && !game_.outputs.entails(function->support()))) continue;
        again = put_in(output, *function) || again;
      }
    }
  }

  /// f where the invariants say y = f.
  [[nodiscard]] std::optional<Bdd> function_of(bdd::Var output) const {
    Bdd about = game_.manager->constant(true);
    for (const Bdd& part : invariants_) {
      if (!part.depends_on(output)) continue;
      about &= part;
      if (about.node_count() > most_invariant_nodes) return std::nullopt;
    }
    if (about.is_true()) return std::nullopt;
    const Bdd low = about.cofactor(output, false);
    const Bdd high = about.cofactor(output, true);
    if (low.intersects(high)) return std::nullopt;
    return high.minimise(low | high);
  }

  /// False where the diagrams would grow too much; nothing is changed then.
  bool put_in(bdd::Var output, const Bdd& function) {
    const std::array<std::pair<bdd::Var, Bdd>, 2> substitution{
        {{output, function}, {game_.manager->partner(output), function.next()}}};
    std::vector<Bdd*> all = relations();
    std::vector<Bdd> changed;
    std::size_t before = 0;
    std::size_t after = 0;
    for (const Bdd* relation : all) {
      changed.push_back(relation->compose(substitution));
      if (changed.back() == *relation) continue;
      before += relation->node_count();
      after += changed.back().node_count();
      if (after > before * most_growth + some_nodes) return false;
    }
    for (std::size_t i = 0; i < all.size(); ++i) *all[i] = std::move(changed[i]);
    std::erase_if(invariants_, [](const Bdd& part) { return part.is_true(); });
    std::erase_if(game_.sys_safety, [](const Part& part) { return part.relation.is_true(); });
    eliminated_ &= game_.manager->variable(output);
    return true;
  }

  [[nodiscard]] std::vector<Bdd*> relations() {
    std::vector<Bdd*> all;
    for (Bdd& part : invariants_) all.push_back(&part);
    for (Bdd& part : game_.env_steps) all.push_back(&part);
    for (Part& part : game_.sys_safety) all.push_back(&part.relation);
    for (Bdd& update : game_.updates) all.push_back(&update);
    for (auto* justices : {&game_.env_justice, &game_.sys_justice})
      for (Justice& justice : *justices) all.push_back(&justice.relation);
    for (Bdd& part : game_.env_safety) all.push_back(&part);
    return all;
  }

  /// Until nothing changes, since a conjunct that loses a variable may read less.
  void drop_unread() {
    for (std::size_t before = 0; before != occurrences();) {
      before = occurrences();
      Flags reads = flags();
      for (const Bdd* relation : relations()) note(*relation, reads);
      note(game_.valid, reads);
      Flags elsewhere = flags();
      for (const auto* justices : {&game_.env_justice, &game_.sys_justice})
        for (const Justice& justice : *justices) note(justice.relation, elsewhere);
      for (const Bdd& update : game_.updates) note(update, elsewhere);
      if (game_.spec->timing == spec::Timing::Mealy)
        replace_answers(without_unread(answers(), unread(Owner::Output, reads, elsewhere)));
      for (const Bdd& answer : answers()) note(answer, elsewhere);
      game_.env_steps = without_unread(std::move(game_.env_steps), unread(Owner::Input, reads, elsewhere));
    }
  }

  using Flags = std::vector<bool>;
  [[nodiscard]] Flags flags() const { return Flags(game_.manager->variable_count()); }

  static void note(const Bdd& function, Flags& flags) {
    for (const bdd::Var variable : function.support_variables()) flags[variable] = true;
  }

  /// Next variables of \p owner that no set of states and nothing \p elsewhere mentions.
  [[nodiscard]] Bdd unread(Owner owner, const Flags& reads, const Flags& elsewhere) const {
    std::vector<bdd::Var> result;
    for (const bdd::Var next : game_.bits(owner, true))
      if (!reads[game_.manager->partner(next)] && !elsewhere[next]) result.push_back(next);
    return game_.manager->cube(result);
  }

  [[nodiscard]] std::vector<Bdd> answers() const {
    std::vector<Bdd> result;
    for (const Part& part : game_.sys_safety) result.push_back(part.relation);
    return result;
  }

  void replace_answers(std::vector<Bdd> answers) {
    game_.sys_safety.clear();
    for (Bdd& answer : answers) game_.sys_safety.push_back({std::move(answer), Part::no_clause});
  }

  [[nodiscard]] std::size_t occurrences() const {
    std::size_t sum = 1;
    for (const Bdd& answer : answers()) sum += answer.support_variables().size();
    for (const Bdd& step : game_.env_steps) sum += step.support_variables().size();
    return sum;
  }

  Techniques techniques_;
  Game game_;
  std::vector<Bdd> invariants_;
  Bdd eliminated_;  ///< Cube of the outputs that were put in.
};

}  // namespace

Simplified simplify(const Game& game, const Techniques& techniques) {
  return Simplifier(game, techniques).run();
}

}  // namespace heed::game
