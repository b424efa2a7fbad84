#include <algorithm>

#include "operations.h"

/// Quantification, alone and inside a conjunction, and the shift from current to next variables inside
/// another operation. A cube's variables above the operands' tops cannot matter and are dropped before the
/// cache is asked, so that calls that differ only there share their results. \cite burch.94.tcad
namespace heed::bdd {

namespace {

Edge skip_above(const Kernel& kernel, Edge cube, std::uint32_t level) {
  while (kernel.level(cube) < level) cube = kernel.node(cube).high;
  return cube;
}

/// The disjunction of two intermediate results.
Edge join(Kernel& kernel, Edge low, Edge high) {
  if (low == true_edge || high == true_edge) return true_edge;
  kernel.push(low);
  kernel.push(high);
  const Edge result = disjoin(kernel, low, high);
  kernel.pop(2);
  return result;
}

}  // namespace

Edge exists(Kernel& kernel, Edge f, Edge cube) {
  if (f <= 1) return f;
  const std::uint32_t top = kernel.level(f);
  cube = skip_above(kernel, cube, top);
  if (cube == true_edge) return f;
  Edge result = 0;
  if (kernel.cache.find(Binary::Exists, f, cube, result)) return result;
  kernel.step();
  const Edge f_low = kernel.low(f), f_high = kernel.high(f);
  const std::uint32_t variable = kernel.variable(f);
  if (kernel.level(cube) == top) {
    const Edge rest = kernel.node(cube).high;
    result = exists(kernel, f_low, rest);
    if (result != true_edge && result != f_high) {
      kernel.push(result);
      const Edge high = exists(kernel, f_high, rest);
      kernel.pop();
      result = join(kernel, result, high);
    }
  } else {
    const Edge low = exists(kernel, f_low, cube);
    kernel.push(low);
    const Edge high = exists(kernel, f_high, cube);
    kernel.pop();
    result = kernel.make(variable, low, high);
  }
  kernel.cache.store(Binary::Exists, f, cube, result);
  return result;
}

namespace {

Edge and_exists_step(Kernel& kernel, Edge f, Edge g, Edge cube) {
  const std::uint32_t f_level = kernel.level(f), g_level = kernel.level(g);
  const std::uint32_t variable = kernel.variable(f_level <= g_level ? f : g);
  const Cofactors fs = cofactors(kernel, f, f_level <= g_level),
                  gs = cofactors(kernel, g, g_level <= f_level);
  if (kernel.variable(cube) != variable) {
    const Edge low = and_exists(kernel, fs.low, gs.low, cube);
    kernel.push(low);
    const Edge high = and_exists(kernel, fs.high, gs.high, cube);
    kernel.pop();
    return kernel.make(variable, low, high);
  }
  const Edge rest = kernel.node(cube).high;
  const Edge low = and_exists(kernel, fs.low, gs.low, rest);
  // The other half is within either operand, so it adds nothing where the first half equals one.
  if (low == true_edge || low == fs.high || low == gs.high) return low;
  kernel.push(low);
  const Edge high = and_exists(kernel, fs.high, gs.high, rest);
  kernel.pop();
  return join(kernel, low, high);
}

}  // namespace

Edge and_exists(Kernel& kernel, Edge f, Edge g, Edge cube) {
  if (f > g) std::swap(f, g);
  if (f <= 1) return f == true_edge ? exists(kernel, g, cube) : false_edge;
  if ((f ^ g) <= 1) return f == g ? exists(kernel, f, cube) : false_edge;
  cube = skip_above(kernel, cube, std::min(kernel.level(f), kernel.level(g)));
  if (cube == true_edge) return conjoin(kernel, f, g);
  Edge result = 0;
  if (kernel.cache.find(Ternary::AndExists, f, g, cube, result)) return result;
  kernel.step();
  result = and_exists_step(kernel, f, g, cube);
  kernel.cache.store(Ternary::AndExists, f, g, cube, result);
  return result;
}

namespace {

/// \p target maps a variable to the one that replaces it, on an adjacent level that the diagram does not use.
template <Binary op, std::uint32_t (Kernel::*target)(std::uint32_t) const>
Edge shift(Kernel& kernel, Edge f) {
  if (f <= 1) return f;
  const Edge flip = f & 1U;
  f ^= flip;
  Edge result = 0;
  if (kernel.cache.find(op, f, f, result)) return result ^ flip;
  kernel.step();
  const Node here = kernel.node(f);
  const Edge low = shift<op, target>(kernel, here.low);
  kernel.push(low);
  const Edge high = shift<op, target>(kernel, here.high);
  kernel.pop();
  const std::uint32_t variable = (kernel.*target)(here.variable);
  assert(kernel.level_of(variable) < std::min(kernel.level(low), kernel.level(high)));
  result = kernel.make(variable, low, high);
  kernel.cache.store(op, f, f, result);
  return result ^ flip;
}

}  // namespace

Edge shift_next(Kernel& kernel, Edge f) {
  return shift<Binary::Next, &Kernel::next_of>(kernel, f);
}
Edge shift_current(Kernel& kernel, Edge f) {
  return shift<Binary::Current, &Kernel::current_of>(kernel, f);
}

namespace {

/// One step of an operation whose second operand is read shifted.
struct ShiftedStep {
  std::uint32_t variable;
  Cofactors f, g;

  ShiftedStep(const Kernel& kernel, Edge f_edge, Edge g_edge) {
    const std::uint32_t g_variable = kernel.next_of(kernel.variable(g_edge));
    const std::uint32_t f_level = kernel.level(f_edge), g_level = kernel.level_of(g_variable);
    variable = f_level <= g_level ? kernel.variable(f_edge) : g_variable;
    f = cofactors(kernel, f_edge, f_level <= g_level);
    g = cofactors(kernel, g_edge, g_level <= f_level);
  }
};

}  // namespace

Edge and_next(Kernel& kernel, Edge f, Edge g) {
  if (f == false_edge || g == false_edge) return false_edge;
  if (g == true_edge) return f;
  if (f == true_edge) return shift_next(kernel, g);
  Edge result = 0;
  if (kernel.cache.find(Binary::AndNext, f, g, result)) return result;
  kernel.step();
  const ShiftedStep here(kernel, f, g);
  const Edge low = and_next(kernel, here.f.low, here.g.low);
  kernel.push(low);
  const Edge high = and_next(kernel, here.f.high, here.g.high);
  kernel.pop();
  result = kernel.make(here.variable, low, high);
  kernel.cache.store(Binary::AndNext, f, g, result);
  return result;
}

Edge and_exists_next(Kernel& kernel, Edge f, Edge g, Edge cube) {
  if (f == false_edge || g == false_edge) return false_edge;
  if (g == true_edge) return exists(kernel, f, cube);
  const std::uint32_t g_level = kernel.level_of(kernel.next_of(kernel.variable(g)));
  cube = skip_above(kernel, cube, std::min(kernel.level(f), g_level));
  if (cube == true_edge) return and_next(kernel, f, g);
  Edge result = 0;
  if (kernel.cache.find(Ternary::AndExistsNext, f, g, cube, result)) return result;
  kernel.step();
  const ShiftedStep here(kernel, f, g);
  if (kernel.variable(cube) != here.variable) {
    const Edge low = and_exists_next(kernel, here.f.low, here.g.low, cube);
    kernel.push(low);
    const Edge high = and_exists_next(kernel, here.f.high, here.g.high, cube);
    kernel.pop();
    result = kernel.make(here.variable, low, high);
  } else {
    const Edge rest = kernel.node(cube).high;
    result = and_exists_next(kernel, here.f.low, here.g.low, rest);
    if (result != true_edge && result != here.f.high) {
      kernel.push(result);
      const Edge high = and_exists_next(kernel, here.f.high, here.g.high, rest);
      kernel.pop();
      result = join(kernel, result, high);
    }
  }
  kernel.cache.store(Ternary::AndExistsNext, f, g, cube, result);
  return result;
}

}  // namespace heed::bdd
