#include "portable.h"

#include <heed/logic/rewrite.h>
#include <heed/spec/symbols.h>
#include <heed/util/diagnostic.h>

#include "peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

namespace heed::spec {

using logic::Formula;
using logic::Op;

namespace {

constexpr std::size_t most_starts = 4096;

bool is_comparison(Op op) {
  return op >= Op::Eq && op <= Op::Ge;
}

Formula node_of(const Formula& node, std::vector<Formula> operands) {
  if (node.op() == Op::And || node.op() == Op::Or) return joined_flat(node.op(), std::move(operands));
  if (node.op() == Op::Not) return !operands[0];
  if (node.op() == Op::Implies) return logic::implies(operands[0], operands[1]);
  if (node.op() == Op::Iff) return logic::iff(operands[0], operands[1]);
  if (is_comparison(node.op())) return logic::compare(node.op(), operands[0], operands[1]);
  if (node.op() == Op::Next) return logic::next(operands[0]);
  if (operands.empty()) return node;
  return Formula::make(node.op(), std::move(operands));
}

template <typename Build>
Formula bottom_up(const Formula& root, Build build) {
  std::unordered_map<const void*, Formula> done;
  for (const Formula& node : logic::postorder(root)) {
    std::vector<Formula> operands;
    for (const Formula& operand : node.operands()) operands.push_back(done.at(operand.identity()));
    done.emplace(node.identity(), build(node, std::move(operands)));
  }
  return done.at(root.identity());
}

model::Variable as_integer(model::Variable variable) {
  if (variable.domain.kind == model::Domain::Kind::Enumeration)
    variable.domain = model::Domain::integer(variable.domain.low, variable.domain.high);
  return variable;
}

Formula has_value(const model::Variable& variable, std::int32_t code, bool next) {
  Formula value = logic::name(variable.name);
  if (next) value = logic::next(value);
  if (variable.domain.kind == model::Domain::Kind::Boolean) return code != 0 ? value : !value;
  return logic::compare(Op::Eq, value, logic::number(code));
}

/// The next value of a memory that is no Boolean: what makes it each of its values, and what lets it stay.
struct Choices {
  std::map<std::int32_t, Formula> when;
  Formula stays;
};

class Lowering {
 public:
  Lowering(const Gr1& spec, std::string_view target) : spec_(spec), symbols_(spec), target_(target) {}

  Portable run() {
    if (spec_.timing != Timing::Mealy)
      refuse("a system that chooses before it sees the input (Moore)", "set timing = mealy, or keep to .gr1");
    if (spec_.initial != InitialQuantifiers::ForallExists)
      refuse("initial quantifiers other than forall-exists", "set initial = forall-exists, or keep to .gr1");
    out_.name = spec_.name;
    variables();
    for (const Memory& memory : spec_.memories) lower_memory(memory);
    for (const Definition& definition : spec_.definitions) lower_definition(definition);
    for (const Clause& clause : spec_.env_init) out_.env_init.push_back(plain(clause.formula));
    for (const Clause& clause : spec_.sys_init) out_.sys_init.push_back(plain(clause.formula));
    for (const Clause& clause : spec_.env_safety) lower_assumption(clause);
    start_assumptions();
    for (const Clause& clause : spec_.sys_safety) {
      const Formula formula = plain(clause.formula);
      if (!clause.formula.has_next()) out_.sys_init.push_back(formula);
      out_.sys_steps.push_back(clause.formula.has_next() ? formula : one_step_later(formula));
    }
    for (const Clause& clause : spec_.env_justice) out_.env_justice.push_back(plain(clause.formula));
    for (const Clause& clause : spec_.sys_justice) out_.sys_justice.push_back(plain(clause.formula));
    return std::move(out_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what, std::string hint) const {
    throw util::InputError(util::Location{}, "not-expressible",
                           fmt::format("{} cannot say {}", target_, what), std::move(hint));
  }

  void variables() {
    for (const auto& input : spec_.inputs) out_.inputs.push_back(as_integer(input));
    for (const auto& output : spec_.outputs) {
      out_.outputs.push_back(as_integer(output.variable));
      answers_.insert(output.variable.name);
    }
    for (const auto& memory : spec_.memories) out_.outputs.push_back(as_integer(memory.variable));
    for (const auto& definition : spec_.definitions)
      out_.outputs.push_back({definition.name, model::Domain::boolean(), {}, {}});
  }

  [[nodiscard]] bool is_truth(const Formula& operand) const {
    const Formula* at = &operand;
    while (at->op() == Op::Next) at = &(*at)[0];
    if (at->op() == Op::Name) {
      const Symbol* symbol = symbols_.find(at->name());
      return symbol != nullptr && symbol->domain.kind == model::Domain::Kind::Boolean;
    }
    return at->op() != Op::Number && at->op() != Op::Add && at->op() != Op::Sub && at->op() != Op::Mul;
  }

  /// Values become numbers, compared truth values an equivalence, Next goes down to names.
  [[nodiscard]] Formula plain(const Formula& formula) const {
    const Formula numbered = bottom_up(formula, [this](const Formula& node, std::vector<Formula> operands) {
      if (!is_comparison(node.op())) return node_of(node, std::move(operands));
      bool values = false;
      for (std::size_t i = 0; i < 2; ++i)
        if (const auto code = enumeration_value(node, i, symbols_)) {
          operands[i] = logic::number(*code);
          values = true;
        }
      if (values || !is_truth(node[0]) || !is_truth(node[1])) return node_of(node, std::move(operands));
      const Formula same = logic::iff(operands[0], operands[1]);
      return node.op() == Op::Eq ? same : !same;
    });
    return logic::push_next(numbered);
  }

  [[nodiscard]] Choices choices(const Memory& memory) const {
    Choices out;
    for (const Memory::Case& c : memory.cases) {
      const Formula guard = plain(c.guard);
      const Formula here = joined_flat(Op::And, {out.stays, guard});
      const auto [place, fresh] = out.when.try_emplace(c.value, here);
      if (!fresh) place->second = joined_flat(Op::Or, {place->second, here});
      out.stays = joined_flat(Op::And, {out.stays, !guard});
    }
    return out;
  }

  void lower_memory(const Memory& memory) {
    const model::Variable variable = as_integer(memory.variable);
    std::vector<Formula> starts;
    for (const std::int32_t code : memory.initial) starts.push_back(has_value(variable, code, false));
    out_.sys_init.push_back(joined_flat(Op::Or, std::move(starts)));
    const Formula now = logic::name(variable.name), later = logic::next(now);
    if (variable.domain.kind == model::Domain::Kind::Boolean) {
      out_.sys_steps.push_back(logic::iff(later, plain(memory.update)));
      return;
    }
    const Choices next = choices(memory);
    for (const auto& [value, when] : next.when)
      out_.sys_steps.push_back(logic::implies(when, has_value(variable, value, true)));
    out_.sys_steps.push_back(logic::implies(next.stays, logic::compare(Op::Eq, later, now)));
  }

  void lower_definition(const Definition& definition) {
    const Formula formula = plain(definition.formula);
    const Formula holds = logic::iff(logic::name(definition.name), formula);
    out_.sys_init.push_back(holds);
    out_.sys_steps.push_back(one_step_later(holds));
    const auto names = logic::names_of(formula).current;
    if (std::any_of(names.begin(), names.end(), [this](const auto& n) { return answers_.contains(n); }))
      answers_.insert(definition.name);
    expanded_.emplace(definition.name,
                      rebuilt(formula, [this](const Formula& leaf) { return expanded(leaf); }));
  }

  [[nodiscard]] Formula expanded(const Formula& leaf) const {
    if (leaf.op() != Op::Name) return leaf;
    const auto found = expanded_.find(leaf.name());
    return found == expanded_.end() ? leaf : found->second;
  }

  /// An assumption on the present that no answer touches restricts the input at once, at the start and later;
  /// any other one is about steps. The next values of memories are written out, for the environment moves
  /// first.
  void lower_assumption(const Clause& clause) {
    const Formula formula = plain(clause.formula);
    const auto names = logic::names_of(formula).current;
    const bool judged =
        std::any_of(names.begin(), names.end(), [this](const auto& n) { return answers_.contains(n); });
    if (clause.formula.has_next() || judged) {
      out_.env_steps.push_back(formula);
      return;
    }
    const Formula present = rebuilt(formula, [this](const Formula& leaf) { return expanded(leaf); });
    present_.push_back(present);
    Formula step = one_step_later(present);
    for (const Memory& memory : spec_.memories)
      if (names_in(step).primed.contains(memory.variable.name)) step = with_update(step, memory);
    out_.env_steps.push_back(step);
  }

  [[nodiscard]] static logic::Names names_in(const Formula& formula) { return logic::names_of(formula); }

  [[nodiscard]] static Formula with_next(const Formula& step, const std::string& name, const Formula& value) {
    return rebuilt(step, [&](const Formula& leaf) {
      return leaf.op() == Op::Next && leaf[0].name() == name ? value : leaf;
    });
  }

  [[nodiscard]] Formula with_update(const Formula& step, const Memory& memory) const {
    const std::string& name = memory.variable.name;
    if (memory.variable.domain.kind == model::Domain::Kind::Boolean)
      return with_next(step, name, plain(memory.update));
    const Choices next = choices(memory);
    std::vector<Formula> parts{logic::implies(next.stays, with_next(step, name, logic::name(name)))};
    for (const auto& [value, when] : next.when)
      parts.push_back(logic::implies(when, with_next(step, name, logic::number(value))));
    return joined_flat(Op::And, std::move(parts));
  }

  [[nodiscard]] static Formula value_of(const Memory& memory, std::int32_t code) {
    const bool truth = memory.variable.domain.kind == model::Domain::Kind::Boolean;
    return truth ? logic::truth(code != 0) : logic::number(code);
  }

  /// At the start an input is legal when some initial value of the memories makes it so; the system then
  /// takes such a one.
  void start_assumptions() {
    if (present_.empty()) return;
    const Formula all = joined_flat(Op::And, present_);
    const std::set<std::string> used = names_in(all).current;
    std::vector<Formula> starts{all};
    bool several = false;
    for (const Memory& memory : spec_.memories) {
      if (!used.contains(memory.variable.name)) continue;
      several = several || memory.initial.size() > 1;
      std::vector<Formula> split;
      for (const Formula& start : starts)
        for (const std::int32_t code : memory.initial)
          split.push_back(rebuilt(start, [&](const Formula& leaf) {
            return leaf.op() == Op::Name && leaf.name() == memory.variable.name ? value_of(memory, code)
                                                                                : leaf;
          }));
      starts = std::move(split);
      if (starts.size() > most_starts) refuse("so many initial values of memories", "name fewer of them");
    }
    out_.env_init.push_back(joined_flat(Op::Or, std::move(starts)));
    if (several) out_.sys_init.push_back(all);
  }

  const Gr1& spec_;
  Symbols symbols_;
  std::string_view target_;
  Portable out_;
  std::set<std::string> answers_;  ///< Outputs, and what is defined by them.
  std::map<std::string, Formula> expanded_;
  std::vector<Formula> present_;
};

}  // namespace

Portable portable(const Gr1& spec, std::string_view target) {
  return Lowering(spec, target).run();
}

std::vector<std::vector<Formula>*> formula_lists(Portable& spec) {
  return {&spec.env_init, &spec.env_steps, &spec.env_justice,
          &spec.sys_init, &spec.sys_steps, &spec.sys_justice};
}

Formula rebuilt(const Formula& formula, const std::function<Formula(const Formula&)>& leaf) {
  return bottom_up(formula, [&leaf](const Formula& node, std::vector<Formula> operands) {
    const bool at_leaf = node.op() == Op::Next || node.op() == Op::Name || node.op() == Op::Number;
    return at_leaf ? leaf(node) : node_of(node, std::move(operands));
  });
}

Formula one_step_later(const Formula& formula) {
  return rebuilt(formula, [](const Formula& leaf) { return logic::next(leaf); });
}

std::size_t unfolded_size(const Formula& formula, std::size_t most) {
  std::unordered_map<const void*, std::size_t> sizes;
  for (const Formula& node : logic::postorder(formula)) {
    std::size_t size = 1;
    for (const Formula& operand : node.operands()) size = std::min(most, size + sizes.at(operand.identity()));
    sizes.emplace(node.identity(), size);
  }
  return sizes.at(formula.identity());
}

void insist_on_small(const std::vector<Formula>& formulas, std::string_view target) {
  constexpr std::size_t most = 4'000'000;
  std::size_t size = 0;
  for (const Formula& formula : formulas) {
    size += unfolded_size(formula, most);
    if (size >= most)
      throw util::InputError(
          formula.location(), "not-expressible",
          fmt::format("{} has no shared subformulas, and written out they would have more than {} nodes",
                      target, most),
          "slugsin keeps them shared");
  }
}

TargetNames::TargetNames(const Portable& spec, const std::function<bool(char)>& fits,
                         const std::vector<std::string_view>& reserved) {
  std::vector<std::string> all;
  for (const auto* list : {&spec.inputs, &spec.outputs})
    for (const auto& variable : *list) all.push_back(variable.name);
  const auto spelled = [&](const std::string& name) {
    std::string out = name;
    for (char& c : out)
      if (!fits(c)) c = '_';
    const bool digit = !out.empty() && out[0] >= '0' && out[0] <= '9';
    if (out.empty() || digit || std::find(reserved.begin(), reserved.end(), out) != reserved.end())
      out = "_" + out;
    return out;
  };
  for (const std::string& name : all)
    if (spelled(name) == name) taken_.push_back(name);
  for (const std::string& name : all) {
    const std::string wish = spelled(name);
    names_.emplace_back(name, wish == name ? name : fresh(wish));
  }
  std::sort(names_.begin(), names_.end());
}

const std::string& TargetNames::operator[](const std::string& name) const {
  const auto found =
      std::lower_bound(names_.begin(), names_.end(), name,
                       [](const auto& entry, const std::string& key) { return entry.first < key; });
  return found != names_.end() && found->first == name ? found->second : name;
}

std::string TargetNames::fresh(const std::string& wish) {
  std::string name = wish;
  for (std::size_t i = 2; std::find(taken_.begin(), taken_.end(), name) != taken_.end(); ++i)
    name = fmt::format("{}_{}", wish, i);
  taken_.push_back(name);
  return name;
}

}  // namespace heed::spec
