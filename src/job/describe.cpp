#include "describe.h"

#include "defeat.h"

#include <heed/awareness/explain.h>
#include <heed/logic/parse.h>
#include <heed/owl/ontology.h>
#include <heed/spec/print.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::job {
namespace {

std::vector<report::Axiom> describe_axioms(const awareness::Catalogue& catalogue,
                                           const std::vector<owl::AxiomId>& ids) {
  std::vector<report::Axiom> axioms;
  for (auto& axiom : awareness::axiom_texts(catalogue, ids))
    axioms.push_back({owl::to_string(axiom.id), std::move(axiom.text), axiom.location});
  return axioms;
}

std::vector<std::string> axiom_names(const std::vector<owl::AxiomId>& ids) {
  std::vector<std::string> names;
  for (const owl::AxiomId id : ids) names.push_back(owl::to_string(id));
  return names;
}

report::SpecificationSection section(std::string name, std::string title,
                                     const std::vector<spec::Clause>& clauses) {
  report::SpecificationSection section{std::move(name), std::move(title), {}};
  for (const spec::Clause& clause : clauses)
    section.clauses.push_back(
        {logic::to_string(clause.formula), spec::to_string(clause.origin), clause.axioms});
  return section;
}

report::SpecificationSection definitions(const spec::Gr1& spec) {
  report::SpecificationSection section{"definitions", "Derived symbols: definitions, chosen by nobody", {}};
  for (const spec::Memory& memory : spec.memories)
    if (memory.role == model::OutputRole::Memory)
      section.clauses.push_back(
          {fmt::format("{}' <-> {}", memory.variable.name, logic::to_string(memory.update)),
           "knowledge",
           {}});
  for (const spec::Definition& definition : spec.definitions)
    section.clauses.push_back(
        {fmt::format("{} <-> {}", definition.name, logic::to_string(definition.formula)), "knowledge",
         definition.axioms});
  return section;
}

bool among(const awareness::Catalogue& catalogue, std::size_t entity, const std::vector<Word>& behaviours) {
  return std::any_of(behaviours.begin(), behaviours.end(), [&](const Word& word) {
    return catalogue.prescribes(entity, catalogue.behaviour(awareness::Name(word.text, word.location))) !=
           nullptr;
  });
}

}  // namespace

report::Number number(const sim::Rational& value) {
  return number(sim::known(value));
}

report::Number number(const sim::Figure& figure) {
  constexpr std::size_t most_characters = 200;
  std::string exact = figure.exact ? sim::fraction(*figure.exact) : std::string();
  if (!figure.exact || exact.size() > most_characters) return {"", figure.value, figure.error};
  return {std::move(exact), figure.value, 0};
}

std::string describe_road(const World& world, const RoadPart& road) {
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  std::string out;
  for (const auto& place : road.places)
    for (const RoadShare& share : place) {
      std::string thing = share.thing.text == "none" ? "nothing" : "any one of the catalogue";
      if (share.thing.text != "none" && share.thing.text != "any")
        thing = catalogue.entities[catalogue.entity(awareness::Name(share.thing.text, share.thing.location))]
                    .label;
      out += (out.empty() ? "" : ", ") + thing;
      if (place.size() > 1) out += " with probability " + sim::fraction(share.probability);
    }
  return out;
}

report::Ontology describe_ontology(const Scenario& scenario, const World& world,
                                   const std::vector<const Design*>& designs) {
  const owl::Ontology& ontology = world.knowledge.ontology;
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  report::Ontology out;
  out.iri = std::string(ontology.iri());
  out.file = scenario.knowledge.ontology.text;
  out.axioms = ontology.axioms().size();
  out.classes = ontology.entities(owl::EntityKind::Class).size();
  out.properties = ontology.entities(owl::EntityKind::ObjectProperty).size() +
                   ontology.entities(owl::EntityKind::DataProperty).size();
  out.individuals = ontology.entities(owl::EntityKind::NamedIndividual).size();
  out.entities = catalogue.entities.size();
  out.features = catalogue.features.size();
  out.behaviours = catalogue.behaviours.size();
  std::set<owl::AxiomId> used;
  for (const Design* design : designs)
    for (const awareness::SigmaFormula& formula : design->sigma)
      used.insert(formula.axioms.begin(), formula.axioms.end());
  out.excerpt = describe_axioms(catalogue, {used.begin(), used.end()});
  return out;
}

std::vector<report::KnowledgeFormula> describe_sigma(const World& world, const Design& design) {
  std::vector<report::KnowledgeFormula> out;
  for (const awareness::SigmaFormula& formula : design.sigma)
    out.push_back({formula.id, std::string(awareness::to_string(formula.kind)),
                   logic::to_string(formula.formula, logic::Notation::Textbook), formula.sentence,
                   describe_axioms(world.knowledge.catalogue, formula.axioms)});
  return out;
}

std::vector<report::SpecificationSection> describe_specification(const spec::Gr1& spec) {
  std::vector<report::SpecificationSection> sections;
  sections.push_back(definitions(spec));
  sections.push_back(section("env_init", "Assumed at the start", spec.env_init));
  sections.push_back(section("env_safety", "Assumed at every step", spec.env_safety));
  sections.push_back(section("env_justice", "Assumed infinitely often", spec.env_justice));
  sections.push_back(section("sys_init", "Guaranteed at the start", spec.sys_init));
  sections.push_back(section("sys_safety", "Guaranteed at every step", spec.sys_safety));
  sections.push_back(section("sys_justice", "Guaranteed infinitely often", spec.sys_justice));
  std::erase_if(sections, [](const auto& s) { return s.clauses.empty(); });
  return sections;
}

report::Controller describe_controller(const World& world, const ControllerPart& part, const Design& design,
                                       const Synthesized& done) {
  report::Controller out;
  out.name = part.name.text;
  out.title = part.title;
  out.policy = design.recognition.words;
  out.beside = part.beside;
  for (const auto& entity : design.recognition.entities)
    for (const awareness::Evidence& evidence : entity.evidence)
      out.evidence.push_back({evidence.atoms, entity.name, axiom_names(evidence.axioms)});
  out.relies_on_broken_justice = done.result.relies_on_broken_justice;
  if (!done.result.realizable) {
    out.verdict = report::Verdict::Unrealizable;
    if (done.result.counter) out.reasons = describe_defeat(world, *done.result.counter);
    return out;
  }
  out.states = done.result.machine->state_count();
  out.transitions = done.result.machine->transitions.size();
  out.states_before_minimisation = done.result.statistics.states_before_minimisation;
  out.assumptions = done.result.machine->assumptions;
  out.notes = done.result.machine->notes;
  out.verdict = done.verdict->verified ? report::Verdict::Verified : report::Verdict::Refuted;
  out.product_states = done.verdict->product_states;
  out.product_edges = done.verdict->product_edges;
  for (const check::Refutation& refutation : done.verdict->refutations)
    out.reasons.push_back(fmt::format("{} ({})", refutation.message, refutation.clause));
  return out;
}

report::CatalogueEntry describe_entity(const Scenario& scenario, const World& world, std::size_t index) {
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  const awareness::Entity& entity = catalogue.entities[index];
  report::CatalogueEntry out;
  out.name = entity.atom;
  out.label = entity.label;
  if (!entity.parents.empty()) out.group = catalogue.entities[entity.parents.front().index].label;
  for (const awareness::Entailed& feature : catalogue.described(index))
    out.features.push_back(catalogue.features[feature.index].label);
  for (const awareness::Entailed& behaviour : entity.behaviours)
    out.behaviours.push_back(catalogue.behaviours[behaviour.index].label);
  out.prescribes_halt = among(catalogue, index, scenario.evaluate->must_react);
  out.prescribes_give_way = among(catalogue, index, scenario.evaluate->may_react) && !out.prescribes_halt;
  return out;
}

}  // namespace heed::job
