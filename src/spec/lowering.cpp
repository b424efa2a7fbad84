#include "lowering.h"

#include <heed/logic/lower.h>
#include <heed/logic/parse.h>
#include <heed/spec/symbols.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::spec {
namespace {

/// Monitors of one requirement are called prefix + number; no name that is there already begins so.
std::string free_prefix(const Gr1& spec) {
  const std::vector<std::string> names = Symbols(spec).names();
  for (std::size_t i = 1;; ++i) {
    std::string prefix = fmt::format("memory{}_", i);
    const auto taken = [&prefix](const std::string& name) {
      return name.compare(0, prefix.size(), prefix) == 0;
    };
    if (std::none_of(names.begin(), names.end(), taken)) return prefix;
  }
}

void add_clauses(std::vector<Clause>& part, const std::vector<logic::Formula>& formulas, const Clause& like) {
  for (const logic::Formula& formula : formulas) {
    if (formula.is_true()) continue;
    Clause clause = like;
    clause.formula = formula;
    part.push_back(std::move(clause));
  }
}

void add(Gr1& spec, const Requirement& requirement, bool environment, Origin origin) {
  logic::LowerOptions options;
  options.prefix = free_prefix(spec);
  const logic::Lowered lowered = logic::lower(requirement.formula, options);
  const Clause like{{},
                    origin,
                    requirement.text.empty() ? logic::to_string(requirement.formula) : requirement.text,
                    requirement.axioms};
  add_clauses(environment ? spec.env_init : spec.sys_init, lowered.init, like);
  add_clauses(environment ? spec.env_safety : spec.sys_safety, lowered.safety, like);
  add_clauses(environment ? spec.env_justice : spec.sys_justice, lowered.justice, like);
  for (const logic::Monitor& monitor : lowered.monitors) {
    Memory memory;
    memory.variable = {monitor.name, model::Domain::boolean(), monitor.remembers};
    memory.initial = {monitor.initial ? 1 : 0};
    memory.update = monitor.update;
    memory.comment = monitor.remembers;
    spec.memories.push_back(std::move(memory));
  }
}

}  // namespace

void add_requirements(Gr1& spec, const Requirements& requirements) {
  for (const Requirement& requirement : requirements.assumptions)
    add(spec, requirement, true, requirements.origin);
  for (const Requirement& requirement : requirements.guarantees)
    add(spec, requirement, false, requirements.origin);
}

}  // namespace heed::spec
