#include "evidence_controllers.h"

#include <heed/job/controller.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::cli {

using awareness::Approach;

ControllerEvidence::ControllerEvidence(const awareness::Catalogue& catalogue,
                                       const awareness::Perception& perception, const job::Scenario* scenario)
    : catalogue_(catalogue), perception_(perception) {
  if (scenario == nullptr) return;
  for (const job::ControllerPart& part : scenario->controllers)
    controllers_.push_back({part.name.text, job::recognise(part, catalogue, perception)});
  for (const job::BindingPart& binding : scenario->bindings)
    bound_[catalogue.behaviour({binding.behaviour.text, binding.behaviour.location})] = binding.effect.text;
}

std::vector<ControllerEvidence::Sight> ControllerEvidence::sights(const Approach& approach) const {
  std::vector<Sight> result;
  Sight all{"all of it", {}};
  for (const Approach::Glimpse& glimpse : approach.glimpses) {
    const std::string& atom = perception_.feature_atom[glimpse.feature];
    result.push_back({atom, {atom}});
    all.seen.insert(atom);
  }
  if (result.size() > 1) result.push_back(std::move(all));
  if (const std::string& whole = perception_.whole_atom[approach.entity]; !whole.empty())
    result.push_back({whole, {whole}});
  return result;
}

/// Bound ones with what they are to the plant; of the others only what no special one says already.
std::string ControllerEvidence::reaction(const std::vector<std::size_t>& behaviours) const {
  std::string out;
  for (const std::size_t b : behaviours) {
    const auto bound = bound_.find(b);
    const bool said = std::any_of(behaviours.begin(), behaviours.end(), [&](std::size_t c) {
      const auto& general = catalogue_.behaviours[c].general;
      return c != b &&
             std::any_of(general.begin(), general.end(), [&](const auto& up) { return up.index == b; });
    });
    if (said && bound == bound_.end()) continue;
    out += (out.empty() ? "" : ", ") + catalogue_.behaviours[b].label;
    if (bound != bound_.end()) out += fmt::format(" (X {})", bound->second);
  }
  return out.empty() ? "nothing" : out;
}

/// "    'awareness': recognised by red & sign; nothing on sign or red; halt on all of it"
std::string ControllerEvidence::line(const Controller& controller, const Approach& approach) const {
  std::string out;
  if (const auto* rule = controller.recognition.find_entity(approach.entity)) {
    for (const awareness::Evidence& evidence : rule->evidence)
      out += fmt::format("{}{}", out.empty() ? " recognised by " : " or ", fmt::join(evidence.atoms, " & "));
    if (!rule->evidence_complete) out += out.empty() ? " recognised; the evidence is not listed" : " or more";
  }
  if (out.empty()) out = " never recognised";
  std::vector<std::pair<std::string, std::string>> groups;  // what is done, and on what
  for (const Sight& sight : sights(approach)) {
    const std::string does = reaction(awareness::prescribed_under(controller.recognition, sight.seen));
    if (!groups.empty() && groups.back().first == does)
      groups.back().second += " or " + sight.words;
    else
      groups.emplace_back(does, sight.words);
  }
  for (const auto& [does, words] : groups) out += fmt::format("; {} on {}", does, words);
  return fmt::format("    '{}':{}\n", controller.name, out);
}

std::string ControllerEvidence::text(const Approach& approach) const {
  std::string out;
  for (const Controller& controller : controllers_) out += line(controller, approach);
  return out;
}

Json ControllerEvidence::json(const Approach& approach) const {
  Json out = Json::array();
  for (const Controller& controller : controllers_) {
    Json one;
    one["name"] = controller.name;
    one["evidence"] = Json::array();
    if (const auto* rule = controller.recognition.find_entity(approach.entity)) {
      one["complete"] = rule->evidence_complete;
      for (const awareness::Evidence& evidence : rule->evidence) one["evidence"].push_back(evidence.atoms);
    }
    one["reactions"] = Json::array();
    for (const Sight& sight : sights(approach)) {
      Json reaction;
      reaction["seen"] = sight.seen;
      reaction["prescribed"] = Json::array();
      reaction["bound"] = Json::array();
      for (const std::size_t b : awareness::prescribed_under(controller.recognition, sight.seen)) {
        reaction["prescribed"].push_back(catalogue_.behaviours[b].atom);
        if (bound_.contains(b)) reaction["bound"].push_back(catalogue_.behaviours[b].atom);
      }
      one["reactions"].push_back(std::move(reaction));
    }
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace heed::cli
