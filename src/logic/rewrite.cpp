#include <heed/logic/rewrite.h>

#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace heed::logic {
namespace {

/// The node with new operands; itself where nothing changed, so that parts stay shared.
Formula rebuild(const Formula& formula, std::vector<Formula> operands) {
  bool same = true;
  for (std::size_t i = 0; i < operands.size(); ++i)
    same = same && operands[i].identity() == formula[i].identity();
  if (same) return formula;
  return Formula::make(formula.op(), std::move(operands), formula.location());
}

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
      done.emplace(node.identity(), replaced ? std::move(*replaced) : node);
      continue;
    }
    std::vector<Formula> operands;
    for (const Formula& operand : node.operands()) operands.push_back(done.at(operand.identity()));
    done.emplace(node.identity(), rebuild(node, std::move(operands)));
  }
  return done.at(formula.identity());
}

namespace {

/// A part as it stands under so many Nexts.
struct Shifted {
  const void* identity;
  std::size_t nexts;
  friend bool operator==(const Shifted&, const Shifted&) = default;
};

struct ShiftedHash {
  std::size_t operator()(const Shifted& s) const {
    return std::hash<const void*>()(s.identity) * 31 + s.nexts;
  }
};

Formula primed(Formula formula, std::size_t nexts) {
  for (; nexts > 0; --nexts) formula = Formula::make(Op::Next, {formula}, formula.location());
  return formula;
}

}  // namespace

Formula push_next(const Formula& formula) {
  struct Frame {
    const Formula* formula;
    std::size_t nexts;
    bool entered;
  };
  std::unordered_map<Shifted, Formula, ShiftedHash> done;
  std::vector<Frame> open{{&formula, 0, false}};
  while (!open.empty()) {
    const Frame frame = open.back();
    const Formula& node = *frame.formula;
    const Shifted key{node.identity(), frame.nexts};
    const std::size_t below = frame.nexts + (node.op() == Op::Next ? 1 : 0);
    if (done.contains(key)) {
      open.pop_back();
    } else if (!frame.entered) {
      open.back().entered = true;
      for (const Formula& operand : node.operands()) open.push_back({&operand, below, false});
    } else {
      open.pop_back();
      std::vector<Formula> operands;
      for (const Formula& operand : node.operands()) operands.push_back(done.at({operand.identity(), below}));
      if (node.op() == Op::Next)
        done.emplace(key, operands.front());
      else
        done.emplace(key,
                     node.op() == Op::Name ? primed(node, frame.nexts) : rebuild(node, std::move(operands)));
    }
  }
  return done.at({formula.identity(), 0});
}

Names names_of(const Formula& formula) {
  Names names;
  std::unordered_set<Shifted, ShiftedHash> seen;
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
  std::unordered_set<const void*> has_next;
  for (const Formula& node : postorder(formula)) {
    if (is_temporal(node.op()) && !(next_allowed && node.op() == Op::Next)) return false;
    bool below = false;
    for (const Formula& operand : node.operands()) below = below || has_next.contains(operand.identity());
    if (node.op() == Op::Next && below) return false;
    if (below || node.op() == Op::Next) has_next.insert(node.identity());
  }
  return true;
}

}  // namespace heed::logic
