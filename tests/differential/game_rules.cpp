#include "game_reference.h"

#include <algorithm>

namespace heed::reference {
namespace {

using Choices = std::vector<std::pair<std::string, std::vector<std::int64_t>>>;

std::vector<Values> all_values(const Choices& variables) {
  std::vector<Values> result{{}};
  for (const auto& [name, codes] : variables) {
    std::vector<Values> longer;
    for (const Values& values : result)
      for (const std::int64_t code : codes) {
        longer.push_back(values);
        longer.back()[name] = code;
      }
    result = std::move(longer);
  }
  return result;
}

std::vector<std::int64_t> codes(const model::Domain& domain) {
  std::vector<std::int64_t> result;
  for (std::int64_t code = domain.low; code <= domain.high; ++code) result.push_back(code);
  return result;
}

Values joined(Values a, const Values& b) {
  a.insert(b.begin(), b.end());
  return a;
}

bool has_next(const logic::Formula& formula) {
  if (formula.op() == logic::Op::Next) return true;
  return std::any_of(formula.operands().begin(), formula.operands().end(),
                     [](const auto& f) { return has_next(f); });
}

}  // namespace

Rules::Rules(const spec::Gr1& spec) : spec_(spec), evaluator_(spec) {
  Choices inputs, outputs, memories;
  for (const auto& v : spec.inputs) inputs.emplace_back(v.name, codes(v.domain));
  for (const auto& v : spec.outputs) outputs.emplace_back(v.variable.name, codes(v.variable.domain));
  for (const auto& m : spec.memories)
    memories.emplace_back(m.variable.name, std::vector<std::int64_t>(m.initial.begin(), m.initial.end()));
  inputs_ = all_values(inputs);
  outputs_ = all_values(outputs);
  memories_ = all_values(memories);
  for (const auto& clause : spec.env_safety)
    (has_next(clause.formula) || mentions_outputs(clause.formula) ? steps_ : always_).push_back(clause);
}

bool Rules::mentions_outputs(const logic::Formula& formula) const {
  if (formula.op() == logic::Op::Name) {
    for (const auto& output : spec_.outputs)
      if (output.variable.name == formula.name()) return true;
    for (const auto& definition : spec_.definitions)
      if (definition.name == formula.name()) return mentions_outputs(definition.formula);
  }
  return std::any_of(formula.operands().begin(), formula.operands().end(),
                     [this](const auto& f) { return mentions_outputs(f); });
}

bool Rules::environment_keeps(const Values& state) const {
  return evaluator_.holds(always_, state);
}

bool Rules::legal_first(const Values& input) const {
  if (!evaluator_.holds(spec_.env_init, joined(joined(input, memories_.front()), outputs_.front())))
    return false;
  return std::any_of(memories_.begin(), memories_.end(), [&](const Values& m) {
    return environment_keeps(joined(joined(input, m), outputs_.front()));
  });
}

bool Rules::good_first(const Values& state) const {
  if (!environment_keeps(state) || !evaluator_.holds(spec_.sys_init, state)) return false;
  return std::all_of(spec_.sys_safety.begin(), spec_.sys_safety.end(), [&](const auto& clause) {
    return has_next(clause.formula) || evaluator_.holds(clause.formula, state);
  });
}

bool Rules::legal(const Values& state, const Values& input) const {
  const Values next = joined(input, evaluator_.memories(state, input));
  return evaluator_.holds(steps_, state, next) && environment_keeps(joined(next, outputs_.front()));
}

Values Rules::after(const Values& state, const Values& input, const Values& output) const {
  return joined(joined(input, evaluator_.memories(state, input)), output);
}

bool Rules::good(const Values& state, const Values& next) const {
  return std::all_of(spec_.sys_safety.begin(), spec_.sys_safety.end(), [&](const auto& clause) {
    return has_next(clause.formula) ? evaluator_.holds(clause.formula, state, next)
                                    : evaluator_.holds(clause.formula, next);
  });
}

Counters advance(const Rules& rules, Counters counters, const Values& state, const Values& next) {
  const auto move = [&](std::size_t at, const std::vector<spec::Clause>& clauses, bool& through) {
    through = clauses.empty() ||
              (rules.evaluator().holds(clauses[at].formula, state, next) && at + 1 == clauses.size());
    if (clauses.empty()) return at;
    return rules.evaluator().holds(clauses[at].formula, state, next) ? (at + 1) % clauses.size() : at;
  };
  bool env = false;
  bool sys = false;
  Counters result;
  result.env = move(counters.env, rules.spec().env_justice, env);
  result.sys = move(counters.sys, rules.spec().sys_justice, sys);
  result.colour = sys ? 2 : env ? 1 : 0;
  return result;
}

}  // namespace heed::reference
