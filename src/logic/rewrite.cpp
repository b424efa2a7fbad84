#include "walk.h"

#include <heed/logic/rewrite.h>

#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace heed::logic {
namespace {

bool is_temporal(Op op) {
  return op >= Op::Next;
}

}  // namespace

Formula substitute(const Formula& formula,
                   const std::function<std::optional<Formula>(const std::string&)>& replacement) {
  std::unordered_map<const void*, Formula> done;
  for (const Formula& node : postorder(formula)) {
    if (node.op() == Op::Name) {
      auto replaced = replacement(node.name());
      done.emplace(node.identity(), replaced ? *replaced : node);
      continue;
    }
    std::vector<Formula> operands;
    for (const Formula& operand : node.operands()) operands.push_back(done.at(operand.identity()));
    done.emplace(node.identity(), rebuild(node, std::move(operands)));
  }
  return done.at(formula.identity());
}

namespace {

Formula primed(Formula formula, std::size_t nexts) {
  for (; nexts > 0; --nexts) formula = Formula::make(Op::Next, {formula}, formula.location());
  return formula;
}

}  // namespace

Formula push_next(const Formula& formula) {
  const auto children = [](const InContext& part) {
    const std::size_t below = part.context + (part.formula.op() == Op::Next ? 1 : 0);
    std::vector<InContext> needs;
    for (const Formula& operand : part.formula.operands()) needs.push_back({operand, below});
    return needs;
  };
  const auto build = [](const InContext& part, std::vector<Formula> operands) {
    if (part.formula.op() == Op::Next) return operands.front();
    if (part.formula.op() == Op::Name) return primed(part.formula, part.context);
    return rebuild(part.formula, std::move(operands));
  };
  return fold({formula, 0}, children, build);
}

Names names_of(const Formula& formula) {
  Names names;
  std::unordered_set<ContextKey, ContextKeyHash> seen;
  std::vector<std::pair<const Formula*, bool>> open{{&formula, false}};
  while (!open.empty()) {
    const auto [node, below_next] = open.back();
    open.pop_back();
    if (!seen.insert({node->identity(), below_next ? std::size_t{1} : std::size_t{0}}).second) continue;
    if (node->op() == Op::Name) (below_next ? names.primed : names.current).insert(node->name());
    for (const Formula& operand : node->operands())
      open.emplace_back(&operand, below_next || node->op() == Op::Next);
  }
  return names;
}

bool is_propositional(const Formula& formula, bool next_allowed) {
  for (const Formula& node : postorder(formula)) {
    if (is_temporal(node.op()) && !(next_allowed && node.op() == Op::Next)) return false;
    if (node.op() == Op::Next && node[0].has_next()) return false;
  }
  return true;
}

}  // namespace heed::logic
