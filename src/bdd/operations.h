#pragma once

#include <utility>

#include "kernel.h"

/// The recursions over diagrams. Operands must be protected by the caller, results are not. Depth is bounded
/// by the number of variables (twice that where one recursion calls another).
namespace heed::bdd {

/// The conjunction of two edges of different nodes that are not constant. \pre f < g
Edge conjoin_nodes(Kernel& kernel, Edge f, Edge g);
inline Edge conjoin(Kernel& kernel, Edge f, Edge g) {
  if (f > g) std::swap(f, g);
  if (f <= 1) return f == true_edge ? g : false_edge;
  if ((f ^ g) <= 1) return f == g ? f : false_edge;
  return conjoin_nodes(kernel, f, g);
}
inline Edge disjoin(Kernel& kernel, Edge f, Edge g) {
  return conjoin(kernel, f ^ 1U, g ^ 1U) ^ 1U;
}
Edge exclusive_or(Kernel& kernel, Edge f, Edge g);
Edge if_then_else(Kernel& kernel, Edge f, Edge g, Edge h);
/// Whether the conjunction is false. Makes no nodes.
bool disjoint(Kernel& kernel, Edge f, Edge g);

Edge exists(Kernel& kernel, Edge f, Edge cube);
Edge and_exists(Kernel& kernel, Edge f, Edge g, Edge cube);
Edge shift_next(Kernel& kernel, Edge f);
Edge shift_current(Kernel& kernel, Edge f);
/// The second operand is read with its current variables as next ones.
Edge and_next(Kernel& kernel, Edge f, Edge g);
Edge and_exists_next(Kernel& kernel, Edge f, Edge g, Edge cube);

Edge cofactor(Kernel& kernel, Edge f, Edge cube);
Edge restrict_to(Kernel& kernel, Edge f, Edge care);
Edge constrain_to(Kernel& kernel, Edge f, Edge care);

/// What compose replaces: by variable, with the levels below which nothing is replaced.
struct Substitution {
  std::vector<Edge> function;  ///< By variable.
  std::uint32_t last_level;    ///< Of a replaced variable.
  std::uint32_t number;        ///< Kernel::new_substitution().
};
Edge compose(Kernel& kernel, Edge f, const Substitution& substitution);

/// The cofactors of \p edge by the variable at \p level, which is at or above its top.
struct Cofactors {
  Edge low, high;
};
inline Cofactors cofactors(const Kernel& kernel, Edge edge, bool on_top) {
  // Both are read and one is chosen without a branch: which operand is on top is unpredictable.
  const Node& node = kernel.node(edge);
  const Edge low = node.low ^ (edge & 1U), high = node.high ^ (edge & 1U);
  return {on_top ? low : edge, on_top ? high : edge};
}

}  // namespace heed::bdd
