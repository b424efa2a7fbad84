// From local formulas (X and past operators in any nesting) to propositional ones over monitors.
//
// First every X disappears: shifted(f, d) is a formula of the past that holds at time t + d iff f holds at
// time t, for d >= lookahead(f). Then the past disappears: each operator is unrolled once, and the rest is
// remembered by a monitor,
//     Y g = m(g)     O g = g | m(O g)     H g = g & m(H g)     a S b = b | (a & m(a S b)),
// where m(h) keeps the value of h at the step before. A formula with lookahead is stated one step early, over
// primed names, where next_step() needs no primed monitor: the next value of m(h) is the value of h now.
// \cite manna.90.podc

#include "local.h"

#include "precedence.h"
#include "print.h"
#include "walk.h"

#include <fmt/format.h>
#include <heed/logic/rewrite.h>
#include <heed/util/diagnostic.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace heed::logic {

Formula first_step() {
  return Formula::make(Op::Not, {Formula::make(Op::Previous, {truth(true)})});
}

Formula previous(const Formula& a) {
  return a.is_false() ? a : Formula::make(Op::Previous, {a});
}

Formula once(const Formula& a) {
  if (a.is_true() || a.is_false() || a.op() == Op::Once) return a;
  if (a == first_step()) return truth(true);
  return Formula::make(Op::Once, {a});
}

Formula historically(const Formula& a) {
  if (a.is_true() || a.is_false() || a.op() == Op::Historically) return a;
  if (a == !first_step()) return truth(false);
  return Formula::make(Op::Historically, {a});
}

Formula since(const Formula& a, const Formula& b) {
  if (b.is_true() || b.is_false() || a.is_false() || a == b) return b;
  if (a.is_true()) return once(b);
  // Since the first step: `a S (first & a)` is H a.
  if (b == (first_step() && a)) return historically(a);
  return Formula::make(Op::Since, {a, b});
}

bool Locality::is_local(const Formula& formula) {
  std::vector<std::pair<Formula, bool>> open{{formula, false}};
  while (!open.empty()) {
    auto [node, entered] = open.back();
    if (known_.contains(node)) {
      open.pop_back();
      continue;
    }
    if (!entered) {
      open.back().second = true;
      for (const Formula& operand : node.operands()) open.emplace_back(operand, false);
      continue;
    }
    bool local = node.op() < Op::Always || node.op() > Op::Release;
    for (const Formula& operand : node.operands()) local = local && known_.at(operand);
    known_.emplace(node, local);
    open.pop_back();
  }
  return known_.at(formula);
}

namespace {

/// Smallest and largest number of primes on the names of a comparison.
struct Primes {
  std::size_t least = SIZE_MAX, most = 0;
};

Primes primes_of(const Formula& pushed) {
  Primes primes;
  for (const Formula& node : postorder(pushed)) {
    for (const Formula& operand : node.operands()) {
      if (node.op() == Op::Next) continue;
      std::size_t count = 0;
      const Formula* inner = &operand;
      for (; inner->op() == Op::Next; inner = &(*inner)[0]) ++count;
      if (inner->op() != Op::Name) continue;
      primes.least = std::min(primes.least, count);
      primes.most = std::max(primes.most, count);
    }
  }
  if (primes.least == SIZE_MAX) primes.least = 0;
  return primes;
}

Formula strip_primes(const Formula& pushed, std::size_t count) {
  const auto children = [](const InContext& part) {
    std::vector<InContext> needs;
    const bool strip = part.formula.op() == Op::Next && part.context > 0;
    for (const Formula& operand : part.formula.operands())
      needs.push_back({operand, strip ? part.context - 1 : part.context});
    return needs;
  };
  const auto build = [](const InContext& part, std::vector<Formula> operands) {
    if (part.formula.op() == Op::Next && part.context > 0) return operands.front();
    return rebuild(part.formula, std::move(operands));
  };
  return fold({pushed, count}, children, build);
}

/// A comparison as X^least of one whose names carry no prime or one.
struct Comparison {
  Formula formula;
  Primes primes;
};

Comparison normal_terms(const Formula& comparison) {
  const Formula pushed = push_next(comparison);
  const Primes primes = primes_of(pushed);
  if (primes.most > primes.least + 1)
    throw util::InputError(
        comparison.location(), "not-gr1",
        fmt::format("'{}' compares values more than one step apart", to_short_string(comparison)),
        "keep the value in a variable of the specification");
  return {strip_primes(pushed, primes.least), primes};
}

Formula repeat_previous(Formula formula, std::size_t times) {
  for (; times > 0; --times) formula = previous(formula);
  return formula;
}

/// True from step \p steps on.
Formula started(std::size_t steps) {
  return repeat_previous(truth(true), steps);
}

/// Rebuilds a Boolean node, with simplification only where an operand has changed.
Formula combine(const Formula& node, std::vector<Formula> operands) {
  bool same = true;
  for (std::size_t i = 0; i < operands.size(); ++i)
    same = same && operands[i].identity() == node[i].identity();
  if (same) return node;
  switch (node.op()) {
    case Op::Not:
      return !operands[0];
    case Op::And:
      return all_of(std::move(operands));
    case Op::Or:
      return any_of(std::move(operands));
    case Op::Implies:
      return implies(operands[0], operands[1]);
    default:
      return iff(operands[0], operands[1]);
  }
}

std::vector<InContext> operands_in(const Formula& formula, std::size_t context) {
  std::vector<InContext> needs;
  for (const Formula& operand : formula.operands()) needs.push_back({operand, context});
  return needs;
}

Formula shift_node(const InContext& part, std::vector<Formula> operands) {
  const Formula& node = part.formula;
  const std::size_t steps = part.context;
  switch (node.op()) {
    case Op::True:
    case Op::False:
      return node;
    case Op::Name:
      return repeat_previous(node, steps);
    case Op::Next:
      return operands[0];
    case Op::Previous: {
      const Formula before = previous(operands[0]);
      return steps == 0 ? before : before && started(steps + 1);
    }
    case Op::Once:
      return once(operands[0] && started(steps));
    case Op::Historically:
      return historically(implies(started(steps), operands[0]));
    case Op::Since:
      return since(operands[0], operands[1] && started(steps));
    default:
      break;
  }
  if (!is_comparison(node.op())) return combine(node, std::move(operands));
  const Comparison comparison = normal_terms(node);
  return repeat_previous(comparison.formula, steps - comparison.primes.least);
}

/// The past formula that holds at t + steps iff \p local holds at t. \pre steps >= lookahead(local)
Formula shifted(const Formula& local, std::size_t steps) {
  const auto children = [](const InContext& part) {
    const Op op = part.formula.op();
    if (is_comparison(op)) return std::vector<InContext>{};
    return operands_in(part.formula, op == Op::Next ? part.context - 1 : part.context);
  };
  return fold({local, steps}, children, shift_node);
}

/// A past formula at the first step, where nothing lies before.
Formula at_first_step(const Formula& past) {
  const auto children = [](const InContext& part) {
    if (is_comparison(part.formula.op())) return std::vector<InContext>{};
    return operands_in(part.formula, 0);
  };
  const auto build = [](const InContext& part, std::vector<Formula> operands) {
    switch (part.formula.op()) {
      case Op::Previous:
        return truth(false);
      case Op::Once:
      case Op::Historically:
        return operands[0];
      case Op::Since:
        return operands[1];
      default:
        return operands.empty() ? part.formula : combine(part.formula, std::move(operands));
    }
  };
  return fold({past, 0}, children, build);
}

}  // namespace

std::size_t lookahead(const Formula& local) {
  std::unordered_map<const void*, std::size_t> known;
  for (const Formula& node : postorder(local)) {
    std::size_t most = 0;
    for (const Formula& operand : node.operands()) most = std::max(most, known.at(operand.identity()));
    if (is_comparison(node.op())) most = normal_terms(node).primes.most;
    known[node.identity()] = most + (node.op() == Op::Next ? 1 : 0);
  }
  return known.at(local.identity());
}

void LocalCompiler::add_initial(const Formula& local) {
  const std::size_t steps = lookahead(local);
  if (steps == 0) {
    result_.init.push_back(at_first_step(local));
    return;
  }
  const Formula reached = repeat_previous(first_step(), steps - 1);
  result_.safety.push_back(implies(now(reached), next_step(shifted(local, steps))));
}

void LocalCompiler::add_safety(const Formula& local) {
  const std::size_t steps = lookahead(local);
  if (steps == 0)
    result_.safety.push_back(now(shifted(local, 0)));
  else
    result_.safety.push_back(implies(now(started(steps - 1)), next_step(shifted(local, steps))));
}

void LocalCompiler::add_justice(const Formula& local) {
  const std::size_t steps = lookahead(local);
  const Formula past = shifted(local, steps);
  result_.justice.push_back(steps == 0 ? now(past) : next_step(past));
}

std::size_t LocalCompiler::monitor(const Formula& past, bool initial) {
  const auto [found, added] = monitors_[initial ? 1 : 0].emplace(past, result_.monitors.size());
  if (added)
    result_.monitors.push_back(
        {prefix_ + std::to_string(result_.monitors.size() + 1), initial, Formula(), to_short_string(past)});
  return found->second;
}

Formula LocalCompiler::now_of(const Formula& node) {
  if (node.operands().empty() || is_comparison(node.op())) return node;
  const auto value = [this](const Formula& operand) { return now_.at(operand); };
  const bool initial = node.op() == Op::Historically;
  if (node.op() == Op::Previous) {
    const std::size_t index = monitor(node[0], false);
    result_.monitors[index].update = value(node[0]);
    return name(result_.monitors[index].name);
  }
  if (node.op() != Op::Once && node.op() != Op::Historically && node.op() != Op::Since) {
    std::vector<Formula> operands;
    for (const Formula& operand : node.operands()) operands.push_back(value(operand));
    return combine(node, std::move(operands));
  }
  const std::size_t index = monitor(node, initial);
  const Formula before = name(result_.monitors[index].name);
  Formula unrolled = node.op() == Op::Once           ? value(node[0]) || before
                     : node.op() == Op::Historically ? value(node[0]) && before
                                                     : value(node[1]) || (value(node[0]) && before);
  result_.monitors[index].update = unrolled;
  return unrolled;
}

Formula LocalCompiler::next_of(const Formula& node) {
  const auto value = [this](const Formula& operand) { return next_.at(operand); };
  switch (node.op()) {
    case Op::Previous:
      return now(node[0]);
    case Op::Once:
      return value(node[0]) || now(node);
    case Op::Historically:
      return value(node[0]) && now(node);
    case Op::Since:
      return value(node[1]) || (value(node[0]) && now(node));
    default:
      break;
  }
  if (node.operands().empty() || is_comparison(node.op()))
    return push_next(Formula::make(Op::Next, {node}, node.location()));
  std::vector<Formula> operands;
  for (const Formula& operand : node.operands()) operands.push_back(value(operand));
  return combine(node, std::move(operands));
}

namespace {

/// postorder() of the Boolean and past structure; comparisons are leaves.
std::vector<Formula> past_postorder(const Formula& past) {
  struct Frame {
    Formula formula;
    bool entered;
  };
  std::vector<Formula> order;
  std::unordered_map<const void*, bool> listed;
  std::vector<Frame> open{{past, false}};
  while (!open.empty()) {
    const Frame frame = open.back();
    if (!frame.entered && !listed[frame.formula.identity()]) {
      open.back().entered = true;
      if (is_comparison(frame.formula.op())) continue;
      for (const Formula& operand : frame.formula.operands()) open.push_back({operand, false});
      continue;
    }
    open.pop_back();
    if (!std::exchange(listed[frame.formula.identity()], true)) order.push_back(frame.formula);
  }
  return order;
}

}  // namespace

Formula LocalCompiler::now(const Formula& past) {
  if (const auto found = now_.find(past); found != now_.end()) return found->second;
  for (const Formula& node : past_postorder(past))
    if (!now_.contains(node)) now_.emplace(node, now_of(node));
  return now_.at(past);
}

Formula LocalCompiler::next_step(const Formula& past) {
  for (const Formula& node : past_postorder(past))
    if (!next_.contains(node)) next_.emplace(node, next_of(node));
  return next_.at(past);
}

}  // namespace heed::logic
