#include "evidence.h"

#include "told.h"

#include <algorithm>
#include <unordered_map>

namespace heed::awareness {
namespace {

bool within(const Evidence& small, const Evidence& large) {
  return std::includes(large.atoms.begin(), large.atoms.end(), small.atoms.begin(), small.atoms.end());
}

/// Keeps the subset-minimal sets, the smallest first, at most evidence_cap.
void minimise(Rule& rule) {
  std::sort(rule.evidence.begin(), rule.evidence.end(), [](const Evidence& a, const Evidence& b) {
    return a.atoms.size() != b.atoms.size() ? a.atoms.size() < b.atoms.size() : a.atoms < b.atoms;
  });
  std::vector<Evidence> kept;
  for (Evidence& candidate : rule.evidence) {
    if (std::any_of(kept.begin(), kept.end(),
                    [&](const Evidence& small) { return within(small, candidate); }))
      continue;
    if (kept.size() == evidence_cap) {
      rule.complete = false;
      break;
    }
    kept.push_back(std::move(candidate));
  }
  rule.evidence = std::move(kept);
}

Evidence evidence_of(const std::vector<Reason>& parts, const std::vector<std::size_t>& chosen) {
  Evidence evidence;
  for (const std::size_t i : chosen) {
    evidence.atoms.push_back(parts[i].atom);
    evidence.axioms = join(evidence.axioms, parts[i].axioms);
  }
  std::sort(evidence.atoms.begin(), evidence.atoms.end());
  return evidence;
}

/// The next k-subset of 0 ... n-1 in lexicographic order; false after the last.
bool next_subset(std::vector<std::size_t>& chosen, std::size_t n) {
  const std::size_t k = chosen.size();
  for (std::size_t i = k; i-- > 0;)
    if (chosen[i] < n - k + i) {
      ++chosen[i];
      for (std::size_t j = i + 1; j < k; ++j) chosen[j] = chosen[j - 1] + 1;
      return true;
    }
  return false;
}

/// reached[j] after part i: at least j of the parts i ... n-1 hold.
logic::Formula threshold_formula(const std::vector<Reason>& parts, std::size_t k) {
  std::vector<logic::Formula> reached(k + 1, logic::truth(false));
  reached[0] = logic::truth(true);
  for (std::size_t i = parts.size(); i-- > 0;)
    for (std::size_t j = k; j > 0; --j)
      reached[j] = (logic::name(parts[i].atom) && reached[j - 1]) || reached[j];
  return reached[k];
}

bool holds_at(const logic::Formula& node, const std::unordered_map<const void*, bool>& values,
              const std::function<bool(const std::string&)>& holds) {
  const auto value = [&](std::size_t i) { return values.at(node[i].identity()); };
  const auto operands = node.operands();
  const auto is_true = [&](const logic::Formula& f) { return values.at(f.identity()); };
  switch (node.op()) {
    case logic::Op::True:
      return true;
    case logic::Op::Name:
      return holds(node.name());
    case logic::Op::Not:
      return !value(0);
    case logic::Op::And:
      return std::all_of(operands.begin(), operands.end(), is_true);
    case logic::Op::Or:
      return std::any_of(operands.begin(), operands.end(), is_true);
    case logic::Op::Implies:
      return !value(0) || value(1);
    case logic::Op::Iff:
      return value(0) == value(1);
    default:
      return false;
  }
}

}  // namespace

Rule all_rule(const std::vector<Reason>& parts) {
  if (parts.empty()) return {};
  Rule rule;
  std::vector<logic::Formula> atoms;
  Evidence evidence;
  for (const Reason& part : parts) {
    atoms.push_back(logic::name(part.atom));
    evidence.atoms.push_back(part.atom);
    evidence.axioms = join(evidence.axioms, part.axioms);
  }
  std::sort(evidence.atoms.begin(), evidence.atoms.end());
  rule.formula = logic::all_of(std::move(atoms));
  rule.evidence.push_back(std::move(evidence));
  return rule;
}

Rule threshold_rule(const std::vector<Reason>& parts, std::size_t k) {
  if (k == 0 || k > parts.size()) return {};
  Rule rule;
  std::vector<std::size_t> chosen(k);
  for (std::size_t i = 0; i < k; ++i) chosen[i] = i;
  std::vector<logic::Formula> cases;
  do {
    const Evidence evidence = evidence_of(parts, chosen);
    std::vector<logic::Formula> atoms;
    atoms.reserve(chosen.size());
    for (const std::size_t i : chosen) atoms.push_back(logic::name(parts[i].atom));
    cases.push_back(logic::all_of(std::move(atoms)));
    rule.evidence.push_back(evidence);
    rule.complete = !next_subset(chosen, parts.size());
  } while (!rule.complete && rule.evidence.size() < evidence_cap);
  rule.formula = rule.complete ? logic::any_of(std::move(cases)) : threshold_formula(parts, k);
  minimise(rule);
  return rule;
}

Rule either(const Rule& a, const Rule& b) {
  Rule rule{a.formula || b.formula, a.evidence, a.complete && b.complete};
  rule.evidence.insert(rule.evidence.end(), b.evidence.begin(), b.evidence.end());
  minimise(rule);
  return rule;
}

Rule because_of(Rule rule, const std::vector<owl::AxiomId>& axioms) {
  for (Evidence& evidence : rule.evidence) evidence.axioms = join(evidence.axioms, axioms);
  return rule;
}

bool evaluate(const logic::Formula& formula, const std::function<bool(const std::string&)>& holds) {
  std::unordered_map<const void*, bool> values;
  for (const logic::Formula& node : logic::postorder(formula))
    values[node.identity()] = holds_at(node, values, holds);
  return values.at(formula.identity());
}

std::map<std::string, bool> derived_values(const Recognition& recognition,
                                           const std::set<std::string>& seen) {
  std::map<std::string, bool> value;
  const auto settle = [&](const auto& definitions) {
    for (const auto& definition : definitions)
      value[definition.name] = evaluate(definition.formula, [&](const std::string& atom) {
        const auto known = value.find(atom);
        return known != value.end() ? known->second : seen.contains(atom);
      });
  };
  settle(recognition.situations);
  settle(recognition.entities);
  settle(recognition.behaviours);
  return value;
}

}  // namespace heed::awareness
