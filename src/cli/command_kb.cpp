#include "commands.h"
#include "evidence.h"
#include "inputs.h"
#include "left_out.h"
#include "output.h"
#include "second_opinion.h"

#include <heed/awareness/explain.h>
#include <heed/job/knowledge.h>
#include <heed/owl/axiom.h>

#include <fmt/format.h>

#include <set>

namespace heed::cli {
namespace {

using awareness::Catalogue;
using awareness::Entailed;
using awareness::Entity;

template <class List>
std::string labels(const std::vector<Entailed>& entailed, const List& list) {
  std::string out;
  for (const Entailed& item : entailed) out += (out.empty() ? "" : ", ") + list[item.index].label;
  return out;
}

std::string described(const Catalogue& catalogue, std::size_t entity) {
  std::string out;
  for (const Entailed& item : catalogue.described(entity)) {
    const awareness::Feature& feature = catalogue.features[item.index];
    if (feature.entity) continue;  // that it is a sign is what the hierarchy shows
    out += (out.empty() ? "" : ", ") + feature.label;
  }
  return out;
}

/// Behaviours that are not merely what a special one entails.
std::string prescribed(const Catalogue& catalogue, const Entity& entity) {
  std::set<std::size_t> general;
  for (const Entailed& item : entity.behaviours)
    for (const Entailed& above : catalogue.behaviours[item.index].general) general.insert(above.index);
  std::string out;
  for (const Entailed& item : entity.behaviours)
    if (!general.contains(item.index))
      out += (out.empty() ? "" : ", ") + catalogue.behaviours[item.index].label;
  return out;
}

std::string entity_line(const Catalogue& catalogue, std::size_t index, std::size_t depth) {
  const Entity& entity = catalogue.entities[index];
  std::string line = fmt::format("{:{}}{} ({})", "", 2 * depth, entity.label, entity.atom);
  if (!entity.satisfiable) return line + ": cannot exist\n";
  if (const std::string features = described(catalogue, index); !features.empty()) line += ": " + features;
  if (const std::string behaviours = prescribed(catalogue, entity); !behaviours.empty())
    line += " -> " + behaviours;
  return line + '\n';
}

std::string hierarchy(const Catalogue& catalogue) {
  std::string out;
  std::vector<std::pair<std::size_t, std::size_t>> open;  // (entity, depth), last first
  std::set<std::size_t> shown;
  for (std::size_t e = catalogue.entities.size(); e-- > 0;)
    if (catalogue.entities[e].parents.empty()) open.emplace_back(e, 0);
  while (!open.empty()) {
    const auto [entity, depth] = open.back();
    open.pop_back();
    if (!shown.insert(entity).second) continue;
    out += entity_line(catalogue, entity, depth);
    const auto& children = catalogue.entities[entity].children;
    for (std::size_t c = children.size(); c-- > 0;) open.emplace_back(children[c], depth + 1);
  }
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e)  // equivalent ones are each other's parents
    if (!shown.contains(e)) out += entity_line(catalogue, e, 0);
  return out;
}

std::string feature_list(const Catalogue& catalogue) {
  std::string out;
  for (const awareness::Feature& feature : catalogue.features) {
    if (feature.entity) continue;
    out += fmt::format("  {} ({}){}\n", feature.label, feature.atom,
                       feature.functional.empty() ? "" : ": excludes other values of " + feature.role_atom);
  }
  return out;
}

std::string warning_text(const Catalogue& catalogue, const awareness::Warning& warning) {
  std::string out = fmt::format("- {} [{}]\n", warning.message, warning.code);
  for (const auto& axiom : awareness::axiom_texts(catalogue, warning.axioms))
    out += fmt::format("    {} {} ({})\n", owl::to_string(axiom.id), axiom.text,
                       util::to_string(axiom.location));
  if (!warning.hint.empty()) out += fmt::format("    hint: {}\n", warning.hint);
  return out;
}

std::string text(const job::Knowledge& knowledge, bool only_warnings) {
  const Catalogue& catalogue = knowledge.catalogue;
  std::string out;
  if (!only_warnings) {
    out += fmt::format(
        "{} axioms, {} entities, {} features, {} behaviours\n\nEntities: what they look like -> what they "
        "prescribe\n",
        knowledge.ontology.axioms().size(), catalogue.entities.size(), catalogue.features.size(),
        catalogue.behaviours.size());
    out += hierarchy(catalogue) + "\nFeatures\n" + feature_list(catalogue) + "\nBehaviours\n";
    for (const awareness::Behaviour& behaviour : catalogue.behaviours)
      out += fmt::format("  {} ({}){}{}\n", behaviour.label, behaviour.atom,
                         behaviour.parents.empty() ? "" : ": a way of ",
                         labels(behaviour.parents, catalogue.behaviours));
    out += '\n';
  }
  out += fmt::format("Warnings: {}\n", catalogue.warnings.size());
  for (const awareness::Warning& warning : catalogue.warnings) out += warning_text(catalogue, warning);
  out += LeftOut(knowledge).text();
  return out;
}

Json ids(const std::vector<owl::AxiomId>& axioms) {
  Json out = Json::array();
  for (const owl::AxiomId id : axioms) out.push_back(owl::to_string(id));
  return out;
}

template <class List>
Json entailed_json(const std::vector<Entailed>& entailed, const List& list) {
  Json out = Json::array();
  for (const Entailed& item : entailed) {
    Json one;
    one["atom"] = list[item.index].atom;
    one["axioms"] = ids(item.axioms);
    out.push_back(std::move(one));
  }
  return out;
}

Json entity_json(const Catalogue& catalogue, std::size_t index) {
  const Entity& entity = catalogue.entities[index];
  Json out;
  out["atom"] = entity.atom;
  out["label"] = entity.label;
  out["iri"] = std::string(catalogue.ontology.text(entity.iri));
  out["location"] = to_json(entity.location);
  out["satisfiable"] = entity.satisfiable;
  out["parents"] = entailed_json(entity.parents, catalogue.entities);
  out["features"] = entailed_json(catalogue.described(index), catalogue.features);
  out["behaviours"] = entailed_json(entity.behaviours, catalogue.behaviours);
  return out;
}

Json document(const job::Knowledge& knowledge) {
  const Catalogue& catalogue = knowledge.catalogue;
  Json out;
  out["axioms"] = knowledge.ontology.axioms().size();
  out["entities"] = Json::array();
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e)
    out["entities"].push_back(entity_json(catalogue, e));
  const LeftOut left_out(knowledge);
  out["left_out"] = left_out.json();
  if (!out["left_out"].empty())
    for (std::size_t e = 0; e < catalogue.entities.size(); ++e)
      out["entities"][e]["left_out"] = left_out.json(e);
  out["features"] = Json::array();
  for (const awareness::Feature& feature : catalogue.features) {
    Json one;
    one["atom"] = feature.atom;
    one["label"] = feature.label;
    one["role"] = feature.role_atom;
    one["functional"] = !feature.functional.empty();
    out["features"].push_back(std::move(one));
  }
  out["behaviours"] = Json::array();
  for (const awareness::Behaviour& behaviour : catalogue.behaviours) {
    Json one;
    one["atom"] = behaviour.atom;
    one["label"] = behaviour.label;
    one["parents"] = entailed_json(behaviour.parents, catalogue.behaviours);
    out["behaviours"].push_back(std::move(one));
  }
  out["warnings"] = Json::array();
  for (const awareness::Warning& warning : catalogue.warnings) {
    Json one;
    one["code"] = warning.code;
    one["message"] = warning.message;
    one["axioms"] = ids(warning.axioms);
    if (!warning.hint.empty()) one["hint"] = warning.hint;
    if (warning.location.line != 0) one["location"] = to_json(warning.location);
    out["warnings"].push_back(std::move(one));
  }
  out["diagnostics"] = to_json(knowledge.diagnostics);
  return out;
}

/// With a scenario, what its perception reports, and closed unless its last identifying controller is open.
EvidenceView evidence_of(const Arguments& arguments, const job::Knowledge& knowledge) {
  if (!is_scenario(arguments.operands().front())) return evidence_view(knowledge, nullptr, true);
  const job::Scenario scenario = load_scenario(arguments);
  bool closed = true;
  for (const job::ControllerPart& part : scenario.controllers)
    if (part.policy.text == "identifying") closed = part.closed;
  return evidence_view(knowledge, &scenario, closed);
}

}  // namespace

int kb_command(const Arguments& arguments) {
  util::Budget budget(arguments.limits());
  util::Diagnostics notes;
  const job::KnowledgePart part = knowledge_part(arguments, budget, notes);
  job::Knowledge knowledge = job::load_knowledge(part, arguments.limits(), budget);
  if (is_scenario(arguments.operands().front()))
    job::judge_scenario(load_scenario(arguments), knowledge, notes);
  const auto second = second_opinion(arguments.text("--reasoner", "own"), knowledge, budget);
  if (arguments.json()) {
    Json out = document(knowledge);
    if (arguments.has("--evidence")) out["evidence"] = evidence_of(arguments, knowledge).json;
    if (second) out["second_opinion"] = second->json;
    out["notes"] = to_json(notes);
    print_json(out);
    return 0;
  }
  for (const util::Diagnostic& diagnostic : knowledge.diagnostics)
    if (diagnostic.severity == util::Severity::Note && diagnostic.code != "not-used")
      notes.push_back(diagnostic);
  print_diagnostics(reading_warnings(knowledge));
  print_diagnostics(notes);
  print(text(knowledge, arguments.has("--quiet")));
  if (second) print(second->text);
  if (arguments.has("--evidence")) print(evidence_of(arguments, knowledge).text);
  return 0;
}

}  // namespace heed::cli
