#include "encoder.h"
#include "mentions.h"
#include "order.h"

#include <heed/game/game.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

namespace heed::game {
namespace {

using bdd::Bdd;

std::size_t bits_for(const model::Domain& domain) {
  std::size_t bits = 0;
  while ((std::int64_t{1} << bits) < domain.size()) ++bits;
  return bits;
}

/// The conjuncts of \p formula, in the order written; from left to right through nested conjunctions.
std::vector<logic::Formula> conjuncts(const logic::Formula& formula) {
  std::vector<logic::Formula> result;
  std::vector<logic::Formula> open{formula};
  std::set<const void*> seen;
  while (!open.empty()) {
    const logic::Formula here = std::move(open.back());
    open.pop_back();
    if (!seen.insert(here.identity()).second) continue;
    if (here.op() != logic::Op::And) {
      result.push_back(here);
      continue;
    }
    const auto operands = here.operands();
    open.insert(open.end(), operands.rbegin(), operands.rend());
  }
  return result;
}

/// Builds one game, part by part.
class Builder {
 public:
  Builder(const spec::Gr1& spec, util::Budget& budget, const BuildOptions& options)
      : budget_(budget),
        options_(options),
        manager_(std::make_shared<bdd::Manager>(bdd::ManagerOptions{}, &budget)),
        encoder_(*manager_, budget),
        symbols_(spec) {
    game_.manager = manager_;
    game_.spec = std::make_shared<const spec::Gr1>(spec);
    for (const auto& output : spec.outputs) answers_.insert(output.variable.name);
  }

  Game build() {
    declare();
    make_cubes();
    define();
    initial();
    environment();
    system();
    memories();
    game_.env_justice = justices(game_.spec->env_justice);
    game_.sys_justice = justices(game_.spec->sys_justice);
    return std::move(game_);
  }

 private:
  void declare() {
    const spec::Gr1& spec = *game_.spec;
    for (const auto& input : spec.inputs) game_.variables.push_back({input, Owner::Input, {}});
    for (const auto& output : spec.outputs) game_.variables.push_back({output.variable, Owner::Output, {}});
    for (const auto& memory : spec.memories) game_.variables.push_back({memory.variable, Owner::Memory, {}});
    for (const std::size_t index : order()) {
      Encoded& variable = game_.variables[index];
      for (std::size_t i = bits_for(variable.variable.domain); i > 0; --i)
        variable.bits.push_back(manager_->new_pair());
      // The least one on top: successors of a number then share all nodes but those of the bits that change.
      // Names follow upon each other in no order.
      if (variable.variable.domain.kind != model::Domain::Kind::Enumeration)
        std::reverse(variable.bits.begin(), variable.bits.end());
    }
    game_.valid = constant(true);
    for (const Encoded& variable : game_.variables) {
      encoder_.add_variable(variable);
      game_.valid &= in_range(variable);
    }
  }

  [[nodiscard]] std::vector<std::size_t> order() const {
    if (options_.techniques.structure_order) return static_order(*game_.spec);
    std::vector<std::size_t> declared(game_.variables.size());
    std::iota(declared.begin(), declared.end(), std::size_t{0});
    return declared;
  }

  [[nodiscard]] Bdd constant(bool value) const { return manager_->constant(value); }

  /// The codes of the domain are the values of the bits below its size.
  [[nodiscard]] Bdd in_range(const Encoded& variable) const {
    const std::int64_t last = variable.variable.domain.size() - 1;
    Bdd below = constant(true);
    for (std::size_t i = variable.bits.size(); i-- > 0;) {
      const Bdd bit = manager_->variable(variable.bits[i].current);
      const bool one = ((last >> (variable.bits.size() - 1 - i)) & 1) != 0;
      below = one ? bit.implies(below) : below.minus(bit);
    }
    return below;
  }

  [[nodiscard]] Bdd ranges(Owner owner) const {
    Bdd all = constant(true);
    for (const Encoded& variable : game_.variables)
      if (variable.owner == owner) all &= in_range(variable);
    return all;
  }

  void make_cubes() {
    game_.inputs = manager_->cube(game_.bits(Owner::Input, false));
    game_.outputs = manager_->cube(game_.bits(Owner::Output, false));
    game_.memories = manager_->cube(game_.bits(Owner::Memory, false));
    game_.next_inputs = manager_->cube(game_.bits(Owner::Input, true));
    game_.next_outputs = manager_->cube(game_.bits(Owner::Output, true));
    game_.next_memories = manager_->cube(game_.bits(Owner::Memory, true));
  }

  [[nodiscard]] static bool meets(const Bdd& function, const std::vector<bdd::Var>& variables) {
    const std::vector<bdd::Var> support = function.support_variables();
    return std::any_of(variables.begin(), variables.end(),
                       [&](bdd::Var v) { return std::binary_search(support.begin(), support.end(), v); });
  }

  /// \p formula, refused where it depends on something that \p part must not speak of.
  [[nodiscard]] Bdd restricted(const logic::Formula& formula,
                               std::initializer_list<std::pair<Owner, bool>> excluded, const char* part,
                               const char* allowed) const {
    Bdd function = encoder_.holds(formula);
    for (const auto& [owner, next] : excluded)
      if (meets(function, game_.bits(owner, next)))
        throw util::InputError(formula.location(), "not-allowed-here",
                               fmt::format("{} may only speak of {}", part, allowed));
    return function;
  }

  void define() {
    for (const auto& definition : game_.spec->definitions) {
      const Bdd value =
          restricted(definition.formula, {{Owner::Input, true}, {Owner::Output, true}, {Owner::Memory, true}},
                     fmt::format("the definition of '{}'", definition.name).c_str(), "current values");
      game_.definitions.push_back(value);
      encoder_.add_definition(definition.name, value);
      if (judged_by_answers(definition.formula)) answers_.insert(definition.name);
    }
  }

  void initial() {
    const spec::Gr1& spec = *game_.spec;
    game_.env_initial = ranges(Owner::Input);
    for (const auto& clause : spec.env_init)
      game_.env_initial &= restricted(clause.formula,
                                      {{Owner::Output, false},
                                       {Owner::Memory, false},
                                       {Owner::Input, true},
                                       {Owner::Output, true},
                                       {Owner::Memory, true}},
                                      "the environment's initial condition", "inputs");
    game_.memory_initial = constant(true);
    for (std::size_t i = 0; i < spec.memories.size(); ++i) {
      const Encoded& variable = game_.variables[spec.inputs.size() + spec.outputs.size() + i];
      Bdd any = constant(false);
      for (const std::int32_t code : spec.memories[i].initial)
        any |= Encoder::has_code(*manager_, variable, code, false);
      game_.memory_initial &= any;
    }
    game_.sys_initial.push_back({ranges(Owner::Output), Part::no_clause});
    for (std::size_t i = 0; i < spec.sys_init.size(); ++i)
      game_.sys_initial.push_back(
          {restricted(spec.sys_init[i].formula,
                      {{Owner::Input, true}, {Owner::Output, true}, {Owner::Memory, true}},
                      "the system's initial condition", "current values"),
           i});
  }

  /// Whether \p formula speaks of outputs, or of what is defined by them.
  [[nodiscard]] bool judged_by_answers(const logic::Formula& formula) const {
    const std::set<std::string> names = mentioned(formula, symbols_);
    return std::any_of(names.begin(), names.end(),
                       [this](const auto& name) { return answers_.count(name) != 0; });
  }

  void environment() {
    for (const Encoded& variable : game_.variables)
      if (variable.owner == Owner::Input) add_env_step(in_range(variable).next());
    for (const auto& clause : game_.spec->env_safety) {
      const bool state = !clause.formula.has_next() && !judged_by_answers(clause.formula);
      for (const logic::Formula& conjunct : conjuncts(clause.formula)) {
        const Bdd holds =
            restricted(conjunct, {{Owner::Output, true}}, "an assumption on the environment's steps",
                       "current values and primed inputs");
        if (state) game_.env_initial &= holds;
        add_env_step(state ? holds.next() : holds);
      }
    }
    if (options_.whole_environment) game_.env_safety = game_.env_steps;
  }

  void add_env_step(const Bdd& holds) {
    if (!holds.is_true()) game_.env_steps.push_back(holds);
  }

  void add_sys_step(const Bdd& holds, std::size_t clause) {
    if (!holds.is_true()) game_.sys_safety.push_back({holds, clause});
  }

  void system() {
    for (const Encoded& variable : game_.variables)
      if (variable.owner == Owner::Output) add_sys_step(in_range(variable).next(), Part::no_clause);
    for (std::size_t i = 0; i < game_.spec->sys_safety.size(); ++i) {
      const auto& clause = game_.spec->sys_safety[i];
      const bool state = !clause.formula.has_next();
      for (const logic::Formula& conjunct : conjuncts(clause.formula)) {
        const Bdd holds = encoder_.holds(conjunct);
        if (state) game_.initial_safety.push_back({holds, i});
        add_sys_step(state ? holds.next() : holds, i);
      }
    }
  }

  void memories() {
    const spec::Gr1& spec = *game_.spec;
    for (std::size_t i = 0; i < spec.memories.size(); ++i) {
      const Encoded& variable = game_.variables[spec.inputs.size() + spec.outputs.size() + i];
      const std::vector<Bdd> value = next_value(spec.memories[i], variable);
      game_.updates.insert(game_.updates.end(), value.begin(), value.end());
    }
  }

  [[nodiscard]] Bdd update_formula(const logic::Formula& formula, const std::string& name) const {
    return restricted(formula, {{Owner::Output, true}, {Owner::Memory, true}},
                      fmt::format("the update of '{}'", name).c_str(), "current values and primed inputs");
  }

  [[nodiscard]] std::vector<Bdd> next_value(const spec::Memory& memory, const Encoded& variable) const {
    const std::string& name = variable.variable.name;
    if (variable.variable.domain.kind == model::Domain::Kind::Boolean)
      return {update_formula(memory.update, name)};
    std::vector<Bdd> value;
    value.reserve(variable.bits.size());
    for (const bdd::Pair& pair : variable.bits) value.push_back(manager_->variable(pair.current));
    for (auto guarded = memory.cases.rbegin(); guarded != memory.cases.rend(); ++guarded) {
      budget_.check();
      const Bdd guard = update_formula(guarded->guard, name);
      const std::int64_t offset = std::int64_t{guarded->value} - variable.variable.domain.low;
      for (std::size_t i = 0; i < value.size(); ++i) {
        const bool one = ((offset >> (value.size() - 1 - i)) & 1) != 0;
        value[i] = one ? guard | value[i] : value[i].minus(guard);
      }
    }
    return value;
  }

  [[nodiscard]] std::vector<Justice> justices(const std::vector<spec::Clause>& clauses) const {
    std::vector<Justice> result;
    for (std::size_t i = 0; i < clauses.size(); ++i) {
      Justice justice{encoder_.holds(clauses[i].formula), false, i};
      for (const Owner owner : {Owner::Input, Owner::Output, Owner::Memory})
        justice.step = justice.step || meets(justice.relation, game_.bits(owner, true));
      result.push_back(std::move(justice));
    }
    if (result.empty()) result.push_back({constant(true), false, Part::no_clause});
    return result;
  }

  util::Budget& budget_;
  BuildOptions options_;
  std::shared_ptr<bdd::Manager> manager_;
  Encoder encoder_;
  spec::Symbols symbols_;
  std::set<std::string> answers_;  ///< Outputs, and what is defined by them.
  Game game_;
};

std::vector<Part> kept(const std::vector<Part>& parts, const std::vector<bool>& selection) {
  std::vector<Part> result;
  for (const Part& part : parts)
    if (part.clause == Part::no_clause || selection[part.clause]) result.push_back(part);
  return result;
}

}  // namespace

std::vector<bdd::Var> Game::bits(Owner owner, bool next) const {
  std::vector<bdd::Var> result;
  for (const Encoded& variable : variables) {
    if (variable.owner != owner) continue;
    for (const bdd::Pair& pair : variable.bits) result.push_back(next ? pair.next : pair.current);
  }
  return result;
}

bdd::Bdd Game::initial_answer() const {
  Bdd answer = env_initial & memory_initial;
  for (const auto* parts : {&sys_initial, &initial_safety})
    for (const Part& part : *parts) answer &= part.relation;
  return answer;
}

bdd::Bdd Game::initial_inputs() const {
  return env_initial.and_exists(memory_initial, memories);
}

Game build_game(const spec::Gr1& spec, util::Budget& budget, const BuildOptions& options) {
  spec::validate(spec);
  return Builder(spec, budget, options).build();
}

Game select(const Game& game, const Selection& selection) {
  Game result = game;
  result.sys_initial = kept(game.sys_initial, selection.init);
  result.initial_safety = kept(game.initial_safety, selection.safety);
  result.sys_safety = kept(game.sys_safety, selection.safety);
  result.sys_justice.clear();
  for (const Justice& justice : game.sys_justice)
    if (justice.clause == Part::no_clause || selection.justice[justice.clause])
      result.sys_justice.push_back(justice);
  if (result.sys_justice.empty())
    result.sys_justice.push_back({game.manager->constant(true), false, Part::no_clause});
  return result;
}

}  // namespace heed::game
