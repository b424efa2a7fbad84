#include "units.h"

#include <algorithm>
#include <numeric>

namespace heed::awareness {

bool equivalent(const Catalogue& catalogue, std::size_t a, std::size_t b) {
  return catalogue.is_below(a, b) != nullptr && catalogue.is_below(b, a) != nullptr;
}

bool within(const Catalogue& catalogue, std::size_t a, std::size_t b) {
  return a == b || catalogue.is_below(a, b) != nullptr;
}

std::vector<std::size_t> bottom_up(const Catalogue& catalogue) {
  std::vector<std::size_t> below(catalogue.entities.size(), 0);
  for (std::size_t d = 0; d < catalogue.entities.size(); ++d)
    for (const Entailed& up : catalogue.entities[d].ancestors)
      if (!equivalent(catalogue, d, up.index)) ++below[up.index];
  std::vector<std::size_t> order(catalogue.entities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return below[a] < below[b]; });
  return order;
}

Units::Units(const Catalogue& catalogue, bool closed) : children(catalogue.entities.size()) {
  const auto& all = catalogue.entities;
  for (std::size_t d = 0; d < all.size(); ++d)
    for (const Entailed& up : all[d].parents)
      if (all[d].satisfiable && !equivalent(catalogue, d, up.index)) children[up.index].push_back(d);
  for (const std::size_t e : bottom_up(catalogue))
    if (all[e].satisfiable && (!closed || children[e].empty())) entities.push_back(e);
}

}  // namespace heed::awareness
