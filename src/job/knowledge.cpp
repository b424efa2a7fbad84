#include "named_file.h"

#include <heed/awareness/explain.h>
#include <heed/job/knowledge.h>
#include <heed/owl/left_out.h>
#include <heed/owl/print.h>
#include <heed/owl/read.h>

#include <fmt/format.h>

namespace heed::job {
namespace {

std::vector<awareness::Name> names(const std::vector<Word>& words) {
  std::vector<awareness::Name> names;
  for (const Word& word : words) names.emplace_back(word.text, word.location);
  return names;
}

awareness::CatalogueOptions catalogue_options(const KnowledgePart& part) {
  awareness::CatalogueOptions options;
  options.entities = names(part.entities);
  options.features = names(part.features);
  options.behaviours = names(part.behaviours);
  options.feature_roles = names(part.feature_roles);
  options.action_roles = names(part.action_roles);
  if (part.subclass_role)
    options.subclass_role.emplace(part.subclass_role->text, part.subclass_role->location);
  options.sufficient = part.sufficient;
  options.sufficient_entities = names(part.sufficient_entities);
  options.language = part.language;
  return options;
}

/// What the reasoner could not use, as one note per axiom.
void note_incomplete(const dl::Reasoner& reasoner, util::Diagnostics& diagnostics) {
  for (const dl::Dropped& dropped : reasoner.incomplete())
    diagnostics.push_back(
        {util::Severity::Note,
         reasoner.ontology().axiom(dropped.axiom).location,
         "not-used",
         fmt::format("{} is not used in full: {}", owl::to_string(dropped.axiom), dropped.why),
         "what follows from it only may be missing; nothing is invented",
         {}});
}

util::Diagnostic as_diagnostic(const awareness::Catalogue& catalogue, const awareness::Warning& warning) {
  util::Diagnostic diagnostic{util::Severity::Warning, {}, warning.code, warning.message, warning.hint, {}};
  // What is impossible is told at its own place: the axioms behind it may stand anywhere.
  const bool of_thing = warning.code == "unsatisfiable-entity" && !warning.entities.empty();
  if (!warning.axioms.empty() && !of_thing)
    diagnostic.location = catalogue.ontology.axiom(warning.axioms.front()).location;
  else if (!warning.entities.empty())
    diagnostic.location = catalogue.entities[warning.entities.front()].location;
  return diagnostic;
}

}  // namespace

Knowledge load_knowledge(const KnowledgePart& part, const util::Limits& limits, util::Budget& budget) {
  Knowledge knowledge;
  owl::ImportOptions imports;
  imports.mapping = part.imports;
  imports.allow_missing = part.allow_missing_imports;
  knowledge.ontology = named_in_scenario(
      part.ontology, [&] { return owl::load(part.ontology.text, imports, limits, knowledge.diagnostics); });
  knowledge.reasoner = std::make_shared<const dl::Reasoner>(knowledge.ontology, budget);
  note_incomplete(*knowledge.reasoner, knowledge.diagnostics);
  knowledge.catalogue = awareness::build_catalogue(*knowledge.reasoner, catalogue_options(part), budget);
  for (const util::Diagnostic& note : knowledge.catalogue.notes) knowledge.diagnostics.push_back(note);
  for (const awareness::Warning& warning : knowledge.catalogue.warnings)
    knowledge.diagnostics.push_back(as_diagnostic(knowledge.catalogue, warning));
  return knowledge;
}

void refuse_unsatisfiable(const Knowledge& knowledge, const KnowledgePart& part) {
  if (part.allow_unsatisfiable) return;
  for (const awareness::Warning& warning : knowledge.catalogue.warnings) {
    if (warning.code != "unsatisfiable-entity") continue;
    std::string why;
    for (const auto& axiom : awareness::axiom_texts(knowledge.catalogue, warning.axioms))
      why += fmt::format("{}  {} {} ({})", why.empty() ? "because\n" : "\n", owl::to_string(axiom.id),
                         axiom.text, util::to_string(axiom.location));
    util::Diagnostic error = as_diagnostic(knowledge.catalogue, warning);
    error.severity = util::Severity::Error;
    error.excerpt = why;
    error.hint = "mend one of these axioms, or set allow_unsatisfiable = true in [knowledge]";
    throw util::InputError(std::move(error));
  }
}

void refuse_left_out(const Knowledge& knowledge, const KnowledgePart& part) {
  if (part.allow_left_out) return;
  const util::Diagnostic* first = nullptr;
  std::size_t count = 0;
  for (const util::Diagnostic& message : knowledge.diagnostics) {
    if (!owl::leaves_out(message)) continue;
    if (first == nullptr) first = &message;
    ++count;
  }
  if (first == nullptr) return;
  util::Diagnostic error = *first;
  error.severity = util::Severity::Error;
  if (count > 1) error.message += fmt::format(" (and {} more like it)", count - 1);
  error.hint = "a controller would not know of it: mend it, or set allow_left_out = true in [knowledge]";
  throw util::InputError(std::move(error));
}

}  // namespace heed::job
