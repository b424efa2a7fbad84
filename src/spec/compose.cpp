#include <heed/logic/parse.h>
#include <heed/spec/compose.h>
#include <heed/spec/symbols.h>

#include "lowering.h"
#include "nodes.h"
#include "plant.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;
using model::OutputRole;

[[noreturn]] void fail(const util::Location& location, std::string code, std::string message,
                       std::string hint = {}) {
  throw util::InputError(location, std::move(code), std::move(message), std::move(hint));
}

class Composer {
 public:
  Composer(const model::Fts& plant, const Composition& parts) : plant_(plant), parts_(parts), terms_(plant) {}

  Composed run() {
    check_clashes();
    spec().name = parts_.name;
    spec().inputs = parts_.inputs;
    add_plant();
    add_knowledge();
    add_first_observation();
    for (const auto* list : {&parts_.perception, &parts_.assumptions, &parts_.guarantees})
      for (const Requirement& requirement : *list) check_names(requirement.formula);
    add_requirements(spec(), {expanded(parts_.perception), {}, Origin::Perception});
    add_bindings();
    add_requirements(spec(), {expanded(parts_.assumptions), expanded(parts_.guarantees), Origin::Task});
    expand_again();
    validate(spec());
    return std::move(composed_);
  }

 private:
  Gr1& spec() { return composed_.spec; }

  void note(util::Severity severity, std::string code, std::string message) {
    composed_.notes.push_back({severity, {}, std::move(code), std::move(message), {}, {}});
  }

  [[nodiscard]] std::vector<std::string> plant_names() const {
    std::vector<std::string> out{plant_state, plant_action};
    for (const auto& [name, states] : plant_.labels) out.push_back(name);
    for (const auto& [name, values] : plant_.values) out.push_back(name);
    return out;
  }

  void check_clashes() const {
    std::set<std::string> taken;
    for (const std::string& name : plant_names())
      if (!taken.insert(name).second)
        fail({}, "name-clash", fmt::format("the plant {} has two things called '{}'", plant_.name, name));
    const auto check = [&taken](const std::string& name, const util::Location& location, const char* what) {
      if (taken.count(name) != 0)
        fail(location, "name-clash",
             fmt::format("the {} '{}' has the name of something of the plant", what, name),
             "rename one of the two");
    };
    for (const auto& input : parts_.inputs) check(input.name, input.location, "input");
    for (const auto& memory : parts_.memories)
      check(memory.variable.name, memory.variable.location, "memory");
    for (const auto& definition : parts_.definitions)
      check(definition.name, definition.formula.location(), "derived symbol");
  }

  [[nodiscard]] std::vector<std::uint32_t> initial_states() const {
    if (parts_.initial_states.empty()) return plant_.initial;
    for (const std::uint32_t state : parts_.initial_states)
      if (std::find(plant_.initial.begin(), plant_.initial.end(), state) == plant_.initial.end())
        fail({}, "initial-state",
             fmt::format("{} is no initial state of the plant", state < plant_.states.size()
                                                                    ? "'" + plant_.states[state] + "'"
                                                                    : "a state outside the plant"),
             "the start can be narrowed, not moved");
    return parts_.initial_states;
  }

  void add_plant() {
    if (plant_.states.empty() || plant_.actions.empty())
      fail({}, "empty-plant", "the plant has no states or no actions");
    model::Variable state{plant_state, model::Domain::enumeration(plant_.states), "the plant's state"};
    model::Variable action{plant_action, model::Domain::enumeration(plant_.actions),
                           "what the plant does next"};
    spec().outputs.push_back({std::move(action), OutputRole::Action});
    if (terms_.deterministic())
      add_tracked(std::move(state));
    else
      add_observed(std::move(state));
    for (std::uint32_t a = 0; a < plant_.actions.size(); ++a)
      add_clause(spec().sys_safety, logic::implies(is_action(a), terms_.inside(terms_.enabled(a))),
                 fmt::format("{} only where the plant can", plant_.actions[a]));
  }

  static void add_clause(std::vector<Clause>& part, Formula formula, std::string text) {
    if (!formula.is_true()) part.push_back({std::move(formula), Origin::Plant, std::move(text)});
  }

  [[nodiscard]] Formula is_action(std::uint32_t a) const {
    return logic::compare(Op::Eq, logic::name(plant_action), logic::name(plant_.actions[a]));
  }

  [[nodiscard]] Formula is_state(std::uint32_t s) const {
    return logic::compare(Op::Eq, logic::name(plant_state), logic::name(plant_.states[s]));
  }

  void add_tracked(model::Variable state) {
    Memory memory;
    memory.comment = state.comment;
    memory.variable = std::move(state);
    memory.role = OutputRole::Plant;
    memory.initial.clear();
    for (const std::uint32_t s : initial_states()) memory.initial.push_back(static_cast<std::int32_t>(s));
    for (const auto& t : plant_.transitions)
      memory.cases.push_back({is_state(t.from) && is_action(t.action), static_cast<std::int32_t>(t.to)});
    spec().memories.push_back(std::move(memory));
  }

  void add_observed(model::Variable state) {
    spec().inputs.push_back(std::move(state));
    StateSet first(plant_.states.size());
    for (const std::uint32_t s : initial_states()) first[s] = true;
    add_clause(spec().env_init, terms_.inside(first), "where the plant starts");
    for (std::uint32_t s = 0; s < plant_.states.size(); ++s)
      for (std::uint32_t a = 0; a < plant_.actions.size(); ++a) {
        StateSet after(plant_.states.size());
        const auto successors = plant_.successors(s, a);
        for (const std::uint32_t to : successors) after[to] = true;
        if (successors.empty()) continue;
        add_clause(spec().env_safety, logic::implies(is_state(s) && is_action(a), terms_.next_inside(after)),
                   fmt::format("{} -{}-> ...", plant_.states[s], plant_.actions[a]));
      }
    note(util::Severity::Note, "nondeterministic-plant",
         "the plant is nondeterministic: where an action has several successors the environment chooses, "
         "against the controller");
  }

  void add_knowledge() {
    for (Memory memory : parts_.memories) {
      memory.update = expand(memory.update, terms_).formula;
      for (Memory::Case& c : memory.cases) c.guard = expand(c.guard, terms_).formula;
      spec().memories.push_back(std::move(memory));
    }
    for (Definition definition : parts_.definitions) {
      definition.formula = expand(definition.formula, terms_).formula;
      spec().definitions.push_back(std::move(definition));
    }
    sort_definitions(spec());
  }

  void add_first_observation() {
    if (!parts_.first_observation) return;
    const model::Valuation& first = *parts_.first_observation;
    if (first.size() != parts_.inputs.size())
      fail({}, "first-observation", "the first observation does not give each input a value");
    for (std::size_t i = 0; i < first.size(); ++i) {
      const model::Variable& input = parts_.inputs[i];
      const Formula name = logic::name(input.name);
      if (first[i] < input.domain.low || first[i] > input.domain.high)
        fail(input.location, "first-observation",
             fmt::format("the first observation gives '{}' a value outside its type", input.name));
      Formula formula = first[i] != 0 ? name : !name;
      if (input.domain.kind == model::Domain::Kind::Integer)
        formula = logic::compare(Op::Eq, name, logic::number(first[i]));
      if (input.domain.kind == model::Domain::Kind::Enumeration)
        formula = logic::compare(Op::Eq, name, logic::name(input.domain.print(first[i])));
      spec().env_init.push_back({std::move(formula), Origin::Perception, "the first observation"});
    }
  }

  /// Unknown names are refused before lowering, where positions and the user's words are still there.
  void check_names(const Formula& formula) {
    const Symbols symbols(spec());
    std::vector<std::string> known = symbols.names();
    for (const std::string& name : plant_names())
      if (!symbols.find(name)) known.push_back(name);
    const std::set<std::string> names(known.begin(), known.end());
    std::set<const void*> values;
    const auto nodes = logic::postorder(formula);
    for (const Formula& node : nodes)
      if (is_comparison(node.op())) mark_values(node, symbols, values);
    for (const Formula& node : nodes)
      if (node.op() == Op::Name && names.count(node.name()) == 0 && values.count(node.identity()) == 0)
        fail(node.location(), "unknown-name", fmt::format("unknown name '{}'", node.name()),
             util::suggestion(node.name(), known));
  }

  static const Formula& inner(const Formula& term) {
    const Formula* at = &term;
    while (at->op() == Op::Next) at = &(*at)[0];
    return *at;
  }

  static void mark_values(const Formula& comparison, const Symbols& symbols, std::set<const void*>& values) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Formula &value = inner(comparison[k]), &variable = inner(comparison[1 - k]);
      if (enumeration_value(comparison, k, symbols)) values.insert(value.identity());
      if (value.op() != Op::Name || variable.op() != Op::Name || symbols.find(value.name())) continue;
      const Symbol* symbol = symbols.find(variable.name());
      if (!symbol || symbol->domain.kind != model::Domain::Kind::Enumeration ||
          values.count(value.identity()) != 0)
        continue;
      fail(value.location(), "unknown-name",
           fmt::format("'{}' is no value of '{}'", value.name(), variable.name()),
           util::suggestion(value.name(), symbol->domain.values));
    }
  }

  [[nodiscard]] std::vector<Requirement> expanded(const std::vector<Requirement>& requirements) const {
    std::vector<Requirement> out = requirements;
    for (Requirement& requirement : out) {
      if (requirement.text.empty()) requirement.text = logic::to_string(requirement.formula);
      requirement.formula = expand(requirement.formula, terms_).formula;
    }
    return out;
  }

  /// Triggers that ask for one and the same thing of the plant.
  struct Effect {
    StateSet states;
    std::string text;
    std::vector<Formula> triggers;
    std::vector<std::string> names{}, axioms{};  ///< The triggers as texts.
  };

  void add_bindings() {
    std::vector<Effect> effects;
    std::set<std::string> bound;
    for (const Binding& binding : parts_.bindings) {
      const Definition& trigger = trigger_of(binding);
      const StateSet states = effect_of(binding);
      auto same =
          std::find_if(effects.begin(), effects.end(), [&](const Effect& e) { return e.states == states; });
      if (same == effects.end()) {
        const std::string text = binding.text.empty() ? logic::to_string(binding.effect) : binding.text;
        same = effects.insert(same, {states, text, {}});
      }
      same->triggers.push_back(logic::name(trigger.name) && !expand(binding.unless, terms_).formula);
      same->names.push_back(logic::to_string(same->triggers.back()));
      for (const std::string& axiom : trigger.axioms)
        if (std::find(same->axioms.begin(), same->axioms.end(), axiom) == same->axioms.end())
          same->axioms.push_back(axiom);
      bound.insert(binding.behaviour);
    }
    for (const Effect& effect : effects) add_effect(effect);
    note_unbound(bound);
  }

  void note_unbound(const std::set<std::string>& bound) {
    std::string names;
    for (const Definition& d : spec().definitions)
      if (d.role == OutputRole::Prescribed && bound.count(d.name) == 0)
        names += fmt::format("{}'{}'", names.empty() ? "" : ", ", d.name);
    if (!names.empty())
      note(util::Severity::Note, "unbound-behaviour",
           fmt::format("advice only, bound to nothing of the plant: {}", names));
  }

  void add_effect(const Effect& effect) {
    const Formula then = terms_.next_inside(effect.states);
    if (std::find(effect.states.begin(), effect.states.end(), true) == effect.states.end())
      note(util::Severity::Warning, "empty-binding",
           fmt::format("no state of the plant is '{}'", effect.text));
    if (parts_.only_when_prescribed) {
      spec().sys_safety.push_back({logic::iff(then, logic::any_of(effect.triggers)), Origin::Binding,
                                   fmt::format("X ({}) <-> {}", effect.text, fmt::join(effect.names, " | ")),
                                   effect.axioms});
      note(util::Severity::Note, "only-when-prescribed",
           fmt::format("'{}' happens for no other reason than {}", effect.text,
                       fmt::join(effect.names, ", ")));
      return;
    }
    for (std::size_t i = 0; i < effect.triggers.size(); ++i)
      spec().sys_safety.push_back({logic::implies(effect.triggers[i], then), Origin::Binding,
                                   fmt::format("{} -> X ({})", effect.names[i], effect.text), effect.axioms});
  }

  [[nodiscard]] const Definition& trigger_of(const Binding& binding) const {
    std::vector<std::string> known;
    for (const Definition& definition : parts_.definitions) {
      if (definition.name == binding.behaviour) return definition;
      if (definition.role == OutputRole::Prescribed) known.push_back(definition.name);
    }
    fail(binding.effect.location(), "unknown-behaviour",
         fmt::format("a binding of the unknown behaviour '{}'", binding.behaviour),
         util::suggestion(binding.behaviour, known));
  }

  [[nodiscard]] StateSet effect_of(const Binding& binding) const {
    for (const Formula& node : logic::postorder(binding.effect)) {
      if (node.op() == Op::Next)
        fail(node.location(), "x-in-binding", fmt::format("an X in a binding of '{}'", binding.behaviour),
             "bind to what holds in the state; that it holds next comes from the rule");
      if (is_temporal_beyond_next(node.op()))
        fail(node.location(), "temporal-in-binding",
             fmt::format("a temporal operator in a binding of '{}'", binding.behaviour));
    }
    if (binding.effect.is_true() || binding.effect.is_false())
      return StateSet(plant_.states.size(), binding.effect.is_true());
    Expanded expanded = expand(binding.effect, terms_);
    if (expanded.states) return std::move(*expanded.states);
    std::vector<std::string> known = plant_names();
    known.erase(std::find(known.begin(), known.end(), plant_action));
    for (const Formula& node : logic::postorder(binding.effect))
      if (node.op() == Op::Name && std::find(known.begin(), known.end(), node.name()) == known.end() &&
          !terms_.state(node.name()))
        fail(node.location(), "unknown-name",
             fmt::format("'{}' in a binding is nothing of the plant's states", node.name()),
             util::suggestion(node.name(), known));
    fail(binding.effect.location(), "binding",
         fmt::format("the binding of '{}' does not speak of the plant's states", binding.behaviour));
  }

  /// Lowering may have put Next before what expansion left below other temporal operators.
  void expand_again() {
    for (auto part : {&Gr1::env_init, &Gr1::env_safety, &Gr1::env_justice, &Gr1::sys_init, &Gr1::sys_safety,
                      &Gr1::sys_justice})
      for (Clause& clause : spec().*part) clause.formula = expand(clause.formula, terms_).formula;
    for (Memory& memory : spec().memories)
      if (memory.cases.empty()) memory.update = expand(memory.update, terms_).formula;
  }

  const model::Fts& plant_;
  const Composition& parts_;
  PlantTerms terms_;
  Composed composed_;
};

}  // namespace

Composed compose(const model::Fts& plant, const Composition& parts) {
  return Composer(plant, parts).run();
}

}  // namespace heed::spec
