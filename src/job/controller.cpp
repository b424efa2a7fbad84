#include "named_file.h"

#include <heed/awareness/explain.h>
#include <heed/job/clashes.h>
#include <heed/job/controller.h>
#include <heed/logic/parse.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::job {
namespace {

std::vector<awareness::Name> names(const std::vector<Word>& words) {
  std::vector<awareness::Name> names;
  for (const Word& word : words) names.emplace_back(word.text, word.location);
  return names;
}

/// When \p name is a role that binds features: the most specific ones through it. A triangle that is always
/// an upright or an inverted one is left to these, so that the values exclude each other.
std::vector<std::string> values_of_role(const awareness::Catalogue& catalogue, const std::string& name) {
  const auto through = [&](const awareness::Feature& feature) {
    return feature.kind != awareness::Feature::Kind::Class &&
           (catalogue.ontology.local_name(feature.role) == name ||
            catalogue.ontology.text(feature.role) == name);
  };
  std::set<std::size_t> general;
  for (const awareness::Feature& feature : catalogue.features)
    if (through(feature))
      for (const awareness::Entailed& above : feature.implies) general.insert(above.index);
  std::vector<std::string> values;
  for (std::size_t f = 0; f < catalogue.features.size(); ++f)
    if (through(catalogue.features[f]) && !general.contains(f)) values.push_back(catalogue.features[f].atom);
  return values;
}

awareness::PerceptionOptions perception_options(const PerceptionPart& part,
                                                const awareness::Catalogue& catalogue) {
  awareness::PerceptionOptions options;
  options.enumerate = part.enumerate;
  options.full_view = part.full_view;
  for (const InputPart& input : part.inputs) {
    const auto reading =
        input.whole ? awareness::Reported::Reading::Whole : awareness::Reported::Reading::Automatic;
    const auto values = values_of_role(catalogue, input.what.text);
    for (const std::string& value : values)
      options.reported.push_back({awareness::Name(value, input.what.location), "", reading, input.excluded});
    if (values.empty())
      options.reported.push_back(
          {awareness::Name(input.what.text, input.what.location), input.name, reading, input.excluded});
  }
  return options;
}

awareness::PolicyOptions policy_options(const ControllerPart& part) {
  awareness::PolicyOptions options;
  options.kind = *awareness::read_policy(part.policy.text);
  options.location = part.policy.location;
  options.entities = names(part.entities);
  options.over = names(part.over);
  options.order = names(part.order);
  options.k = part.k;
  options.latch = part.latch;
  // What entails the thing is the thing read whole above all; the other policies ask for it by name.
  options.direct = part.direct.value_or(options.kind == awareness::PolicyOptions::Kind::Identifying);
  if (part.behaviours) options.acting = *awareness::read_acting(part.behaviours->text);
  options.closed = part.closed;
  options.fallback = names(part.fallback);
  return options;
}

std::vector<std::uint32_t> initial_states(const PlantPart& part, const model::Fts& plant) {
  std::vector<std::uint32_t> states;
  for (const Word& word : part.initial) {
    const auto found = std::find(plant.states.begin(), plant.states.end(), word.text);
    if (found == plant.states.end())
      throw util::InputError(word.location, "unknown-state",
                             fmt::format("the plant has no state '{}'", word.text),
                             util::suggestion(word.text, plant.states));
    states.push_back(static_cast<std::uint32_t>(found - plant.states.begin()));
  }
  return states;
}

std::vector<std::string> axiom_ids(const std::vector<owl::AxiomId>& axioms) {
  std::vector<std::string> ids;
  for (const owl::AxiomId id : axioms) ids.push_back(owl::to_string(id));
  return ids;
}

/// "; because a12 Stop sign SubClassOf ...": for whoever asks a running controller why.
std::string because(const awareness::Catalogue& catalogue, const std::vector<owl::AxiomId>& axioms) {
  std::string out;
  for (const auto& axiom : awareness::axiom_texts(catalogue, axioms))
    out += fmt::format("{}{}", out.empty() ? "; because " : ", ", axiom.text);
  return out;
}

model::Variable variable_of(const awareness::PerceptionInput& input) {
  if (input.values.empty()) return {input.name, model::Domain::boolean(), {}, {}};
  return {input.name, model::Domain::enumeration(input.values), {}, {}};
}

void add_perception(const PerceptionPart& part, const awareness::Perception& perception,
                    spec::Composition& parts) {
  for (const awareness::PerceptionInput& input : perception.inputs) {
    parts.inputs.push_back(variable_of(input));
    for (const InputPart& written : part.inputs)
      if (written.name == input.name) parts.inputs.back().location = written.what.location;
  }
  if (part.blank_first) parts.first_observation.emplace(parts.inputs.size(), 0);
  if (part.persistent)
    for (const auto& [atom, meaning] : perception.symbols) {
      const auto kept =
          logic::always(logic::implies(part.persistent->formula && meaning, logic::next(meaning)));
      parts.perception.push_back(
          {kept, fmt::format("G({} & {} -> X {})", part.persistent->text, atom, atom), {}});
    }
  for (const WrittenFormula& assumed : part.assume)
    parts.perception.push_back({perception.over_inputs(assumed.formula), assumed.text, {}});
}

std::string evidence_words(const awareness::RecognisedEntity& entity) {
  std::string out;
  for (const awareness::Evidence& evidence : entity.evidence) {
    if (!out.empty()) out += " or ";
    for (std::size_t i = 0; i < evidence.atoms.size(); ++i) out += (i == 0 ? "" : " & ") + evidence.atoms[i];
  }
  return out;
}

void add_recognition(const World& world, const awareness::Recognition& recognition,
                     spec::Composition& parts) {
  const awareness::Perception& perception = world.perception;
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  for (const awareness::LevelMemory& level : recognition.memories) {
    spec::Memory memory;
    memory.variable = {level.name, model::Domain::boolean(), level.comment, {}};
    memory.update = perception.over_inputs(level.update);
    memory.comment = level.comment;
    parts.memories.push_back(std::move(memory));
  }
  for (const awareness::Situation& situation : recognition.situations)
    parts.definitions.push_back({situation.name,
                                 perception.over_inputs(situation.formula),
                                 model::OutputRole::Recognised,
                                 situation.words,
                                 {}});
  for (const awareness::RecognisedEntity& entity : recognition.entities)
    parts.definitions.push_back({entity.name, perception.over_inputs(entity.formula),
                                 model::OutputRole::Recognised,
                                 fmt::format("{}: {}{}", catalogue.entities[entity.entity].label,
                                             evidence_words(entity), because(catalogue, entity.axioms)),
                                 axiom_ids(entity.axioms)});
  for (const awareness::PrescribedBehaviour& behaviour : recognition.behaviours) {
    std::string by;
    for (const std::size_t entity : behaviour.because)
      by += (by.empty() ? "" : ", ") + catalogue.entities[entity].label;
    parts.definitions.push_back(
        {behaviour.name, perception.over_inputs(behaviour.formula), model::OutputRole::Prescribed,
         fmt::format("{}: prescribed by {}{}", catalogue.behaviours[behaviour.behaviour].label, by,
                     because(catalogue, behaviour.axioms)),
         axiom_ids(behaviour.axioms)});
  }
}

/// A bound behaviour that nothing recognised prescribes is never prescribed; the binding still stands.
void add_bindings(const Scenario& scenario, const World& world, const awareness::Recognition& recognition,
                  spec::Composition& parts) {
  const std::vector<Precedence> found = precedences(scenario, world, recognition);
  for (std::size_t b = 0; b < scenario.bindings.size(); ++b) {
    const BindingPart& binding = scenario.bindings[b];
    if (!found[b].prescribed)
      parts.definitions.push_back({found[b].name,
                                   logic::truth(false),
                                   model::OutputRole::Prescribed,
                                   binding.behaviour.text + ": nothing recognised here prescribes it",
                                   {}});
    parts.bindings.push_back({found[b].name, binding.effect.formula, binding.effect.text, found[b].unless});
  }
  parts.only_when_prescribed = scenario.only_when_prescribed;
}

std::vector<std::string> perception_assumptions(const spec::Gr1& spec) {
  std::vector<std::string> texts;
  for (const auto* part : {&spec.env_init, &spec.env_safety, &spec.env_justice})
    for (const spec::Clause& clause : *part)
      if (clause.origin != spec::Origin::Plant)
        texts.push_back(clause.text.empty() ? logic::to_string(clause.formula) : clause.text);
  return texts;
}

}  // namespace

awareness::Perception perceive(const PerceptionPart& part, const awareness::Catalogue& catalogue) {
  return awareness::resolve_perception(catalogue, perception_options(part, catalogue));
}

awareness::Recognition recognise(const ControllerPart& part, const awareness::Catalogue& catalogue,
                                 const awareness::Perception& perception) {
  return awareness::compile_policy(catalogue, perception, policy_options(part));
}

World load_world(const Scenario& scenario, const util::Limits& limits, util::Budget& budget) {
  World world;
  world.knowledge = load_knowledge(scenario.knowledge, limits, budget);
  refuse_left_out(world.knowledge, scenario.knowledge);
  refuse_unsatisfiable(world.knowledge, scenario.knowledge);
  const PlantPart& plant = scenario.plant;
  const auto plant_file = [&] { return util::read_file(plant.path.text, limits); };
  world.plant = model::read_fts(
      plant.path.text.empty() ? plant.text : named_in_scenario(plant.path, plant_file), limits);
  world.initial_states = initial_states(plant, world.plant);
  world.perception = perceive(scenario.perception, world.knowledge.catalogue);
  return world;
}

Design design(const Scenario& scenario, const World& world, const ControllerPart& part) {
  Design design;
  design.recognition = recognise(part, world.knowledge.catalogue, world.perception);
  design.sigma = awareness::build_sigma(world.knowledge.catalogue, world.perception, design.recognition);
  spec::Composition parts;
  parts.name = part.name.text;
  parts.initial_states = world.initial_states;
  add_perception(scenario.perception, world.perception, parts);
  add_recognition(world, design.recognition, parts);
  add_bindings(scenario, world, design.recognition, parts);
  for (const WrittenFormula& assumed : scenario.assumptions)
    parts.assumptions.push_back({world.perception.over_inputs(assumed.formula), assumed.text, {}});
  for (const WrittenFormula& wanted : scenario.guarantees)
    parts.guarantees.push_back({world.perception.over_inputs(wanted.formula), wanted.text, {}});
  design.composed = spec::compose(world.plant, parts);
  return design;
}

std::optional<spec::Gr1> without_perception_assumptions(const spec::Gr1& spec) {
  spec::Gr1 free = spec;
  std::size_t dropped = 0;
  for (auto* part : {&free.env_init, &free.env_safety, &free.env_justice})
    dropped +=
        std::erase_if(*part, [](const spec::Clause& c) { return c.origin == spec::Origin::Perception; });
  if (dropped == 0) return std::nullopt;
  return free;
}

Synthesized synthesize(const Design& design, Violation on_violation, util::Budget& budget) {
  const spec::Gr1& whole = design.composed.spec;
  Synthesized done;
  if (on_violation == Violation::Drop) {
    if (const auto free = without_perception_assumptions(whole)) {
      done.result = strategy::synthesize(*free, budget);
      if (done.result.realizable) {
        done.assumptions_dropped = true;
        done.result.machine->assumptions = perception_assumptions(*free);
        done.result.machine->notes.emplace_back(
            "keeps its guarantees without the assumptions on perception: every observation has an answer");
        done.verdict = check::verify(*done.result.machine, *free, budget);
        if (!done.verdict->verified) return done;
      }
    }
  }
  if (!done.assumptions_dropped) {
    strategy::Options options;
    if (on_violation != Violation::Undefined) options.on_violation = strategy::OnViolation::Latch;
    done.result = strategy::synthesize(whole, budget, options);
    if (!done.result.realizable) return done;
    done.result.machine->assumptions = perception_assumptions(whole);
  }
  done.result.machine->name = whole.name;
  done.verdict = check::verify(*done.result.machine, whole, budget);
  return done;
}

}  // namespace heed::job
