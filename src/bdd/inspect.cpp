#include <algorithm>
#include <cassert>
#include <cmath>

#include "inspect.h"
#include "walk.h"

/// What reads diagrams and makes no nodes. The two polarities of a node are counted apart, since 1 - x would
/// lose every count that is small against the number of assignments.
namespace heed::bdd {

std::vector<std::uint32_t> support_variables(Kernel& kernel, Edge f) {
  std::vector<bool> found(kernel.variable_count() + 1, false);
  const Edge roots[] = {f};
  const Walk below(kernel, roots);
  for (std::size_t i = 1; i < below.size(); ++i) found[below.node(i).variable] = true;
  std::vector<std::uint32_t> variables;
  variables.reserve(std::min(below.size() - 1, kernel.variable_count()));
  for (std::uint32_t v = 1; v < found.size(); ++v) {
    if (found[v]) variables.push_back(v);
  }
  return variables;
}

bool depends_on(Kernel& kernel, Edge f, std::uint32_t variable) {
  const Edge roots[] = {f};
  const Walk below(kernel, roots);
  for (std::size_t i = 1; i < below.size(); ++i)
    if (below.node(i).variable == variable) return true;
  return false;
}

std::size_t shared_size(Kernel& kernel, std::span<const Edge> roots) {
  return Walk(kernel, roots).size();
}

namespace {

/// What is counted for both polarities of a node.
template <typename Number>
struct Polarities {
  Number by_complement[2];
};

/// \p at_terminal and the mean or sum that \p join makes of the two children's, from the bottom up. \returns
/// that of \p f
template <typename Number, typename Join>
Number fold(Kernel& kernel, Edge f, const Polarities<Number>& at_terminal, Join&& join) {
  const Edge roots[] = {f};
  const Walk below(kernel, roots);
  std::vector<Polarities<Number>> values(1, at_terminal);
  values.reserve(below.size());
  for (std::size_t i = 1; i < below.size(); ++i) {
    const Node& node = below.node(i);
    const Polarities<Number>& low = values[below.number(node.low)];
    const Polarities<Number>& high = values[below.number(node.high)];
    const Edge flip = node.low & 1U;
    values.push_back({{join(node, low.by_complement[flip], high.by_complement[0]),
                       join(node, low.by_complement[flip ^ 1U], high.by_complement[1])}});
  }
  return values.back().by_complement[f & 1U];
}

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

/// Variables up to which every density but 0 is far from the least double, so that halving is exact.
constexpr std::size_t most_for_double = 900;

Scaled density(Kernel& kernel, Edge f) {
  if (kernel.variable_count() > most_for_double) {
    return fold<Scaled>(kernel, f, {{{1, 0}, {0, 0}}},
                        [](const Node&, const Scaled& low, const Scaled& high) { return mean(low, high); });
  }
  return {fold<double>(kernel, f, {{1, 0}},
                       [](const Node&, double low, double high) { return (low + high) / 2; }),
          0};
}

}  // namespace

double count_double(Kernel& kernel, Edge f, std::size_t variables) {
  const Scaled part = density(kernel, f);
  const long exponent = part.exponent + static_cast<long>(variables);
  return std::ldexp(part.mantissa, static_cast<int>(std::clamp(exponent, -5000L, 5000L)));
}

Words count_exactly(Kernel& kernel, Edge f, std::size_t variables) {
  std::vector<std::uint32_t> support = support_variables(kernel, f);
  assert(support.size() <= variables);
  std::sort(support.begin(), support.end(),
            [&](std::uint32_t a, std::uint32_t b) { return kernel.level_of(a) < kernel.level_of(b); });
  std::vector<std::size_t> rank(kernel.variable_count() + 1, support.size());
  for (std::size_t i = 0; i < support.size(); ++i) rank[support[i]] = i;
  const auto below = [&](const Node& node, const Words& count, Edge child) {
    return shifted_left(count, rank[kernel.variable(child)] - rank[node.variable] - 1);
  };
  const Words count =
      fold<Words>(kernel, f, {{{1}, {}}}, [&](const Node& node, const Words& low, const Words& high) {
        return sum(below(node, low, node.low), below(node, high, node.high));
      });
  return shifted_left(count, variables - support.size());
}

Serialised listed(Kernel& kernel, std::span<const Edge> roots) {
  Serialised data;
  Walk below(kernel);
  for (const Edge root : roots) {
    below.add(root);
    data.roots.push_back(below.reference(root));
  }
  for (std::size_t i = 1; i < below.size(); ++i) {
    const Node& node = below.node(i);
    data.nodes.push_back({node.variable - 1, below.reference(node.low), below.reference(node.high)});
  }
  return data;
}

}  // namespace heed::bdd
