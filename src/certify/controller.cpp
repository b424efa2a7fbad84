#include <heed/certify/certify.h>

#include "ranking.h"
#include "vocabulary.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::certify {
namespace {

using bdd::Bdd;
using Functions = std::vector<Bdd>;

/// The controller's functions over the board's variables.
struct Tables {
  Bdd answered, winning;
  Functions legal, start_memories, start_outputs, updates, derived;
  struct Goal {
    Functions answers;
    Bdd met;
    Functions ranks;
  };
  std::vector<Goal> goals;
};

Tables import(const model::SymbolicController& controller, const Board& board) {
  std::vector<model::Function> wanted{controller.start.answered, controller.winning};
  const auto append = [&](const std::vector<model::Function>& list) {
    wanted.insert(wanted.end(), list.begin(), list.end());
  };
  append(controller.legal);
  append(controller.start.memories);
  append(controller.start.outputs);
  append(controller.updates);
  append(controller.derived);
  for (const auto& goal : controller.goals) {
    append(goal.answers);
    wanted.push_back(goal.met);
    for (const model::Level& level : goal.ranks) wanted.push_back(level.states);
  }
  const Functions all = board.encoding().import(controller.diagrams, wanted);
  auto next = all.begin();
  const auto take = [&](std::size_t count) {
    const auto begin = next;
    next += static_cast<std::ptrdiff_t>(count);
    return Functions(begin, next);
  };
  Tables tables;
  tables.answered = *next++;
  tables.winning = *next++;
  tables.legal = take(controller.legal.size());
  tables.start_memories = take(controller.start.memories.size());
  tables.start_outputs = take(controller.start.outputs.size());
  tables.updates = take(controller.updates.size());
  tables.derived = take(controller.derived.size());
  for (const auto& goal : controller.goals) {
    Tables::Goal one{take(goal.answers.size()), *next, {}};
    ++next;
    one.ranks = take(goal.ranks.size());
    tables.goals.push_back(std::move(one));
  }
  return tables;
}

/// \p function with each variable replaced by its function, the last first, since each may use those before.
Bdd put_in(Bdd function, const std::vector<bdd::Var>& variables, const Functions& values) {
  for (std::size_t i = variables.size(); i-- > 0;)
    if (function.depends_on(variables[i])) function = function.compose(variables[i], values[i]);
  return function;
}

/// Whether each function uses only the variables before its own. Else the values are no functions of what is
/// known: a bit that must differ from itself has none, and what has no step makes no bad one.
bool in_order(const Functions& functions, const std::vector<bdd::Var>& variables) {
  for (std::size_t i = 0; i < functions.size(); ++i)
    for (std::size_t later = i; later < variables.size(); ++later)
      if (functions[i].depends_on(variables[later])) return false;
  return true;
}

/// A controller against its specification: every check is that no step which it makes from a state of
/// `winning` on a legal observation is bad.
class ControllerCheck {
 public:
  ControllerCheck(const model::SymbolicController& controller, const Board& board)
      : controller_(controller),
        board_(board),
        findings_(board),
        tables_(import(controller, board)),
        outputs_(board.encoding().bits(Owner::Output, true)) {}

  Verdict run() {
    if (!shape()) return findings_.verdict();
    winning_ = tables_.winning & board_.states;
    start();
    columns();
    for (std::size_t goal = 0; goal < tables_.goals.size() && findings_.sound(); ++goal) check_goal(goal);
    return findings_.verdict();
  }

 private:
  bool shape() {
    Functions sets{tables_.winning};
    bool known = true;
    for (std::size_t g = 0; g < tables_.goals.size(); ++g) {
      sets.insert(sets.end(), tables_.goals[g].ranks.begin(), tables_.goals[g].ranks.end());
      for (const model::Level& level : controller_.goals[g].ranks)
        known = known && (!level.assumption || *level.assumption < board_.env_justice.size());
    }
    return findings_.require(tables_.goals.size() == board_.sys_justice.size(),
                             "its goals are not as many as those of the specification") &&
           findings_.require(of_states(board_, sets), "a set of states depends on the next state") &&
           findings_.require(known, "a rank waits for an assumption that the specification does not have") &&
           findings_.require(tables_.updates.size() == board_.updates.size() &&
                                 tables_.start_memories.size() == board_.updates.size() &&
                                 tables_.start_outputs.size() == outputs_.size() &&
                                 tables_.derived.size() == board_.encoding().definitions().size(),
                             "its functions are not as many as its bits");
  }

  void start() {
    std::vector<bdd::Var> chosen = board_.encoding().bits(Owner::Memory, false);
    Functions values = tables_.start_memories;
    for (const bdd::Var variable : board_.encoding().bits(Owner::Output, false)) chosen.push_back(variable);
    values.insert(values.end(), tables_.start_outputs.begin(), tables_.start_outputs.end());
    if (!findings_.require(in_order(values, chosen), "a first value depends on itself or on later ones"))
      return;
    const Bdd& legal = board_.first_inputs;
    findings_.require(board_.encoding().cube(Owner::Input, false).entails(tables_.answered.support()),
                      "which first observations are answered depends on more than these");
    if (board_.spec().initial == spec::InitialQuantifiers::ExistsExists)
      findings_.require(legal.intersects(tables_.answered), "no legal first observation is answered");
    else
      findings_.none(legal.minus(tables_.answered), "a legal first observation is not answered");
    const Bdd open = legal & tables_.answered;
    findings_.none(open.minus(put_in(board_.first_answers, chosen, values)),
                   "the first answer breaks what holds at the start");
    findings_.none(open.minus(put_in(winning_, chosen, values)),
                   "the first answer leaves the states that are won");
    if (board_.spec().initial == spec::InitialQuantifiers::ForallForall)
      findings_.none((legal & board_.first_answers).minus(winning_), "a possible start is not won");
    if (board_.spec().initial == spec::InitialQuantifiers::ExistsForall)
      findings_.require(!depends(values, {Owner::Input}, false),
                        "the first answer depends on the first observation");
  }

  [[nodiscard]] bool depends(const Functions& functions, const std::vector<Owner>& owners, bool next) const {
    for (const Owner owner : owners)
      for (const bdd::Var variable : board_.encoding().bits(owner, next))
        if (std::any_of(functions.begin(), functions.end(),
                        [&](const Bdd& function) { return function.depends_on(variable); }))
          return true;
    return false;
  }

  /// The states of \p from of which some legal step, with the goal's answers, lies in \p steps. The answers
  /// come first, since each of them takes a variable away, and so does what is legal then: before that, what
  /// is legal would have to hold together sets before and after a step that have little to do with each
  /// other.
  [[nodiscard]] Bdd taken(const Bdd& from, const Bdd& steps, const Tables::Goal& goal) const {
    Bdd left = steps;
    std::vector<bdd::Var> support = left.support_variables();
    for (std::size_t i = outputs_.size(); i-- > 0;) {
      if (!std::binary_search(support.begin(), support.end(), outputs_[i])) continue;
      const Bdd bit = board_.encoding().manager().variable(outputs_[i]);
      left = left.and_exists(bit.iff(goal.answers[i]), bit);
      support = left.support_variables();
    }
    return from & board_.forced(left);
  }

  /// Steps that the controller refuses and that no assumption excludes by itself which speaks of the same.
  /// Where \p legal is a conjunction of assumptions there are none, and the others need not be met.
  [[nodiscard]] Bdd unanswered(const Bdd& legal) const {
    const std::vector<bdd::Var> about = legal.support_variables();
    Bdd left = !legal;
    for (const Bdd& assumption : board_.env_steps) {
      const std::vector<bdd::Var> reads = assumption.support_variables();
      if (std::includes(about.begin(), about.end(), reads.begin(), reads.end())) left &= assumption;
    }
    return left;
  }

  void columns() {
    if (!findings_.require(!depends(tables_.updates, {Owner::Output, Owner::Memory}, true),
                           "a memory's next value depends on what is chosen after it, or on itself"))
      return;
    for (const Bdd& part : tables_.legal) {
      const Bdd left = unanswered(part);
      if (!left.is_false())
        findings_.none(winning_ & board_.legal(left), "a legal observation is not answered");
    }
    for (std::size_t i = 0; i < tables_.updates.size(); ++i)
      findings_.none(winning_ & board_.legal(tables_.updates[i] ^ board_.updates[i]),
                     "a memory is not what the specification says");
    for (std::size_t i = 0; i < tables_.derived.size(); ++i)
      findings_.none(winning_ & (tables_.derived[i] ^ board_.encoding().definitions()[i]),
                     fmt::format("'{}' is not what its definition says", board_.spec().definitions[i].name));
  }

  void check_goal(std::size_t number) {
    const Tables::Goal& goal = tables_.goals[number];
    const std::string name = fmt::format("goal '{}'", board_.sys_justice[number].text);
    if (!findings_.require(in_order(goal.answers, outputs_), "an answer depends on itself or on later ones"))
      return;
    if (board_.moore())
      findings_.require(!depends(goal.answers, {Owner::Input, Owner::Memory}, true),
                        "an answer depends on the observation of the same step");
    const auto never = [&](const Bdd& steps, const std::string& what) {
      findings_.none(taken(winning_, steps, goal), what);
    };
    for (std::size_t i = 0; i < board_.sys_steps.size() && findings_.sound(); ++i)
      never(!board_.sys_steps[i],
            fmt::format("on the way to {} a guarantee is broken: {}", name, board_.sys_texts[i]));
    never(!winning_.next(), fmt::format("on the way to {} a state is reached that is not won", name));
    never(goal.met.minus(board_.sys_justice[number].relation),
          fmt::format("{} is taken to be met where it is not", name));
    if (!findings_.sound()) return;
    Ranking ranking{{goal.met, !of_states(board_, {goal.met}), {}}, {}};
    for (std::size_t k = 0; k < goal.ranks.size(); ++k)
      ranking.ranks.push_back({goal.ranks[k], controller_.goals[number].ranks[k].assumption});
    check_ranking(
        board_, winning_, ranking, name,
        [&](const Bdd& from, const Bdd& target) { return taken(from, !target, goal); }, findings_);
  }

  const model::SymbolicController& controller_;
  const Board& board_;
  Findings findings_;
  Tables tables_;
  std::vector<bdd::Var> outputs_;
  Bdd winning_;
};

}  // namespace

Verdict certify(const model::SymbolicController& controller, const spec::Gr1& spec, util::Budget& budget) {
  spec::validate(spec);
  check_vocabulary(controller, spec);
  const Board board(spec, controller.diagrams.order, budget);
  return ControllerCheck(controller, board).run();
}

}  // namespace heed::certify
