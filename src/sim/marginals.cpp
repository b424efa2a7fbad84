#include <heed/sim/marginals.h>

#include <map>
#include <utility>

namespace heed::sim {

std::vector<std::vector<Rational>> reported_in_cell(const Chain& chain) {
  std::vector<std::vector<Rational>> result(chain.features.size(), std::vector<Rational>(chain.cells));
  std::map<std::uint32_t, Rational> layer{{0, 1}};
  for (std::uint32_t cell = 0; cell < chain.cells; ++cell) {
    const auto before = std::exchange(layer, {});
    for (const auto& [state, probability] : before)
      for (std::uint32_t i = chain.first[state]; i < chain.first[state + 1]; ++i) {
        const Chain::Step& step = chain.steps[i];
        const Rational share = probability * step.probability;
        for (std::size_t f = 0; f < chain.features.size(); ++f)
          if (step.seen >> f & 1) result[f][cell] += share;
        layer[step.next] += share;
      }
  }
  return result;
}

}  // namespace heed::sim
