#include <heed/util/diagnostic.h>

#include <algorithm>
#include <cassert>

#include "kernel.h"
#include "visit.h"

namespace heed::bdd {

namespace {

/// Children before parents, in the order of a depth-first walk. Depth is bounded by the number of variables.
void list_bottom_up(const Bdd& diagram, Numbering& seen, std::vector<Bdd>& listed) {
  if (diagram.is_constant() || seen.find(diagram.id() >> 1) != Numbering::absent) return;
  const Bdd regular = (diagram.id() & 1U) != 0 ? !diagram : diagram;
  list_bottom_up(regular.low(), seen, listed);
  list_bottom_up(regular.high(), seen, listed);
  seen.insert(diagram.id() >> 1);
  listed.push_back(regular);
}

[[noreturn]] void refuse(const std::string& what) {
  throw util::InputError(util::Location{}, "bad-diagram", what,
                         "was it written by the same version of heed?");
}

Bdd referenced(Manager& manager, const std::vector<Bdd>& built, std::uint32_t reference) {
  const std::size_t index = reference >> 1;
  if (index > built.size())
    refuse("a diagram refers to node " + std::to_string(index) + " before it is defined");
  const Bdd regular = index == 0 ? manager.constant(true) : built[index - 1];
  return (reference & 1U) != 0 ? !regular : regular;
}

}  // namespace

Serialised serialise(std::span<const Bdd> diagrams) {
  Serialised data;
  if (diagrams.empty()) return data;
  Numbering seen;
  seen.insert(0);
  std::vector<Bdd> listed;
  const auto reference = [&](const Bdd& f) { return (seen.find(f.id() >> 1) << 1) | (f.id() & 1U); };
  for (const Bdd& diagram : diagrams) {
    assert(&diagram.manager() == &diagrams.front().manager());
    list_bottom_up(diagram, seen, listed);
    data.roots.push_back(reference(diagram));
  }
  const Manager& manager = diagrams.front().manager();
  std::vector<bool> used(manager.variable_count(), false);
  for (const Bdd& node : listed) {
    data.nodes.push_back({node.top(), reference(node.low()), reference(node.high())});
    used[node.top()] = true;
  }
  for (const Var variable : manager.order()) {
    if (used[variable]) data.order.push_back(variable);
  }
  return data;
}

std::vector<Bdd> deserialise(Manager& manager, const Serialised& data, std::span<const Var> map) {
  std::vector<Bdd> built;
  for (const Serialised::Node& node : data.nodes) {
    if (!map.empty() && node.variable >= map.size()) refuse("a diagram uses a variable that is not mapped");
    const Var variable = map.empty() ? node.variable : map[node.variable];
    if (variable >= manager.variable_count()) refuse("a diagram uses a variable that does not exist");
    const Bdd low = referenced(manager, built, node.low), high = referenced(manager, built, node.high);
    built.push_back(manager.variable(variable).ite(high, low));
  }
  std::vector<Bdd> roots;
  for (const std::uint32_t root : data.roots) roots.push_back(referenced(manager, built, root));
  return roots;
}

}  // namespace heed::bdd
