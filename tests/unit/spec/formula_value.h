#pragma once

#include <heed/logic/formula.h>
#include <heed/spec/gr1.h>
#include <heed/util/diagnostic.h>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace heed::spec::test {

using Values = std::map<std::string, std::int64_t>;

inline std::int64_t apply(logic::Op op, std::int64_t a, std::int64_t b) {
  using logic::Op;
  switch (op) {
    case Op::Implies:
      return a == 0 || b != 0 ? 1 : 0;
    case Op::Iff:
    case Op::Eq:
      return a == b ? 1 : 0;
    case Op::Ne:
      return a != b ? 1 : 0;
    case Op::Lt:
      return a < b ? 1 : 0;
    case Op::Le:
      return a <= b ? 1 : 0;
    case Op::Gt:
      return a > b ? 1 : 0;
    case Op::Ge:
      return a >= b ? 1 : 0;
    case Op::Add:
      return a + b;
    case Op::Sub:
      return a - b;
    case Op::Mul:
      return a * b;
    default:
      throw std::logic_error("an operator that the test does not know");
  }
}

/// What \p formula is worth: the definition of its operators, each node once. Next stands on names or `true`.
inline std::int64_t value_of(const logic::Formula& formula, const Values& now, const Values& next) {
  using logic::Op;
  std::unordered_map<const void*, std::int64_t> done;
  for (const logic::Formula& node : logic::postorder(formula)) {
    const auto part = [&](std::size_t i) { return done.at(node[i].identity()); };
    std::int64_t value = 0;
    if (node.op() == Op::True || node.op() == Op::False) {
      value = node.is_true() ? 1 : 0;
    } else if (node.op() == Op::Name) {
      value = now.at(node.name());
    } else if (node.op() == Op::Number) {
      value = node.number();
    } else if (node.op() == Op::Next) {
      value = node[0].op() == Op::Name ? next.at(node[0].name()) : part(0);
    } else if (node.op() == Op::Not) {
      value = part(0) == 0 ? 1 : 0;
    } else if (node.op() == Op::And || node.op() == Op::Or) {
      const bool all = node.op() == Op::And;
      value = all ? 1 : 0;
      for (std::size_t i = 0; i < node.operands().size(); ++i)
        if ((part(i) != 0) != all) value = all ? 0 : 1;
    } else {
      value = apply(node.op(), part(0), part(1));
    }
    done.emplace(node.identity(), value);
  }
  return done.at(formula.identity());
}

/// "code line:column" of what \p read throws; empty when it throws nothing.
inline std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const util::InputError& error) {
    const util::Diagnostic& d = error.diagnostic();
    return d.code + " " + std::to_string(d.location.line) + ":" + std::to_string(d.location.column);
  }
  return "";
}

struct Flaw {
  std::string text, refusal;
};

}  // namespace heed::spec::test
