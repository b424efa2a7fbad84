#include <algorithm>

#include "operations.h"

/// Cofactors by cubes, the two generalised cofactors, and composition. \cite coudert.90.iccad
namespace heed::bdd {

Edge cofactor(Kernel& kernel, Edge f, Edge cube) {
  if (f <= 1) return f;
  const std::uint32_t top = kernel.level(f);
  while (kernel.level(cube) < top) {
    const Edge high = kernel.high(cube);
    cube = high == false_edge ? kernel.low(cube) : high;
  }
  if (cube == true_edge) return f;
  const Edge flip = f & 1U;
  f ^= flip;
  if (kernel.level(cube) == top) {
    const Edge if_high = kernel.high(cube);
    return (if_high == false_edge ? cofactor(kernel, kernel.low(f), kernel.low(cube))
                                  : cofactor(kernel, kernel.high(f), if_high)) ^
           flip;
  }
  Edge result = 0;
  if (kernel.cache.find(Binary::Cofactor, f, cube, result)) return result ^ flip;
  kernel.step();
  const Node here = kernel.node(f);
  const Edge low = cofactor(kernel, here.low, cube);
  kernel.push(low);
  const Edge high = cofactor(kernel, here.high, cube);
  kernel.pop();
  result = kernel.make(here.variable, low, high);
  kernel.cache.store(Binary::Cofactor, f, cube, result);
  return result ^ flip;
}

namespace {

using GeneralisedCofactor = Edge (*)(Kernel&, Edge, Edge);

/// The step that restrict and constrain share: f and care are split by the topmost variable of the two.
Edge split(Kernel& kernel, Edge f, Edge care, GeneralisedCofactor recurse) {
  const std::uint32_t f_level = kernel.level(f), care_level = kernel.level(care);
  const std::uint32_t variable = kernel.variable(f_level <= care_level ? f : care);
  const Cofactors fs = cofactors(kernel, f, f_level <= care_level);
  const Cofactors cares = cofactors(kernel, care, care_level <= f_level);
  if (cares.low == false_edge) return recurse(kernel, fs.high, cares.high);
  if (cares.high == false_edge) return recurse(kernel, fs.low, cares.low);
  const Edge low = recurse(kernel, fs.low, cares.low);
  kernel.push(low);
  const Edge high = recurse(kernel, fs.high, cares.high);
  kernel.pop();
  return kernel.make(variable, low, high);
}

}  // namespace

Edge restrict_to(Kernel& kernel, Edge f, Edge care) {
  if (care == false_edge) return false_edge;
  if (care == true_edge || f <= 1) return f;
  if ((f ^ care) <= 1) return f == care ? true_edge : false_edge;
  const Edge flip = f & 1U;
  f ^= flip;
  Edge result = 0;
  if (kernel.cache.find(Binary::Restrict, f, care, result)) return result ^ flip;
  kernel.step();
  if (kernel.level(care) < kernel.level(f)) {
    const Edge either = disjoin(kernel, kernel.low(care), kernel.high(care));
    kernel.push(either);
    result = restrict_to(kernel, f, either);
    kernel.pop();
  } else {
    result = split(kernel, f, care, &restrict_to);
  }
  kernel.cache.store(Binary::Restrict, f, care, result);
  return result ^ flip;
}

Edge constrain_to(Kernel& kernel, Edge f, Edge care) {
  if (care == false_edge) return false_edge;
  if (care == true_edge || f <= 1) return f;
  if ((f ^ care) <= 1) return f == care ? true_edge : false_edge;
  const Edge flip = f & 1U;
  f ^= flip;
  Edge result = 0;
  if (kernel.cache.find(Binary::Constrain, f, care, result)) return result ^ flip;
  kernel.step();
  result = split(kernel, f, care, &constrain_to);
  kernel.cache.store(Binary::Constrain, f, care, result);
  return result ^ flip;
}

Edge compose(Kernel& kernel, Edge f, const Substitution& substitution) {
  const std::uint32_t level = kernel.level(f);
  if (f <= 1 || level > substitution.last_level) return f;
  const Edge flip = f & 1U;
  f ^= flip;
  Edge result = 0;
  if (kernel.cache.find(Binary::Compose, f, substitution.number, result)) return result ^ flip;
  kernel.step();
  const Node here = kernel.node(f);
  const Edge low = compose(kernel, here.low, substitution);
  kernel.push(low);
  const Edge high = compose(kernel, here.high, substitution);
  kernel.push(high);
  result = if_then_else(kernel, substitution.function[here.variable], high, low);
  kernel.pop(2);
  kernel.cache.store(Binary::Compose, f, substitution.number, result);
  return result ^ flip;
}

}  // namespace heed::bdd
