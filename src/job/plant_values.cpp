#include "plant_values.h"

#include <heed/logic/parse.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace heed::job {
namespace {

std::vector<logic::Formula> formulas_of(const Scenario& scenario) {
  std::vector<logic::Formula> formulas;
  const auto add = [&](const std::vector<WrittenFormula>& list) {
    for (const WrittenFormula& written : list) formulas.push_back(written.formula);
  };
  if (scenario.perception.persistent) formulas.push_back(scenario.perception.persistent->formula);
  add(scenario.perception.assume);
  add(scenario.assumptions);
  add(scenario.guarantees);
  for (const BindingPart& binding : scenario.bindings) formulas.push_back(binding.effect.formula);
  if (!scenario.evaluate) return formulas;
  formulas.push_back(scenario.evaluate->event.formula);
  for (const OutcomePart& outcome : scenario.evaluate->outcomes)
    if (outcome.when) formulas.push_back(outcome.when->formula);
  return formulas;
}

const logic::Formula& without_next(const logic::Formula& term) {
  const logic::Formula* at = &term;
  while (at->op() == logic::Op::Next) at = &(*at)[0];
  return *at;
}

/// The values of the plant when \p equation sets them equal to a number that is none of them.
const std::vector<std::int32_t>* missed(const logic::Formula& equation, const model::Fts& plant) {
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const logic::Formula &name = without_next(equation[side]), &number = equation[1 - side];
    if (name.op() != logic::Op::Name || number.op() != logic::Op::Number) continue;
    for (const auto& [value, codes] : plant.values)
      if (value == name.name() && std::find(codes.begin(), codes.end(), number.number()) == codes.end())
        return &codes;
  }
  return nullptr;
}

}  // namespace

util::Diagnostics impossible_values(const Scenario& scenario, const model::Fts& plant) {
  util::Diagnostics found;
  for (const logic::Formula& formula : formulas_of(scenario))
    for (const logic::Formula& node : logic::postorder(formula)) {
      if (node.op() != logic::Op::Eq) continue;
      const auto* values = missed(node, plant);
      if (values == nullptr) continue;
      const std::set<std::int32_t> known(values->begin(), values->end());
      found.push_back({util::Severity::Warning,
                       node.location(),
                       "never-true",
                       fmt::format("no state of the plant has '{}'", logic::to_string(node)),
                       fmt::format("the values there are: {}", fmt::join(known, ", ")),
                       {}});
    }
  return found;
}

}  // namespace heed::job
