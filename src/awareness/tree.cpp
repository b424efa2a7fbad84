// The perception tree: a refinement, one level per step.
//
//   level 1 (t) = f1(t)                         reached(k)(t+1) = level k (t) and not reset(t)
//   level n (t) = reached(n-1)(t) and fn(t)     reached(k)(0)   = false
//
// With latch, level n (t) holds as well where reached(n)(t) does, so a level outlives the flicker of its
// feature. Entities whose paths begin alike share the memory of the common beginning. \cite kamale.22.arxiv
#include "policy_compiler.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {

/// The path of \p entity, root first; nothing when the tree names a feature that it does not have.
std::optional<std::vector<Reason>> PolicyCompiler::levels(std::size_t entity) {
  std::vector<Reason> path;
  for (const Item& item : order_) {
    const auto found = select(entity, item);
    if (found.empty() && !item.is_role) {
      note("off-the-tree",
           fmt::format("the tree does not lead to '{}': its description has no '{}'",
                       catalogue_.entities[entity].label, item.text),
           "name a feature that it has, or a role");
      return std::nullopt;
    }
    for (const Entailed& has : found) path.push_back(reason(has));
  }
  if (path.empty()) return std::nullopt;
  return path;
}

/// The name of the memory of the first \p count levels; "a_b, c" and "a, b_c" get different ones.
std::string PolicyCompiler::memory_name(const std::vector<Reason>& levels, std::size_t count) {
  std::vector<std::string> atoms;
  for (std::size_t i = 0; i < count; ++i) atoms.push_back(levels[i].atom);
  auto [place, fresh] = memory_names_.emplace(atoms, "");
  if (fresh) place->second = memory_atoms_.claim(fmt::format("reached_{}", fmt::join(atoms, "_")));
  return place->second;
}

void PolicyCompiler::remember(const std::vector<Reason>& levels, std::size_t count,
                              const logic::Formula& reached) {
  const std::string name = memory_name(levels, count);
  const bool known = std::any_of(result_.memories.begin(), result_.memories.end(),
                                 [&](const LevelMemory& memory) { return memory.name == name; });
  if (known) return;
  std::vector<std::string> atoms;
  for (std::size_t i = 0; i < count; ++i) atoms.push_back(levels[i].atom);
  result_.memories.push_back({name, reached && !options_.reset,
                              fmt::format("the tree was walked up to {} {}", fmt::join(atoms, " -> "),
                                          options_.latch ? "at an earlier step" : "one step before")});
}

Rule PolicyCompiler::tree_rule(std::size_t entity) {
  const auto path = levels(entity);
  if (!path) return {};
  Rule reached;
  std::vector<owl::AxiomId> axioms;
  for (std::size_t n = 1; n <= path->size(); ++n) {
    std::vector<Reason> parts{(*path)[n - 1]};
    if (n > 1) {
      remember(*path, n - 1, reached.formula);
      parts.insert(parts.begin(), Reason{memory_name(*path, n - 1), axioms});
    }
    reached = all_rule(parts);
    axioms = reached.evidence.front().axioms;
    if (!options_.latch) continue;
    reached = either(reached, all_rule({{memory_name(*path, n), axioms}}));
    remember(*path, n, reached.formula);
  }
  return reached;
}

}  // namespace heed::awareness
