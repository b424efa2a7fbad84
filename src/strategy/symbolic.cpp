#include "symbolic.h"

#include "claims.h"
#include "diagrams.h"
#include "rules.h"

#include <heed/logic/parse.h>

namespace heed::strategy {
namespace {

using bdd::Bdd;
using bdd::Var;
using game::Owner;

/// Makes functions of a relation, bit by bit: each over what is known and the bits before it. Where both
/// values are right, whichever makes the function smaller is taken.
class Determiner {
 public:
  Determiner(const game::Game& game, util::Budget& budget) : game_(game), budget_(budget) {}

  [[nodiscard]] std::vector<Bdd> functions(const Bdd& relation, const std::vector<Var>& bits) const {
    std::vector<Bdd> result(bits.size());
    Bdd left = relation;
    for (std::size_t i = bits.size(); i-- > 0;) {
      budget_.check();
      const Bdd one = left.cofactor(bits[i], true), zero = left.cofactor(bits[i], false);
      const Bdd forced = one ^ zero;
      result[i] = forced.is_false() ? game_.manager->constant(false) : one.minus(zero).minimise(forced);
      left = one | zero;
    }
    return result;
  }

 private:
  const game::Game& game_;
  util::Budget& budget_;
};

std::vector<Var> joined(std::vector<Var> first, const std::vector<Var>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

model::SymbolicController::Start make_start(const game::Game& game, const game::Region& region,
                                            const Determiner& determiner, DiagramWriter& writer) {
  Bdd answered = game.initial_inputs();
  Bdd answers = game.initial_answer() & region.winning;
  const std::vector<Var> memories = game.bits(Owner::Memory, false);
  const std::vector<Var> chosen = joined(memories, game.bits(Owner::Output, false));
  if (game.spec->initial == spec::InitialQuantifiers::ExistsForall)
    answers = answered.implies(answers).forall(game.inputs).pick_cube(chosen);
  else if (game.spec->initial == spec::InitialQuantifiers::ExistsExists)
    answered &= answers.exists(game.outputs & game.memories);
  const std::vector<model::Function> all = writer.add(determiner.functions(answers, chosen));
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(memories.size());
  return {writer.add(answered), {all.begin(), middle}, {middle, all.end()}};
}

void resolve(model::SymbolicController& controller, DiagramWriter& writer) {
  controller.diagrams = writer.finish();
  writer.resolve(controller.start.answered);
  writer.resolve(controller.start.memories);
  writer.resolve(controller.start.outputs);
  writer.resolve(controller.legal);
  writer.resolve(controller.updates);
  writer.resolve(controller.derived);
  writer.resolve(controller.winning);
  for (auto& goal : controller.goals) {
    writer.resolve(goal.answers);
    writer.resolve(goal.met);
    writer.resolve(goal.ranks);
  }
}

model::SymbolicController with_columns(const spec::Gr1& spec) {
  model::SymbolicController result;
  result.name = spec.name;
  result.inputs = spec.inputs;
  result.outputs = spec.outputs;
  const std::vector<model::Output> columns = spec::controller_outputs(spec);
  const auto memories = columns.begin() + static_cast<std::ptrdiff_t>(spec.outputs.size());
  const auto definitions = memories + static_cast<std::ptrdiff_t>(spec.memories.size());
  result.memories.assign(memories, definitions);
  result.definitions.assign(definitions, columns.end());
  result.assumptions = assumption_texts(spec);
  return result;
}

}  // namespace

std::vector<std::string> assumption_texts(const spec::Gr1& spec) {
  std::vector<std::string> texts;
  for (const auto& clause : spec.env_init) texts.push_back(logic::to_string(clause.formula));
  for (const auto& clause : spec.env_safety) texts.push_back(logic::to_string(logic::always(clause.formula)));
  for (const auto& clause : spec.env_justice)
    texts.push_back(logic::to_string(logic::always(logic::eventually(clause.formula))));
  return texts;
}

model::SymbolicController make_symbolic(const game::Game& game, const game::Region& region,
                                        util::Budget& budget) {
  const Determiner determiner(game, budget);
  DiagramWriter writer(game);
  model::SymbolicController result = with_columns(*game.spec);
  result.start = make_start(game, region, determiner, writer);
  result.legal = writer.add(game.env_safety);
  result.updates = writer.add(game.updates);
  result.derived = writer.add(game.definitions);
  result.winning = writer.add(region.winning);
  const std::vector<Var> outputs = game.bits(Owner::Output, true);
  const std::vector<Rule> rules = make_rules(game, region, budget);
  bool waits = false;
  for (std::size_t goal = 0; goal < rules.size(); ++goal) {
    waits = waits || !rules[goal].waits.is_false();
    result.goals.push_back({writer.add(determiner.functions(rules[goal].moves, outputs)),
                            writer.add(game.sys_justice[goal].relation), levels_of(region, goal, writer)});
  }
  if (waits)
    result.notes.emplace_back(
        "somewhere it makes no progress of its own and waits for what is assumed to happen again and again");
  resolve(result, writer);
  return result;
}

}  // namespace heed::strategy
