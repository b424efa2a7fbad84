#pragma once

#include <heed/logic/formula.h>

namespace heed::logic {

/// How tightly an operator binds; higher is tighter. Shared by reader and printer, so that they cannot
/// disagree.
enum Binding : int {
  BindNothing = 0,
  BindIff = 1,
  BindImplies = 2,
  BindUntil = 3,
  BindOr = 4,
  BindAnd = 5,
  BindPrefix = 6,
  BindComparison = 7,
  BindSum = 8,
  BindProduct = 9,
  BindPostfix = 10
};

[[nodiscard]] inline int binding(Op op) {
  switch (op) {
    case Op::Iff:
      return BindIff;
    case Op::Implies:
      return BindImplies;
    case Op::Until:
    case Op::WeakUntil:
    case Op::Release:
    case Op::Since:
      return BindUntil;
    case Op::Or:
      return BindOr;
    case Op::And:
      return BindAnd;
    case Op::Eq:
    case Op::Ne:
    case Op::Lt:
    case Op::Le:
    case Op::Gt:
    case Op::Ge:
      return BindComparison;
    case Op::Add:
    case Op::Sub:
      return BindSum;
    case Op::Mul:
      return BindProduct;
    case Op::True:
    case Op::False:
    case Op::Name:
    case Op::Number:
      return BindPostfix;
    default:
      return BindPrefix;
  }
}

[[nodiscard]] inline bool is_right_associative(Op op) {
  return op == Op::Implies || binding(op) == BindUntil;
}
[[nodiscard]] inline bool is_comparison(Op op) {
  return op >= Op::Eq && op <= Op::Ge;
}
[[nodiscard]] inline bool is_arithmetic(Op op) {
  return op >= Op::Add && op <= Op::Mul;
}
[[nodiscard]] inline bool is_prefix(Op op) {
  return binding(op) == BindPrefix;
}

}  // namespace heed::logic
