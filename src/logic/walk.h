#pragma once

#include <heed/logic/formula.h>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace heed::logic {

/// A part of a formula in a context that a number describes (how many Nexts stand above it, its polarity,
/// ...).
struct InContext {
  Formula formula;
  std::size_t context = 0;
};

struct ContextKey {
  const void* identity;
  std::size_t context;
  friend bool operator==(const ContextKey&, const ContextKey&) = default;
};

struct ContextKeyHash {
  std::size_t operator()(const ContextKey& key) const {
    return std::hash<const void*>()(key.identity) * 31 + key.context;
  }
};

/// Computes a formula bottom-up without recursion: `children(part)` lists what a part depends on, all of it
/// strictly smaller; `build(part, results)` makes its result from theirs. Each (node, context) is built once.
template <class Children, class Build>
Formula fold(const InContext& root, Children children, Build build) {
  struct Frame {
    InContext part;
    std::vector<InContext> needs{};
    bool entered = false;
  };
  const auto key = [](const InContext& part) { return ContextKey{part.formula.identity(), part.context}; };
  std::unordered_map<ContextKey, Formula, ContextKeyHash> done;
  std::vector<Frame> open;
  open.push_back({root});
  while (!open.empty()) {
    if (done.contains(key(open.back().part))) {
      open.pop_back();
    } else if (!open.back().entered) {
      open.back().entered = true;
      open.back().needs = children(open.back().part);
      const std::vector<InContext> needs = open.back().needs;
      for (const InContext& need : needs) open.push_back({need});
    } else {
      std::vector<Formula> results;
      for (const InContext& need : open.back().needs) results.push_back(done.at(key(need)));
      done.emplace(key(open.back().part), build(open.back().part, std::move(results)));
      open.pop_back();
    }
  }
  return done.at(key(root));
}

/// The node with new operands; itself where nothing changed, so that parts stay shared and keep their place.
[[nodiscard]] inline Formula rebuild(const Formula& formula, std::vector<Formula> operands) {
  bool same = true;
  for (std::size_t i = 0; i < operands.size(); ++i)
    same = same && operands[i].identity() == formula[i].identity();
  if (same) return formula;
  return Formula::make(formula.op(), std::move(operands), formula.location());
}

}  // namespace heed::logic
