#include "normal_form.h"

#include "print.h"
#include "walk.h"

#include <fmt/format.h>
#include <heed/util/diagnostic.h>

#include <utility>
#include <vector>

namespace heed::logic {

void refuse(const Formula& formula, const std::string& reason) {
  util::Location location = formula.location();
  for (const Formula& node : postorder(formula))
    if (location.line == 0) location = node.location();
  throw util::InputError(
      std::move(location), "not-gr1",
      fmt::format("'{}' is outside what deterministic monitors can follow: {}", to_short_string(formula),
                  reason),
      "state what must hold always (G), again and again (GF), or after a request (G (a -> F b))");
}

namespace {

Formula until(Op op, const Formula& a, const Formula& b, const Formula& origin) {
  return Formula::make(op, {a, b}, origin.location());
}

std::vector<Formula> both(const std::vector<Formula>& results, std::size_t first) {
  return {results[first], results[first + 1]};
}

/// \param r  The operands positive, then (for Iff) negative; of a negated node the reverse.
Formula build_positive(const Formula& node, const std::vector<Formula>& r) {
  switch (node.op()) {
    case Op::Not:
      return r[0];
    case Op::And:
      return all_of(r);
    case Op::Or:
    case Op::Implies:
      return any_of(r);
    case Op::Iff:
      return Formula::make(Op::And, {any_of({r[2], r[1]}), any_of({r[0], r[3]})}, node.location());
    case Op::Release:
      return until(Op::WeakUntil, r[1], all_of(both(r, 0)), node);
    default:
      return rebuild(node, r);
  }
}

Formula build_negative(const Formula& node, const std::vector<Formula>& r) {
  switch (node.op()) {
    case Op::Not:
      return r[0];
    case Op::And:
      return any_of(r);
    case Op::Or:
    case Op::Implies:
      return all_of(r);
    case Op::Iff:
      return Formula::make(Op::And, {any_of({r[0], r[1]}), any_of({r[2], r[3]})}, node.location());
    case Op::Always:
      return Formula::make(Op::Eventually, {r[0]}, node.location());
    case Op::Eventually:
      return Formula::make(Op::Always, {r[0]}, node.location());
    case Op::Next:
      return Formula::make(Op::Next, {r[0]}, node.location());
    case Op::Until:
      return until(Op::WeakUntil, r[1], all_of(both(r, 0)), node);
    case Op::WeakUntil:
      return until(Op::Until, r[1], all_of(both(r, 0)), node);
    default:
      return until(Op::Until, r[0], r[1], node);
  }
}

/// Operands with their polarity, 1 = negated; Iff needs both of each.
std::vector<InContext> polarities(const InContext& part) {
  const Formula& node = part.formula;
  const std::size_t same = part.context, opposite = 1 - part.context;
  switch (node.op()) {
    case Op::Not:
      return {{node[0], opposite}};
    case Op::Implies:
      return {{node[0], opposite}, {node[1], same}};
    case Op::Iff:
      return {{node[0], 0}, {node[1], 0}, {node[0], 1}, {node[1], 1}};
    default:
      break;
  }
  std::vector<InContext> needs;
  for (const Formula& operand : node.operands()) needs.push_back({operand, same});
  return needs;
}

}  // namespace

Formula negation_normal_form(const Formula& formula, Locality& locality) {
  const auto children = [&locality](const InContext& part) {
    if (locality.is_local(part.formula)) return std::vector<InContext>{};
    if (part.formula.op() >= Op::Previous) refuse(part.formula, "a future operator stands below a past one");
    return polarities(part);
  };
  const auto build = [&locality](const InContext& part, const std::vector<Formula>& results) {
    const bool negated = part.context == 1;
    if (locality.is_local(part.formula)) return negated ? !part.formula : part.formula;
    return negated ? build_negative(part.formula, results) : build_positive(part.formula, results);
  };
  return fold({formula, 0}, children, build);
}

namespace {

Formula wrap(Op op, const Formula& inside, const Formula& origin) {
  return Formula::make(op, {inside}, origin.location());
}

Formula infinitely_often(const Formula& inside, const Formula& origin) {
  return wrap(Op::Always, wrap(Op::Eventually, inside, origin), origin);
}

bool is_infinitely_often(const Formula& formula) {
  return formula.op() == Op::Always && formula[0].op() == Op::Eventually;
}

template <class Map>
std::vector<Formula> each(const Formula& node, Map map) {
  std::vector<Formula> out;
  for (const Formula& operand : node.operands()) out.push_back(map(operand));
  return out;
}

/// match: F f. f is not local.
Formula law_for_eventually(const Formula& formula) {
  const Formula& inside = formula[0];
  switch (inside.op()) {
    case Op::Eventually:
      return inside;
    case Op::Or:
      return any_of(each(inside, [&](const Formula& part) { return wrap(Op::Eventually, part, formula); }));
    case Op::Next:
      return wrap(Op::Next, wrap(Op::Eventually, inside[0], formula), formula);
    case Op::Until:
      return wrap(Op::Eventually, inside[1], formula);
    case Op::Always:
      return is_infinitely_often(inside) ? inside : formula;
    default:
      return formula;
  }
}

/// match: G F f with f a conjunction. result: again and again the local part, each `F b` and each `G F b`.
Formula law_for_repeated_conjunction(const Formula& formula, Locality& locality) {
  std::vector<Formula> local, repeated;
  for (const Formula& part : formula[0][0].operands()) {
    if (locality.is_local(part))
      local.push_back(part);
    else if (part.op() == Op::Eventually)
      repeated.push_back(infinitely_often(part[0], formula));
    else if (is_infinitely_often(part))
      repeated.push_back(part);
    else
      return formula;
  }
  if (!local.empty()) repeated.push_back(infinitely_often(all_of(local), formula));
  return all_of(std::move(repeated));
}

/// match: G F f. f is not local.
Formula law_for_infinitely_often(const Formula& formula, Locality& locality) {
  const Formula& inside = formula[0][0];
  switch (inside.op()) {
    case Op::Eventually:
    case Op::Next:
      return infinitely_often(inside[0], formula);
    case Op::Or:
      return any_of(each(inside, [&](const Formula& part) { return infinitely_often(part, formula); }));
    case Op::Until:
      return infinitely_often(inside[1], formula);
    case Op::Always:
      return is_infinitely_often(inside) ? inside : formula;
    case Op::And:
      return law_for_repeated_conjunction(formula, locality);
    default:
      return formula;
  }
}

}  // namespace

Formula apply_law(const Formula& formula, Locality& locality) {
  if (formula.op() == Op::Eventually && !locality.is_local(formula[0])) return law_for_eventually(formula);
  if (formula.op() != Op::Always || locality.is_local(formula[0])) return formula;
  const Formula& inside = formula[0];
  switch (inside.op()) {
    case Op::Always:
      return inside;
    case Op::And:
      return all_of(each(inside, [&](const Formula& part) { return wrap(Op::Always, part, formula); }));
    case Op::Next:
      return wrap(Op::Next, wrap(Op::Always, inside[0], formula), formula);
    case Op::Eventually:
      return locality.is_local(inside[0]) ? formula : law_for_infinitely_often(formula, locality);
    default:
      return formula;
  }
}

}  // namespace heed::logic
