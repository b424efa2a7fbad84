#include <algorithm>
#include <cmath>

#include "inspect.h"
#include "operations.h"
#include "visit.h"

/// What reads diagrams and makes no nodes. Results of counting are kept by edge, not by node: the two
/// polarities of a node are counted apart, since 1 - x would lose every count that is small against the
/// number of assignments.
namespace heed::bdd {

namespace {

/// The nodes below \p roots, parents before children within a path, as indices; the terminal is among them.
Numbering reachable(const Kernel& kernel, std::span<const Edge> roots) {
  Numbering seen;
  seen.insert(0);
  for (const Edge root : roots) seen.insert(root >> 1);
  for (std::size_t i = 1; i < seen.keys().size(); ++i) {
    const Node& node = kernel.node(seen.keys()[i] << 1);
    seen.insert(node.low >> 1);
    seen.insert(node.high >> 1);
  }
  return seen;
}

/// All edges below \p root, children before parents.
std::vector<Edge> edges_bottom_up(const Kernel& kernel, Edge root) {
  Numbering seen;
  seen.insert(root);
  for (std::size_t i = 0; i < seen.keys().size(); ++i) {
    const Edge edge = seen.keys()[i];
    if (edge <= 1) continue;
    seen.insert(kernel.low(edge));
    seen.insert(kernel.high(edge));
  }
  std::vector<Edge> edges = seen.keys();
  std::stable_sort(edges.begin(), edges.end(),
                   [&](Edge a, Edge b) { return kernel.level(a) > kernel.level(b); });
  return edges;
}

Numbering numbered(const std::vector<Edge>& edges) {
  Numbering numbers;
  for (const Edge edge : edges) numbers.insert(edge);
  return numbers;
}

}  // namespace

std::vector<std::uint32_t> support_variables(const Kernel& kernel, Edge f) {
  const Edge roots[] = {f};
  std::vector<bool> found(kernel.variable_count() + 1, false);
  const Numbering below = reachable(kernel, roots);
  for (const std::uint32_t index : below.keys()) found[kernel.variable(index << 1)] = true;
  std::vector<std::uint32_t> variables;
  for (std::uint32_t v = 1; v < found.size(); ++v) {
    if (found[v]) variables.push_back(v);
  }
  return variables;
}

std::size_t shared_size(const Kernel& kernel, std::span<const Edge> roots) {
  return reachable(kernel, roots).keys().size();
}

namespace {

/// mantissa * 2^exponent: a density may be far below what a double's exponent can say.
struct Scaled {
  double mantissa;
  long exponent;
};

Scaled mean(const Scaled& a, const Scaled& b) {
  if (a.mantissa == 0) return {b.mantissa, b.exponent - 1};
  if (b.mantissa == 0) return {a.mantissa, a.exponent - 1};
  const long exponent = std::max(a.exponent, b.exponent);
  const auto aligned = [&](const Scaled& x) {
    return std::ldexp(x.mantissa, static_cast<int>(std::max(x.exponent - exponent, -2000L)));
  };
  int carry = 0;
  const double mantissa = std::frexp(aligned(a) + aligned(b), &carry);
  return {mantissa, exponent + carry - 1};
}

}  // namespace

double count_double(const Kernel& kernel, Edge f, std::size_t variables) {
  const std::vector<Edge> edges = edges_bottom_up(kernel, f);
  const Numbering numbers = numbered(edges);
  std::vector<Scaled> density;
  for (const Edge edge : edges) {
    density.push_back(
        edge <= 1 ? Scaled{edge == true_edge ? 1.0 : 0.0, 0}
                  : mean(density[numbers.find(kernel.low(edge))], density[numbers.find(kernel.high(edge))]));
  }
  const long exponent = density.back().exponent + static_cast<long>(variables);
  return std::ldexp(density.back().mantissa, static_cast<int>(std::clamp(exponent, -5000L, 5000L)));
}

Words count_exactly(const Kernel& kernel, Edge f, std::size_t variables) {
  if (f <= 1) return f == true_edge ? shifted_left({1}, variables) : Words{};
  std::vector<std::uint32_t> support = support_variables(kernel, f);
  assert(support.size() <= variables);
  std::sort(support.begin(), support.end(),
            [&](std::uint32_t a, std::uint32_t b) { return kernel.level_of(a) < kernel.level_of(b); });
  std::vector<std::size_t> rank(kernel.variable_count() + 1, support.size());
  for (std::size_t i = 0; i < support.size(); ++i) rank[support[i]] = i;

  const std::vector<Edge> edges = edges_bottom_up(kernel, f);
  const Numbering numbers = numbered(edges);
  std::vector<Words> counts;
  const auto below = [&](std::size_t here, Edge child) {
    return shifted_left(counts[numbers.find(child)], rank[kernel.variable(child)] - here - 1);
  };
  for (const Edge edge : edges) {
    if (edge <= 1) {
      counts.push_back(edge == true_edge ? Words{1} : Words{});
    } else {
      const std::size_t here = rank[kernel.variable(edge)];
      counts.push_back(sum(below(here, kernel.low(edge)), below(here, kernel.high(edge))));
    }
  }
  return shifted_left(counts.back(), variables - support.size());
}

}  // namespace heed::bdd
