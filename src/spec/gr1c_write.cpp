#include <heed/logic/rewrite.h>
#include <heed/spec/gr1c.h>
#include <heed/util/diagnostic.h>

#include "infix_write.h"
#include "peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

bool fits(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

bool has_words_for(const Formula& comparison) {
  const Op left = comparison[0].op(), right = comparison[1].op();
  return (left == Op::Name || left == Op::Next) && right == Op::Number && comparison[1].number() >= 0;
}

/// gr1c knows [0,n], and names the bits of x x0, x1, ...: a name of ours might be one of them.
bool has_words_for(const model::Variable& variable, const std::vector<std::string>& all) {
  if (variable.domain.kind == model::Domain::Kind::Boolean) return true;
  const auto bit = [&](const std::string& name) {
    return name.size() > variable.name.size() && name.starts_with(variable.name) &&
           name.find_first_not_of("0123456789", variable.name.size()) == std::string::npos;
  };
  return variable.domain.low == 0 && std::none_of(all.begin(), all.end(), bit);
}

bool in_bits_only(Portable& spec) {
  std::vector<std::string> all;
  for (const auto* list : {&spec.inputs, &spec.outputs})
    for (const auto& variable : *list) all.push_back(variable.name);
  for (const auto* list : {&spec.inputs, &spec.outputs})
    for (const auto& variable : *list)
      if (!has_words_for(variable, all)) return true;
  return !all_comparisons(spec, [](const Formula& node) { return has_words_for(node); });
}

Formula new_output(Portable& spec, const std::string& wish) {
  std::set<std::string> taken;
  for (const auto* list : {&spec.inputs, &spec.outputs})
    for (const auto& variable : *list) taken.insert(variable.name);
  std::string name = wish;
  for (std::size_t i = 2; taken.contains(name); ++i) name = fmt::format("{}_{}", wish, i);
  spec.outputs.push_back({name, model::Domain::boolean(), {}, {}});
  return logic::name(name);
}

/// gr1c's SYSINIT speaks of outputs only. What ties the first outputs to the first inputs becomes an
/// obligation of the first step, in which the environment is free once it is broken: so it is lost as it
/// should be.
void separate_start(Portable& spec) {
  std::set<std::string> inputs;
  for (const auto& input : spec.inputs) inputs.insert(input.name);
  std::vector<Formula> own, mixed;
  for (const Formula& formula : spec.sys_init) {
    const auto names = logic::names_of(formula).current;
    const bool mentions =
        std::any_of(names.begin(), names.end(), [&](const auto& n) { return inputs.contains(n); });
    (mentions ? mixed : own).push_back(formula);
  }
  if (mixed.empty()) return;
  const Formula first = new_output(spec, "first_step"), kept = joined_flat(Op::And, std::move(mixed));
  const Formula broken = joined_flat(Op::And, {first, !kept});
  for (Formula& step : spec.env_steps) step = joined_flat(Op::Or, {broken, step});
  own.push_back(first);
  spec.sys_init = std::move(own);
  spec.sys_steps.push_back(!logic::next(first));
  spec.sys_steps.push_back(logic::implies(first, kept));
}

/// gr1c's goals are sets of states: a goal about a step becomes an output that remembers whether it was met.
void remember_goals(Portable& spec, std::vector<Formula>& goals) {
  for (Formula& goal : goals) {
    if (logic::names_of(goal).primed.empty()) continue;
    const Formula met = new_output(spec, "goal_met");
    spec.sys_steps.push_back(logic::iff(logic::next(met), goal));
    goal = met;
  }
}

void write_variables(std::string& out, const char* part, const std::vector<model::Variable>& variables,
                     const TargetNames& names) {
  if (variables.empty()) return;
  out += part;
  for (const auto& variable : variables) {
    out += " " + names[variable.name];
    if (variable.domain.kind != model::Domain::Kind::Boolean)
      out += fmt::format(" [0,{}]", variable.domain.high);
  }
  out += ";\n";
}

void write_list(std::string& out, const char* part, const std::vector<Formula>& formulas, const char* prefix,
                const TargetNames& names) {
  insist_on_small(formulas, "gr1c");
  if (formulas.empty()) return;
  out += fmt::format("\n{}:\n", part);
  for (std::size_t i = 0; i < formulas.size(); ++i)
    out +=
        fmt::format("{}{}({})", i == 0 ? "  " : "\n& ", prefix, infix(formulas[i], names, "True", "False"));
  out += ";\n";
}

}  // namespace

std::string write_gr1c(const Gr1& spec) {
  Portable plain = portable(spec, "gr1c");
  separate_start(plain);
  remember_goals(plain, plain.env_justice);
  remember_goals(plain, plain.sys_justice);
  if (in_bits_only(plain))
    plain = in_bits(plain,
                    [](const model::Variable& v, std::size_t i) { return fmt::format("{}.{}", v.name, i); });
  if (plain.inputs.empty() && plain.outputs.empty())
    throw util::InputError(util::Location{}, "not-expressible",
                           "gr1c refuses a specification without variables",
                           "add an output that nothing speaks of");
  const TargetNames names(plain, fits, {"True", "False"});
  std::string out;
  write_variables(out, "ENV:", plain.inputs, names);
  write_variables(out, "SYS:", plain.outputs, names);
  write_list(out, "ENVINIT", plain.env_init, "", names);
  write_list(out, "ENVTRANS", plain.env_steps, "[]", names);
  write_list(out, "ENVGOAL", plain.env_justice, "[]<>", names);
  write_list(out, "SYSINIT", plain.sys_init, "", names);
  write_list(out, "SYSTRANS", plain.sys_steps, "[]", names);
  write_list(out, "SYSGOAL", plain.sys_justice, "[]<>", names);
  return out;
}

}  // namespace heed::spec
