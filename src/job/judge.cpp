// What a safety engineer should know of a scenario before anything is played.
#include <heed/job/controller.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::job {
namespace {

using awareness::Catalogue;
using awareness::Entailed;

/// That some entity prescribes \p behaviour, by the fewest axioms.
const Entailed* prescribed_by(const Catalogue& catalogue, std::size_t behaviour) {
  const Entailed* best = nullptr;
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e) {
    const Entailed* act = catalogue.entities[e].satisfiable ? catalogue.prescribes(e, behaviour) : nullptr;
    if (act != nullptr && (best == nullptr || act->axioms.size() < best->axioms.size())) best = act;
  }
  return best;
}

/// Prescribed, and neither bound nor a special way of what is.
void warn_unbound(const Scenario& scenario, Catalogue& catalogue) {
  std::set<std::size_t> bound;
  for (const BindingPart& binding : scenario.bindings)
    bound.insert(catalogue.behaviour({binding.behaviour.text, binding.behaviour.location}));
  std::string names;
  awareness::Warning warning{"unbound-behaviour", ""};
  for (std::size_t b = 0; b < catalogue.behaviours.size(); ++b) {
    const awareness::Behaviour& behaviour = catalogue.behaviours[b];
    const bool done =
        bound.contains(b) || std::any_of(behaviour.general.begin(), behaviour.general.end(),
                                         [&](const Entailed& up) { return bound.contains(up.index); });
    const Entailed* act = done ? nullptr : prescribed_by(catalogue, b);
    if (act == nullptr) continue;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", behaviour.label);
    warning.axioms.insert(warning.axioms.end(), act->axioms.begin(), act->axioms.end());
  }
  if (names.empty()) return;
  std::sort(warning.axioms.begin(), warning.axioms.end());
  warning.axioms.erase(std::unique(warning.axioms.begin(), warning.axioms.end()), warning.axioms.end());
  warning.message = fmt::format(
      "Prescribed, but bound to nothing of the plant: {}. Controllers export it as advice, "
      "and nothing happens.",
      names);
  warning.hint = "bind it to a formula over the plant in [bind], or leave it as advice";
  catalogue.warnings.push_back(std::move(warning));
}

}  // namespace

void judge_scenario(const Scenario& scenario, Knowledge& knowledge, util::Diagnostics& notes) {
  Catalogue& catalogue = knowledge.catalogue;
  try {
    const auto perception = perceive(scenario.perception, catalogue);
    for (awareness::Warning& warning : awareness::judge_perception(catalogue, perception))
      catalogue.warnings.push_back(std::move(warning));
    warn_unbound(scenario, catalogue);
  } catch (const util::InputError& error) {
    notes.push_back(error.diagnostic());
    notes.back().severity = util::Severity::Warning;
  }
}

}  // namespace heed::job
