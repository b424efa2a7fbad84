#include <heed/spec/structured_slugs.h>

#include "infix_write.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

bool fits(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

/// slugs' compiler knows sums of variables and numbers, and no negative numbers.
bool has_words_for(const Formula& comparison) {
  for (const Formula& node : logic::postorder(comparison))
    if (node.op() == Op::Sub || node.op() == Op::Mul || (node.op() == Op::Number && node.number() < 0))
      return false;
  return true;
}

bool is_negative(const model::Variable& variable) {
  return variable.domain.low < 0;
}

void write_variables(std::string& out, const std::vector<model::Variable>& variables,
                     const TargetNames& names) {
  for (const auto& variable : variables) {
    out += names[variable.name];
    if (variable.domain.kind != model::Domain::Kind::Boolean)
      out += fmt::format(":{}...{}", variable.domain.low, variable.domain.high);
    out += "\n";
  }
}

}  // namespace

std::string write_structured_slugs(const Gr1& spec) {
  Portable plain = portable(spec, "structuredslugs");
  const bool negative = std::any_of(plain.inputs.begin(), plain.inputs.end(), is_negative) ||
                        std::any_of(plain.outputs.begin(), plain.outputs.end(), is_negative);
  if (negative || !all_comparisons(plain, has_words_for))
    plain = in_bits(plain,
                    [](const model::Variable& v, std::size_t i) { return fmt::format("{}.{}", v.name, i); });
  const TargetNames names(
      plain, fits, {"X", "F", "G", "U", "W", "TRUE", "FALSE", "next", "LEASTSIGNIFICANTBITOVERWRITES"});
  std::string out = "[INPUT]\n";
  write_variables(out, plain.inputs, names);
  out += "\n[OUTPUT]\n";
  write_variables(out, plain.outputs, names);
  constexpr const char* sections[] = {"ENV_INIT", "ENV_TRANS", "ENV_LIVENESS",
                                      "SYS_INIT", "SYS_TRANS", "SYS_LIVENESS"};
  const auto lists = formula_lists(plain);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    insist_on_small(*lists[i], "structuredslugs");
    if (!lists[i]->empty()) out += fmt::format("\n[{}]\n", sections[i]);
    for (const Formula& formula : *lists[i]) out += infix(formula, names, "TRUE", "FALSE") + "\n";
  }
  return out;
}

}  // namespace heed::spec
