#include "cofactors.h"

#include <heed/util/hash.h>

namespace heed::strategy {

Cofactors::Id Cofactors::step(Id id, bool value) {
  if (const Id known = nodes_[id].next[value ? 1 : 0]; known != none) return known;
  const std::uint32_t depth = nodes_[id].depth;
  const bdd::Var variable = order_[depth];
  std::vector<bdd::Bdd> rest;
  rest.reserve(nodes_[id].functions.size());
  for (const bdd::Bdd& function : nodes_[id].functions)
    rest.push_back(function.is_constant() ? function : function.cofactor(variable, value));
  const Id next = intern(depth + 1, std::move(rest));
  nodes_[id].next[value ? 1 : 0] = next;
  return next;
}

Cofactors::Id Cofactors::intern(std::uint32_t depth, std::vector<bdd::Bdd> functions) {
  std::uint64_t hash = functions.size();
  for (const bdd::Bdd& function : functions) hash = util::mix(hash, function.id());
  const auto bucket = index_[depth].try_emplace(hash, none).first;
  for (Id id = bucket->second; id != none; id = nodes_[id].same_hash)
    if (nodes_[id].functions == functions) return id;
  const Id id = static_cast<Id>(nodes_.size());
  nodes_.push_back({std::move(functions), depth, {none, none}, bucket->second});
  bucket->second = id;
  return id;
}

}  // namespace heed::strategy
