#include "game_reference.h"

#include <algorithm>
#include <stdexcept>

namespace heed::reference {

using logic::Formula;
using logic::Op;

Evaluator::Evaluator(const spec::Gr1& spec) : spec_(spec) {
  for (const auto& v : spec.inputs) domains_[v.name] = &v.domain;
  for (const auto& v : spec.outputs) domains_[v.variable.name] = &v.variable.domain;
  for (const auto& v : spec.memories) domains_[v.variable.name] = &v.variable.domain;
  for (const auto& d : spec.definitions) definitions_[d.name] = &d.formula;
}

const model::Domain* Evaluator::domain(const std::string& name) const {
  const auto found = domains_.find(name);
  return found == domains_.end() ? nullptr : found->second;
}

const model::Domain* Evaluator::enumeration_of(const Formula& node) const {
  if (node.op() == Op::Next) return enumeration_of(node[0]);
  if (node.op() != Op::Name) return nullptr;
  const model::Domain* d = domain(node.name());
  return d != nullptr && d->kind == model::Domain::Kind::Enumeration ? d : nullptr;
}

std::int64_t Evaluator::term(const Formula& node, const Values& now, const Values& next,
                             const model::Domain* other) const {
  switch (node.op()) {
    case Op::Number:
      return node.number();
    case Op::Next:
      return term(node[0], next, {}, other);
    case Op::Add:
      return term(node[0], now, next, nullptr) + term(node[1], now, next, nullptr);
    case Op::Sub:
      return term(node[0], now, next, nullptr) - term(node[1], now, next, nullptr);
    case Op::Mul:
      return term(node[0], now, next, nullptr) * term(node[1], now, next, nullptr);
    case Op::Name:
      if (other != nullptr)
        for (std::size_t i = 0; i < other->values.size(); ++i)
          if (other->values[i] == node.name()) return static_cast<std::int64_t>(i);
      if (domain(node.name()) != nullptr) return now.at(node.name());
      return holds(node, now, next) ? 1 : 0;
    default:
      return holds(node, now, next) ? 1 : 0;
  }
}

bool Evaluator::compare(const Formula& node, const Values& now, const Values& next) const {
  const std::int64_t a = term(node[0], now, next, enumeration_of(node[1]));
  const std::int64_t b = term(node[1], now, next, enumeration_of(node[0]));
  switch (node.op()) {
    case Op::Eq:
      return a == b;
    case Op::Ne:
      return a != b;
    case Op::Lt:
      return a < b;
    case Op::Le:
      return a <= b;
    case Op::Gt:
      return a > b;
    default:
      return a >= b;
  }
}

bool Evaluator::holds(const Formula& f, const Values& now, const Values& next) const {
  switch (f.op()) {
    case Op::True:
      return true;
    case Op::False:
      return false;
    case Op::Name: {
      const auto definition = definitions_.find(f.name());
      return definition != definitions_.end() ? holds(*definition->second, now) : now.at(f.name()) != 0;
    }
    case Op::Not:
      return !holds(f[0], now, next);
    case Op::And:
      return std::all_of(f.operands().begin(), f.operands().end(),
                         [&](const auto& g) { return holds(g, now, next); });
    case Op::Or:
      return std::any_of(f.operands().begin(), f.operands().end(),
                         [&](const auto& g) { return holds(g, now, next); });
    case Op::Implies:
      return !holds(f[0], now, next) || holds(f[1], now, next);
    case Op::Iff:
      return holds(f[0], now, next) == holds(f[1], now, next);
    case Op::Next:
      return holds(f[0], next);
    case Op::Eq:
    case Op::Ne:
    case Op::Lt:
    case Op::Le:
    case Op::Gt:
    case Op::Ge:
      return compare(f, now, next);
    default:
      throw std::logic_error("not a formula of a game");
  }
}

bool Evaluator::holds(const std::vector<spec::Clause>& clauses, const Values& now, const Values& next) const {
  return std::all_of(clauses.begin(), clauses.end(),
                     [&](const auto& c) { return holds(c.formula, now, next); });
}

Values Evaluator::memories(const Values& now, const Values& next_inputs) const {
  Values result;
  for (const auto& memory : spec_.memories) {
    const std::string& name = memory.variable.name;
    if (memory.variable.domain.kind == model::Domain::Kind::Boolean) {
      result[name] = holds(memory.update, now, next_inputs) ? 1 : 0;
      continue;
    }
    result[name] = now.at(name);
    for (const auto& guarded : memory.cases) {
      if (!holds(guarded.guard, now, next_inputs)) continue;
      result[name] = guarded.value;
      break;
    }
  }
  return result;
}

}  // namespace heed::reference
