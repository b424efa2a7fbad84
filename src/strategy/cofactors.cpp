#include "cofactors.h"

#include <heed/util/hash.h>

#include <algorithm>
#include <cassert>

namespace heed::strategy {

Cofactors::Cofactors(bdd::Manager& manager, const std::vector<bdd::Var>& order, std::size_t width)
    : width_(width), table_(64, none), rest_(width) {
  literals_.reserve(order.size());
  for (const bdd::Var variable : order)
    literals_.push_back({manager.literal(variable, false), manager.literal(variable, true)});
}

Cofactors::Id Cofactors::make_step(Id id, bool value) {
  const std::uint32_t depth = nodes_[id].depth;
  const bdd::Bdd& literal = literals_[depth][value ? 1 : 0];
  const std::span<const bdd::Bdd> before = functions(id);
  for (std::size_t i = 0; i < width_; ++i)
    rest_[i] = before[i].is_constant() ? before[i] : before[i].cofactor(literal);
  const Id next = intern(depth + 1, rest_);
  nodes_[id].next[value ? 1 : 0] = next;
  return next;
}

std::uint64_t Cofactors::hash_of(std::uint32_t depth, std::span<const bdd::Bdd> functions) const {
  std::uint64_t hash = depth;
  for (const bdd::Bdd& function : functions) hash = util::mix(hash, function.id());
  return hash;
}

Cofactors::Id Cofactors::intern(std::uint32_t depth, std::span<const bdd::Bdd> functions) {
  assert(functions.size() == width_);
  const std::size_t mask = table_.size() - 1;
  std::size_t at = hash_of(depth, functions) & mask;
  for (; table_[at] != none; at = (at + 1) & mask) {
    const Id id = table_[at];
    const std::span<const bdd::Bdd> known = this->functions(id);
    if (nodes_[id].depth == depth && std::equal(known.begin(), known.end(), functions.begin())) return id;
  }
  const Id id = static_cast<Id>(nodes_.size());
  if (id % chunk_vectors == 0) chunks_.push_back(std::make_unique<bdd::Bdd[]>(chunk_vectors * width_));
  nodes_.push_back({{none, none}, depth});
  std::copy(functions.begin(), functions.end(), &chunks_[id / chunk_vectors][id % chunk_vectors * width_]);
  table_[at] = id;
  if (2 * nodes_.size() > table_.size()) grow();
  return id;
}

void Cofactors::grow() {
  std::vector<Id> wider(2 * table_.size(), none);
  const std::size_t mask = wider.size() - 1;
  for (Id id = 0; id < nodes_.size(); ++id) {
    std::size_t at = hash_of(nodes_[id].depth, functions(id)) & mask;
    while (wider[at] != none) at = (at + 1) & mask;
    wider[at] = id;
  }
  table_ = std::move(wider);
}

}  // namespace heed::strategy
