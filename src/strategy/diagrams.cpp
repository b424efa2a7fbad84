#include "diagrams.h"

namespace heed::strategy {

model::Function DiagramWriter::add(const bdd::Bdd& function) {
  functions_.push_back(function);
  return static_cast<model::Function>(functions_.size() - 1);
}

std::vector<model::Function> DiagramWriter::add(const std::vector<bdd::Bdd>& functions) {
  std::vector<model::Function> places;
  places.reserve(functions.size());
  for (const bdd::Bdd& function : functions) places.push_back(add(function));
  return places;
}

model::Diagrams DiagramWriter::finish() {
  std::vector<std::uint32_t> bit_of(game_.manager->variable_count());
  std::uint32_t bit = 0;
  for (const game::Encoded& variable : game_.variables)
    for (const bdd::Pair& pair : variable.bits) {
      bit_of[pair.current] = bit++;
      bit_of[pair.next] = bit++;
    }
  const bdd::Serialised data = bdd::serialise(functions_);
  roots_ = data.roots;
  functions_.clear();
  model::Diagrams diagrams;
  for (const bdd::Var variable : game_.manager->order()) diagrams.order.push_back(bit_of[variable]);
  diagrams.nodes.reserve(data.nodes.size());
  for (const auto& node : data.nodes) diagrams.nodes.push_back({bit_of[node.variable], node.low, node.high});
  return diagrams;
}

}  // namespace heed::strategy
