#pragma once

#include <heed/logic/formula.h>

namespace heed::logic {

/// How tightly an operator binds; higher is tighter. Shared by reader and printer, so that they cannot
/// disagree.
enum Binding : int {
  bind_nothing = 0,
  bind_iff = 1,
  bind_implies = 2,
  bind_until = 3,
  bind_or = 4,
  bind_and = 5,
  bind_prefix = 6,
  bind_comparison = 7,
  bind_sum = 8,
  bind_product = 9,
  bind_postfix = 10
};

[[nodiscard]] inline int binding(Op op) {
  switch (op) {
    case Op::Iff:
      return bind_iff;
    case Op::Implies:
      return bind_implies;
    case Op::Until:
    case Op::WeakUntil:
    case Op::Release:
    case Op::Since:
      return bind_until;
    case Op::Or:
      return bind_or;
    case Op::And:
      return bind_and;
    case Op::Eq:
    case Op::Ne:
    case Op::Lt:
    case Op::Le:
    case Op::Gt:
    case Op::Ge:
      return bind_comparison;
    case Op::Add:
    case Op::Sub:
      return bind_sum;
    case Op::Mul:
      return bind_product;
    case Op::True:
    case Op::False:
    case Op::Name:
    case Op::Number:
      return bind_postfix;
    default:
      return bind_prefix;
  }
}

[[nodiscard]] inline bool is_right_associative(Op op) {
  return op == Op::Implies || binding(op) == bind_until;
}
[[nodiscard]] inline bool is_comparison(Op op) {
  return op >= Op::Eq && op <= Op::Ge;
}
[[nodiscard]] inline bool is_arithmetic(Op op) {
  return op >= Op::Add && op <= Op::Mul;
}
[[nodiscard]] inline bool is_prefix(Op op) {
  return binding(op) == bind_prefix;
}

}  // namespace heed::logic
