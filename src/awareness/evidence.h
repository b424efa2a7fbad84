#pragma once

#include <heed/awareness/policy.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace heed::awareness {

/// A monotone rule: its formula, and the minimal sets of atoms that make it true (not all of them when
/// incomplete).
struct Rule {
  logic::Formula formula = logic::truth(false);
  std::vector<Evidence> evidence{};
  bool complete = true;
};

/// One atom with the axioms that make it part of a description.
struct Reason {
  std::string atom;
  std::vector<owl::AxiomId> axioms;
};

[[nodiscard]] Rule all_rule(const std::vector<Reason>& parts);
/// At least \p k of \p parts: a chain of decisions, linear in both, where listing the subsets would be long.
[[nodiscard]] Rule threshold_rule(const std::vector<Reason>& parts, std::size_t k);
[[nodiscard]] Rule either(const Rule& a, const Rule& b);
/// The same evidence with more axioms behind it.
[[nodiscard]] Rule because_of(Rule rule, const std::vector<owl::AxiomId>& axioms);

/// Truth of a formula without temporal operators or comparisons; \p holds gives names.
[[nodiscard]] bool evaluate(const logic::Formula& formula,
                            const std::function<bool(const std::string&)>& holds);

/// Truth of each derived symbol of \p recognition when exactly \p seen (symbols and levels) is true.
[[nodiscard]] std::map<std::string, bool> derived_values(const Recognition& recognition,
                                                         const std::set<std::string>& seen);

}  // namespace heed::awareness
