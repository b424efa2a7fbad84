#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/awareness/explain.h>
#include <heed/job/controller.h>
#include <heed/owl/axiom.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::cli {
namespace {

using awareness::Explanation;

Json to_json(const std::vector<awareness::AxiomText>& axioms) {
  Json out = Json::array();
  for (const awareness::AxiomText& axiom : axioms) {
    Json text;
    text["id"] = owl::to_string(axiom.id);
    text["text"] = axiom.text;
    text["location"] = cli::to_json(axiom.location);
    out.push_back(std::move(text));
  }
  return out;
}

Json to_json(const Explanation& explanation) {
  Json out;
  out["subject"] = explanation.subject;
  out["holds"] = explanation.holds;
  out["steps"] = Json::array();
  for (const awareness::ExplanationStep& step : explanation.steps) {
    Json one;
    one["sentence"] = step.sentence;
    one["axioms"] = to_json(step.axioms);
    if (!step.all.empty()) {
      one["complete"] = step.all_listed;
      one["justifications"] = Json::array();
    }
    for (const awareness::Justification& justification : step.all) {
      Json next;
      next["axioms"] = to_json(justification.axioms);
      if (!justification.derived_from.empty()) next["derived_from"] = justification.derived_from;
      one["justifications"].push_back(std::move(next));
    }
    out["steps"].push_back(std::move(one));
  }
  return out;
}

std::set<std::string> seen_symbols(const Arguments& arguments, const awareness::Perception& perception) {
  std::vector<std::string> known;
  for (const auto& [atom, meaning] : perception.symbols) known.push_back(atom);
  std::set<std::string> seen;
  for (const std::string& list : arguments.texts("--seen")) {
    std::size_t begin = 0;
    while (begin <= list.size()) {
      const std::size_t comma = std::min(list.find(',', begin), list.size());
      if (comma > begin) seen.insert(list.substr(begin, comma - begin));
      begin = comma + 1;
    }
  }
  for (const std::string& word : seen)
    if (std::find(known.begin(), known.end(), word) == known.end() && !word.starts_with("tree_"))
      throw UsageError(fmt::format("--seen: perception reports nothing called '{}'", word),
                       util::suggestion(word, known));
  return seen;
}

/// Which things have a feature, and why.
Explanation explain_feature(const awareness::Catalogue& catalogue, std::size_t feature) {
  Explanation out;
  out.subject = fmt::format("'{}' ({})", catalogue.features[feature].label, catalogue.features[feature].atom);
  for (const awareness::Entity& entity : catalogue.entities)
    for (const awareness::Entailed& has : entity.features)
      if (has.index == feature)
        out.steps.push_back(
            {fmt::format("A '{}' has it.", entity.label), awareness::axiom_texts(catalogue, has.axioms)});
  if (out.steps.empty()) out.steps.push_back({"Nothing in the catalogue has it.", {}});
  return out;
}

/// An entity, behaviour or feature by name; nothing when \p what is none.
std::optional<Explanation> explain_name(const awareness::Catalogue& catalogue, const std::string& what) {
  try {
    return awareness::explain_entity(catalogue, catalogue.entity(what));
  } catch (const util::InputError&) {  // no entity: perhaps a behaviour
  }
  try {
    return awareness::explain_behaviour(catalogue, catalogue.behaviour(what));
  } catch (const util::InputError&) {  // nor that: perhaps a feature
  }
  try {
    return explain_feature(catalogue, catalogue.feature(what));
  } catch (const util::InputError&) {
    return std::nullopt;
  }
}

[[noreturn]] void nothing_called(const awareness::Catalogue& catalogue, const std::string& what) {
  std::vector<std::string> known;
  for (const auto& entity : catalogue.entities) known.push_back(entity.atom);
  for (const auto& behaviour : catalogue.behaviours) known.push_back(behaviour.atom);
  for (const auto& feature : catalogue.features) known.push_back(feature.atom);
  throw UsageError(fmt::format("nothing is called '{}': no entity, behaviour, feature or formula", what),
                   util::suggestion(what, known));
}

/// With --all: every justification of what was explained.
std::vector<Explanation> justified(const Arguments& arguments, const awareness::Catalogue& catalogue,
                                   util::Budget& budget, std::vector<Explanation> explanations) {
  const auto most = arguments.number("--all", 1, 1000);
  if (!most) return explanations;
  dl::Justifier justifier(catalogue.ontology, budget);
  for (Explanation& explanation : explanations)
    awareness::justify_all(catalogue, justifier, static_cast<std::size_t>(*most), explanation);
  return explanations;
}

std::vector<Explanation> explain_warnings(const awareness::Catalogue& catalogue) {
  std::vector<Explanation> all;
  for (const awareness::Warning& warning : catalogue.warnings)
    all.push_back(explain_warning(catalogue, warning));
  return all;
}

/// Why a behaviour is prescribed; where it is not, what is missing for each thing that would prescribe it.
Explanation why_prescribed(const awareness::Catalogue& catalogue, const awareness::Recognition& recognition,
                           std::size_t behaviour, const std::set<std::string>& seen) {
  Explanation out = awareness::explain_reaction(catalogue, recognition, behaviour, seen);
  const awareness::PrescribedBehaviour* known = recognition.find_behaviour(behaviour);
  if (out.holds || known == nullptr) return out;
  for (const std::size_t entity : known->because) {
    out.steps.push_back({fmt::format("'{}' would prescribe it.", catalogue.entities[entity].label), {}});
    for (auto& step : awareness::explain_recognition(catalogue, recognition, entity, seen).steps)
      out.steps.push_back(std::move(step));
  }
  return out;
}

Explanation explain_seen(const awareness::Catalogue& catalogue, const awareness::Recognition& recognition,
                         const std::string& what, const std::set<std::string>& seen) {
  for (std::size_t b = 0; b < catalogue.behaviours.size(); ++b) {
    bool same = false;
    try {
      same = catalogue.behaviour(what) == b;
    } catch (const util::InputError&) {
      break;
    }
    if (same) return why_prescribed(catalogue, recognition, b, seen);
  }
  return awareness::explain_recognition(catalogue, recognition, catalogue.entity(what), seen);
}

/// Within a scenario: formulas of σ and reactions are there to ask for as well.
std::vector<Explanation> explain_in_scenario(const Arguments& arguments, const std::string& what,
                                             util::Budget& budget) {
  const job::Scenario scenario = load_scenario(arguments);
  const job::World world = job::load_world(scenario, arguments.limits(), budget);
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  if (!arguments.json()) print_diagnostics(reading_warnings(world.knowledge));
  std::vector<Explanation> all;
  for (const job::ControllerPart* part : chosen_controllers(arguments, scenario)) {
    const job::Design design = job::design(scenario, world, *part);
    if (arguments.has("--seen")) {
      all.push_back(
          explain_seen(catalogue, design.recognition, what, seen_symbols(arguments, world.perception)));
      all.back().subject = part->name.text + ": " + all.back().subject;
      continue;
    }
    for (const awareness::SigmaFormula& formula : design.sigma)
      if (formula.id == what) {
        all.push_back(awareness::explain_formula(catalogue, formula));
        all.back().subject = part->name.text + ": " + all.back().subject;
      }
  }
  if (!all.empty()) return justified(arguments, catalogue, budget, std::move(all));
  if (auto named = explain_name(catalogue, what))
    return justified(arguments, catalogue, budget, {std::move(*named)});
  nothing_called(catalogue, what);
}

std::vector<Explanation> explain_asked(const Arguments& arguments, util::Budget& budget) {
  const std::string what = arguments.operands().size() > 1 ? arguments.operands()[1] : "";
  if (!what.empty() && is_scenario(arguments.operands().front()))
    return explain_in_scenario(arguments, what, budget);
  if (arguments.has("--seen"))
    throw UsageError("--seen needs a scenario and WHAT", "a scenario says what is perceived");
  util::Diagnostics notes;
  const job::KnowledgePart part = knowledge_part(arguments, budget, notes);
  job::Knowledge knowledge = job::load_knowledge(part, arguments.limits(), budget);
  const awareness::Catalogue& catalogue = knowledge.catalogue;
  if (is_scenario(arguments.operands().front()))
    job::judge_scenario(load_scenario(arguments), knowledge, notes);
  if (!arguments.json()) print_diagnostics(reading_warnings(knowledge));
  if (!arguments.json()) print_diagnostics(notes);
  if (what.empty()) return justified(arguments, catalogue, budget, explain_warnings(catalogue));
  if (auto named = explain_name(catalogue, what))
    return justified(arguments, catalogue, budget, {std::move(*named)});
  nothing_called(catalogue, what);
}

}  // namespace

int explain_command(const Arguments& arguments) {
  util::Budget budget(arguments.limits());
  (void)arguments.number("--all", 1, 1000);  // a wrong number is said before the work
  const std::vector<Explanation> all = explain_asked(arguments, budget);
  if (arguments.json()) {
    Json out;
    out["explanations"] = Json::array();
    for (const Explanation& explanation : all) out["explanations"].push_back(to_json(explanation));
    print_json(out);
    return 0;
  }
  if (all.empty()) print("No warnings.\n");
  for (const Explanation& explanation : all) print(awareness::to_text(explanation));
  return 0;
}

}  // namespace heed::cli
