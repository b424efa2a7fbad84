#include <heed/util/diagnostic.h>

#include <cassert>

#include "inspect.h"

namespace heed::bdd {

namespace {

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
  if (diagrams.empty()) return {};
  const Manager& manager = diagrams.front().manager();
  std::vector<Edge> roots;
  for (const Bdd& diagram : diagrams) {
    assert(&diagram.manager() == &manager);
    roots.push_back(diagram.id());
  }
  Serialised data = listed(*diagrams.front().kernel_, roots);
  std::vector<bool> used(manager.variable_count(), false);
  for (const Serialised::Node& node : data.nodes) used[node.variable] = true;
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
