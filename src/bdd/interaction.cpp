#include <bit>

#include "reorder.h"

/// Which variables stand together in the support of some root. A swap of two that do not changes no node;
/// most swaps are of this kind where a manager holds many small diagrams, such as the conjuncts of a
/// transition relation.
namespace heed::bdd {

namespace {
/// Supports of all nodes are kept for the time of the search; above this many bytes it is not worth it.
constexpr std::size_t most_bytes = std::size_t{1} << 28;
}  // namespace

void Reorderer::find_interactions() {
  const std::size_t words = row_words_;
  if (kernel_.used_ * words * sizeof(std::uint64_t) > most_bytes) return;
  std::vector<std::uint64_t> supports(kernel_.used_ * words, 0);
  for (std::size_t level = kernel_.at_level_.size(); level-- > 0;) {
    const std::uint32_t variable = kernel_.at_level_[level];
    for (std::uint32_t head : kernel_.tables_[variable].buckets) {
      for (std::uint32_t i = head; i != 0; i = kernel_.nodes_.get()[i].next) {
        const Node& node = kernel_.nodes_.get()[i];
        std::uint64_t* row = &supports[i * words];
        const std::uint64_t *low = &supports[(node.low >> 1) * words],
                            *high = &supports[(node.high >> 1) * words];
        for (std::size_t w = 0; w < words; ++w) row[w] = low[w] | high[w];
        row[variable >> 6] |= std::uint64_t{1} << (variable & 63U);
      }
    }
  }
  interactions_.assign(kernel_.level_of_.size() * words, 0);
  kernel_.handles.for_each([&](Edge edge) {
    const std::uint64_t* support = &supports[(edge >> 1) * words];
    for (std::size_t w = 0; w < words; ++w) {
      for (std::uint64_t rest = support[w]; rest != 0; rest &= rest - 1) {
        std::uint64_t* row = &interactions_[(w * 64 + std::countr_zero(rest)) * words];
        for (std::size_t u = 0; u < words; ++u) row[u] |= support[u];
      }
    }
  });
}

bool Reorderer::interact(std::uint32_t a, std::uint32_t b) const {
  if (interactions_.empty()) return true;
  return ((interactions_[a * row_words_ + (b >> 6)] >> (b & 63U)) & 1U) != 0;
}

}  // namespace heed::bdd
