#include "evidence.h"
#include "evidence_controllers.h"

#include <heed/awareness/glimpse.h>
#include <heed/job/controller.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::cli {
namespace {

using awareness::Approach;
using awareness::Catalogue;

/// More candidates than these are counted, not named.
constexpr std::size_t named = 6;

std::string names(const std::vector<std::size_t>& entities, const Catalogue& catalogue) {
  if (entities.empty()) return "nothing in the catalogue";
  if (entities.size() > named) return fmt::format("{} candidates", entities.size());
  std::string out;
  for (const std::size_t e : entities) out += (out.empty() ? "" : ", ") + catalogue.entities[e].label;
  return out;
}

std::string acts(const std::vector<std::size_t>& behaviours, const Catalogue& catalogue) {
  std::string out;
  for (const std::size_t b : behaviours) out += (out.empty() ? "" : ", ") + catalogue.behaviours[b].label;
  return out.empty() ? "nothing is certain" : out;
}

std::string evidence_text(const Approach& approach) {
  if (approach.evidence.empty())
    return approach.evidence_complete ? "    never recognised\n"
                                      : "    recognised; the evidence is not listed\n";
  std::string out;
  for (const awareness::Evidence& evidence : approach.evidence)
    out += fmt::format("    recognised by {}\n", fmt::join(evidence.atoms, " & "));
  if (!approach.evidence_complete) out += "    ... and more\n";
  return out;
}

std::string until(const Approach::Confusion& confusion, const awareness::Perception& perception) {
  std::string out;
  for (const std::size_t f : confusion.until) out += (out.empty() ? "" : " or ") + perception.feature_atom[f];
  if (!out.empty()) return "until " + out;
  return confusion.ever ? "until all its features are seen" : "for ever";
}

std::string confusion_text(const Approach& approach, const Catalogue& catalogue,
                           const awareness::Perception& perception) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  for (const Approach::Confusion& confusion : approach.confusions) {
    const std::string when = until(confusion, perception);
    auto place = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == when; });
    if (place == groups.end()) place = groups.insert(groups.end(), {when, {}});
    place->second.push_back(confusion.with);
  }
  std::string out;
  for (const auto& [when, others] : groups)
    out += fmt::format("    confused with {} {}\n", names(others, catalogue), when);
  return out;
}

std::string approach_text(const Approach& approach, const Catalogue& catalogue,
                          const awareness::Perception& perception) {
  const awareness::Entity& entity = catalogue.entities[approach.entity];
  std::string out = fmt::format("  {} ({})\n", entity.label, entity.atom);
  out += evidence_text(approach) + confusion_text(approach, catalogue, perception);
  for (const Approach::Glimpse& glimpse : approach.glimpses)
    out += fmt::format("    meanwhile, on {} alone: {} ({})\n", perception.feature_atom[glimpse.feature],
                       acts(glimpse.common, catalogue), names(glimpse.candidates, catalogue));
  return out;
}

template <class List>
Json atoms(const std::vector<std::size_t>& indices, const List& list) {
  Json out = Json::array();
  for (const std::size_t i : indices) out.push_back(list[i].atom);
  return out;
}

Json approach_json(const Approach& approach, const Catalogue& catalogue) {
  Json out;
  out["atom"] = catalogue.entities[approach.entity].atom;
  out["complete"] = approach.evidence_complete;
  out["evidence"] = Json::array();
  for (const awareness::Evidence& evidence : approach.evidence) {
    Json one;
    one["atoms"] = evidence.atoms;
    one["axioms"] = Json::array();
    for (const owl::AxiomId id : evidence.axioms) one["axioms"].push_back(owl::to_string(id));
    out["evidence"].push_back(std::move(one));
  }
  out["confused"] = Json::array();
  for (const Approach::Confusion& confusion : approach.confusions)
    out["confused"].push_back({{"with", catalogue.entities[confusion.with].atom},
                               {"until", atoms(confusion.until, catalogue.features)},
                               {"ever", confusion.ever}});
  out["meanwhile"] = Json::array();
  for (const Approach::Glimpse& glimpse : approach.glimpses)
    out["meanwhile"].push_back({{"seen", catalogue.features[glimpse.feature].atom},
                                {"candidates", atoms(glimpse.candidates, catalogue.entities)},
                                {"common", atoms(glimpse.common, catalogue.behaviours)}});
  return out;
}

}  // namespace

EvidenceView evidence_view(const job::Knowledge& knowledge, const job::Scenario* scenario, bool closed) {
  const Catalogue& catalogue = knowledge.catalogue;
  const auto perception = job::perceive(scenario ? scenario->perception : job::PerceptionPart{}, catalogue);
  awareness::PolicyOptions options;
  options.kind = awareness::PolicyOptions::Kind::Identifying;
  options.closed = closed;
  const auto recognition = awareness::compile_policy(catalogue, perception, options);
  const ControllerEvidence controllers(catalogue, perception, scenario);
  EvidenceView view{fmt::format("\nEvidence ({})\n", recognition.words), Json::array()};
  for (const Approach& approach : awareness::approaches(catalogue, perception, recognition, closed)) {
    view.text += approach_text(approach, catalogue, perception);
    view.json.push_back(approach_json(approach, catalogue));
    if (!scenario) continue;
    view.text += controllers.text(approach);
    view.json.back()["controllers"] = controllers.json(approach);
  }
  return view;
}

}  // namespace heed::cli
