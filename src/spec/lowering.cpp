#include "lowering.h"

#include <heed/logic/lower.h>
#include <heed/logic/parse.h>
#include <heed/spec/symbols.h>

#include "nodes.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::spec {
namespace {

/// Monitors of one requirement are called prefix + number; no name that is there already begins so.
std::string free_prefix(const std::vector<std::string>& names) {
  for (std::size_t i = 1;; ++i) {
    std::string prefix = fmt::format("memory{}_", i);
    const auto taken = [&prefix](const std::string& name) {
      return name.compare(0, prefix.size(), prefix) == 0;
    };
    if (std::none_of(names.begin(), names.end(), taken)) return prefix;
  }
}

/// match: `action' = go'`, as pushing Next down to names leaves it. result: `action' = go`: a value has no
/// next.
logic::Formula plain_values(const logic::Formula& formula, const Symbols& symbols) {
  const Nodes nodes(formula);
  std::vector<logic::Formula> built;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const logic::Formula& node = nodes[i];
    std::vector<logic::Formula> operands;
    bool changed = false;
    for (std::size_t k = 0; k < node.operands().size(); ++k) {
      operands.push_back(built[nodes.operands(i)[k]]);
      while (is_comparison(node.op()) && operands[k].op() == logic::Op::Next &&
             enumeration_value(node, k, symbols))
        operands[k] = logic::Formula(operands[k][0]);
      changed = changed || operands[k].identity() != node[k].identity();
    }
    built.push_back(changed ? logic::Formula::make(node.op(), std::move(operands), node.location()) : node);
  }
  return built.back();
}

void add_clauses(std::vector<Clause>& part, const std::vector<logic::Formula>& formulas, const Clause& like,
                 const Symbols& symbols) {
  for (const logic::Formula& formula : formulas) {
    if (formula.is_true()) continue;
    Clause clause = like;
    clause.formula = plain_values(formula, symbols);
    part.push_back(std::move(clause));
  }
}

void add(Gr1& spec, const Requirement& requirement, bool environment, Origin origin) {
  logic::LowerOptions options;
  const Symbols symbols(spec);
  options.prefix = free_prefix(symbols.names());
  const logic::Lowered lowered = logic::lower(requirement.formula, options);
  const Clause like{{},
                    origin,
                    requirement.text.empty() ? logic::to_string(requirement.formula) : requirement.text,
                    requirement.axioms};
  add_clauses(environment ? spec.env_init : spec.sys_init, lowered.init, like, symbols);
  add_clauses(environment ? spec.env_safety : spec.sys_safety, lowered.safety, like, symbols);
  add_clauses(environment ? spec.env_justice : spec.sys_justice, lowered.justice, like, symbols);
  for (const logic::Monitor& monitor : lowered.monitors) {
    Memory memory;
    memory.variable = {monitor.name, model::Domain::boolean(), monitor.remembers};
    memory.initial = {monitor.initial ? 1 : 0};
    memory.update = plain_values(monitor.update, symbols);
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
