#include "certify_support.h"

#include <heed/export/symbolic_runner.h>
#include <heed/util/random.h>

#include <map>
#include <vector>

namespace heed::reference {
namespace {

/// Steps to the next observation in ascending order. \returns false after the last
bool advance(model::Valuation& observation, const std::vector<model::Variable>& inputs) {
  for (std::size_t i = inputs.size(); i-- > 0;) {
    if (observation[i]++ < inputs[i].domain.high) return true;
    observation[i] = inputs[i].domain.low;
  }
  return false;
}

bool in_domains(const model::Valuation& columns, const std::vector<model::Output>& outputs) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i] < outputs[i].variable.domain.low || columns[i] > outputs[i].variable.domain.high)
      return false;
  return true;
}

/// Some function like \p function: its negation, a constant, a single bit, or it with one node turned.
model::Function changed(model::Diagrams& diagrams, model::Function function, util::CounterRandom& random) {
  const auto below = [&](std::size_t n) { return random.below(static_cast<std::uint32_t>(n)); };
  switch (below(4)) {
    case 0:
      return function ^ 1U;
    case 1:
      return below(2);
    case 2:
      return diagrams.nodes.empty() ? function ^ 1U : 2 * (1 + below(diagrams.nodes.size())) + below(2);
    default:
      break;
  }
  if (function >> 1 == 0) return function ^ 1U;
  diagrams.nodes.push_back(diagrams.nodes[(function >> 1) - 1]);
  diagrams.nodes.back().low ^= 1U;
  return 2 * static_cast<model::Function>(diagrams.nodes.size()) + (function & 1U);
}

}  // namespace

std::optional<model::Mealy> listed(const model::SymbolicController& controller, std::uint32_t most) {
  std::vector<model::Output> outputs = controller.outputs;
  outputs.insert(outputs.end(), controller.memories.begin(), controller.memories.end());
  outputs.insert(outputs.end(), controller.definitions.begin(), controller.definitions.end());
  model::MealyBuilder builder(controller.name, controller.inputs, outputs);
  const exporter::SymbolicRunner start(controller);
  std::map<exporter::SymbolicRunner::State, std::uint32_t> numbers{{start.state(), builder.add_state()}};
  std::vector<exporter::SymbolicRunner> open{start};
  model::Valuation observation;
  for (const auto& input : controller.inputs) observation.push_back(input.domain.low);
  for (std::uint32_t state = 0; state < open.size(); ++state) do {
      exporter::SymbolicRunner runner = open[state];
      const auto columns = runner.step(observation);
      if (!columns) continue;
      if (!in_domains(*columns, outputs) || open.size() > most) return std::nullopt;
      const auto found = numbers.find(runner.state());
      const std::uint32_t next = found != numbers.end() ? found->second : builder.add_state();
      if (found == numbers.end()) {
        numbers.emplace(runner.state(), next);
        open.push_back(runner);
      }
      builder.add(state, observation, *columns, next);
    } while (advance(observation, controller.inputs));
  return builder.finish();
}

model::SymbolicController mutated(const model::SymbolicController& controller, std::uint64_t seed) {
  model::SymbolicController result = controller;
  util::CounterRandom random(seed, 11);
  std::vector<model::Function*> places{&result.start.answered};
  const auto append = [&](std::vector<model::Function>& list) {
    for (model::Function& function : list) places.push_back(&function);
  };
  append(result.legal);
  append(result.start.memories);
  append(result.start.outputs);
  append(result.updates);
  append(result.derived);
  for (auto& goal : result.goals) {
    append(goal.answers);
    places.push_back(&goal.met);
  }
  model::Function& place = *places[random.below(static_cast<std::uint32_t>(places.size()))];
  place = changed(result.diagrams, place, random);
  return result;
}

model::Claim mutated(const model::Claim& claim, std::uint64_t seed) {
  model::Claim result = claim;
  util::CounterRandom random(seed, 12);
  std::vector<model::Function*> places;
  if (claim.realizable) places.push_back(&result.winning);
  for (auto& ranks : result.ranks)
    for (auto& level : ranks) places.push_back(&level.states);
  for (auto& round : result.rounds) {
    places.push_back(&round.lost);
    for (auto& chain : round.chains)
      for (model::Function& set : chain) places.push_back(&set);
  }
  if (places.empty()) return result;
  model::Function& place = *places[random.below(static_cast<std::uint32_t>(places.size()))];
  place = changed(result.diagrams, place, random);
  return result;
}

}  // namespace heed::reference
