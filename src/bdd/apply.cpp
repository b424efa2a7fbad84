#include <algorithm>

#include "operations.h"

namespace heed::bdd {

Edge conjoin_nodes(Kernel& kernel, Edge f, Edge g) {
  Edge result = 0;
  if (kernel.cache.find(Binary::And, f, g, result)) return result;
  kernel.step();
  const std::uint32_t f_level = kernel.level(f), g_level = kernel.level(g);
  const std::uint32_t variable = kernel.variable(f_level <= g_level ? f : g);
  const Cofactors fs = cofactors(kernel, f, f_level <= g_level),
                  gs = cofactors(kernel, g, g_level <= f_level);
  const Edge low = conjoin(kernel, fs.low, gs.low);
  kernel.push(low);
  const Edge high = conjoin(kernel, fs.high, gs.high);
  kernel.pop();
  result = kernel.make(variable, low, high);
  kernel.cache.store(Binary::And, f, g, result);
  return result;
}

Edge exclusive_or(Kernel& kernel, Edge f, Edge g) {
  const Edge flip = (f ^ g) & 1U;
  f &= ~1U;
  g &= ~1U;
  if (f == g) return false_edge ^ flip;
  if (f > g) std::swap(f, g);
  if (f == true_edge) return g ^ 1U ^ flip;
  Edge result = 0;
  if (kernel.cache.find(Binary::Xor, f, g, result)) return result ^ flip;
  kernel.step();
  const std::uint32_t f_level = kernel.level(f), g_level = kernel.level(g);
  const std::uint32_t variable = kernel.variable(f_level <= g_level ? f : g);
  const Cofactors fs = cofactors(kernel, f, f_level <= g_level),
                  gs = cofactors(kernel, g, g_level <= f_level);
  const Edge low = exclusive_or(kernel, fs.low, gs.low);
  kernel.push(low);
  const Edge high = exclusive_or(kernel, fs.high, gs.high);
  kernel.pop();
  result = kernel.make(variable, low, high);
  kernel.cache.store(Binary::Xor, f, g, result);
  return result ^ flip;
}

namespace {

/// The cases of if-then-else that have two operands. \returns whether it was one
bool reduce_ite(Kernel& kernel, Edge f, Edge g, Edge h, Edge& result) {
  if (f <= 1) return result = f == true_edge ? g : h, true;
  if (g == h) return result = g, true;
  if (g == f) g = true_edge;
  if (g == (f ^ 1U)) g = false_edge;
  if (h == f) h = false_edge;
  if (h == (f ^ 1U)) h = true_edge;
  if (g == true_edge) return result = disjoin(kernel, f, h), true;
  if (g == false_edge) return result = conjoin(kernel, f ^ 1U, h), true;
  if (h == true_edge) return result = disjoin(kernel, f ^ 1U, g), true;
  if (h == false_edge) return result = conjoin(kernel, f, g), true;
  if (g == (h ^ 1U)) return result = exclusive_or(kernel, f, h), true;
  return false;
}

}  // namespace

Edge if_then_else(Kernel& kernel, Edge f, Edge g, Edge h) {
  Edge result = 0;
  if (reduce_ite(kernel, f, g, h, result)) return result;
  if ((f & 1U) != 0) {
    f ^= 1U;
    std::swap(g, h);
  }
  const Edge flip = g & 1U;
  g ^= flip;
  h ^= flip;
  if (kernel.cache.find(Ternary::Ite, f, g, h, result)) return result ^ flip;
  kernel.step();
  const std::uint32_t f_level = kernel.level(f), g_level = kernel.level(g), h_level = kernel.level(h);
  const std::uint32_t top = std::min({f_level, g_level, h_level});
  const std::uint32_t variable = kernel.variable(f_level == top ? f : g_level == top ? g : h);
  const Cofactors fs = cofactors(kernel, f, f_level == top), gs = cofactors(kernel, g, g_level == top),
                  hs = cofactors(kernel, h, h_level == top);
  const Edge low = if_then_else(kernel, fs.low, gs.low, hs.low);
  kernel.push(low);
  const Edge high = if_then_else(kernel, fs.high, gs.high, hs.high);
  kernel.pop();
  result = kernel.make(variable, low, high);
  kernel.cache.store(Ternary::Ite, f, g, h, result);
  return result ^ flip;
}

bool disjoint(Kernel& kernel, Edge f, Edge g) {
  if (f > g) std::swap(f, g);
  if (f <= 1) return f == false_edge || g == false_edge;
  if ((f ^ g) <= 1) return f != g;
  // Two regular edges are both true where all variables are.
  if (((f | g) & 1U) == 0) return false;
  Edge result = 0;
  if (kernel.cache.find(Binary::Disjoint, f, g, result)) return result == true_edge;
  kernel.step();
  const std::uint32_t f_level = kernel.level(f), g_level = kernel.level(g);
  const Cofactors fs = cofactors(kernel, f, f_level <= g_level),
                  gs = cofactors(kernel, g, g_level <= f_level);
  const bool answer = disjoint(kernel, fs.high, gs.high) && disjoint(kernel, fs.low, gs.low);
  kernel.cache.store(Binary::Disjoint, f, g, answer ? true_edge : false_edge);
  return answer;
}

}  // namespace heed::bdd
