#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/job/clashes.h>
#include <heed/job/controller.h>
#include <heed/logic/parse.h>
#include <heed/owl/axiom.h>
#include <heed/spec/print.h>
#include <heed/spec/text.h>

#include <fmt/format.h>

namespace heed::cli {
namespace {

std::string axiom_list(const std::vector<owl::AxiomId>& axioms) {
  std::string out;
  for (const owl::AxiomId id : axioms) out += (out.empty() ? "" : ", ") + owl::to_string(id);
  return out;
}

std::string sigma_text(const std::vector<awareness::SigmaFormula>& sigma, logic::Notation notation) {
  std::string out;
  for (const awareness::SigmaFormula& formula : sigma)
    out += fmt::format("{:<5} {}\n      {}{}{}\n", formula.id, logic::to_string(formula.formula, notation),
                       formula.sentence,
                       formula.axioms.empty() ? "" : " From " + axiom_list(formula.axioms) + ".",
                       formula.inherited ? " (inherited)" : "");
  return out;
}

Json sigma_json(const std::vector<awareness::SigmaFormula>& sigma) {
  Json out = Json::array();
  for (const awareness::SigmaFormula& formula : sigma) {
    Json one;
    one["id"] = formula.id;
    one["kind"] = std::string(awareness::to_string(formula.kind));
    one["formula"] = logic::to_string(formula.formula, logic::Notation::Textbook);
    one["sentence"] = formula.sentence;
    one["inherited"] = formula.inherited;
    one["axioms"] = Json::array();
    for (const owl::AxiomId id : formula.axioms) one["axioms"].push_back(owl::to_string(id));
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace

int spec_command(const Arguments& arguments) {
  util::Budget budget(arguments.limits());
  const job::Scenario scenario = load_scenario(arguments);
  const job::World world = job::load_world(scenario, arguments.limits(), budget);
  const auto chosen = chosen_controllers(arguments, scenario);
  if (arguments.has("--gr1") && chosen.size() != 1)
    throw UsageError("--gr1 prints one specification", "choose it with --controller NAME");
  const auto notation = arguments.has("--unicode") ? logic::Notation::Unicode : logic::Notation::Textbook;
  Json documents = Json::array();
  for (const job::ControllerPart* part : chosen) {
    job::Design design = job::design(scenario, world, *part);
    for (util::Diagnostic& note : job::settle_clashes(scenario, world, design, budget))
      design.composed.notes.push_back(std::move(note));
    if (arguments.json()) {
      Json one;
      one["controller"] = part->name.text;
      one["policy"] = design.recognition.words;
      one["sigma"] = sigma_json(design.sigma);
      one["gr1"] = spec::write_gr1(design.composed.spec);
      documents.push_back(std::move(one));
      continue;
    }
    if (arguments.has("--gr1")) {
      print(spec::write_gr1(design.composed.spec));
      continue;
    }
    print(fmt::format("# {}: {}\n\nKnowledge base in LTL\n{}\n", part->name.text, design.recognition.words,
                      sigma_text(design.sigma, notation)));
    if (!arguments.has("--sigma")) print("What is played\n" + spec::listing(design.composed.spec) + '\n');
    print_diagnostics(design.composed.notes);
  }
  if (arguments.json()) {
    Json out;
    out["specifications"] = std::move(documents);
    print_json(out);
  }
  return 0;
}

}  // namespace heed::cli
