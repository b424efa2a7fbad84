#include <heed/export/symbolic_runner.h>

#include <algorithm>

namespace heed::exporter {
namespace {

using model::evaluate;

std::size_t width(const std::vector<model::Output>& columns) {
  std::size_t bits = 0;
  for (const model::Output& column : columns) bits += model::bit_width(column.variable.domain);
  return bits;
}

/// The value that the bits from \p position on spell; \p position moves behind them.
std::int32_t read(const model::Domain& domain, const std::vector<bool>& bits, std::size_t& position) {
  std::int64_t value = 0;
  for (std::size_t i = model::bit_width(domain); i > 0; --i) value = 2 * value + (bits[position++] ? 1 : 0);
  return static_cast<std::int32_t>(value + domain.low);
}

}  // namespace

SymbolicRunner::SymbolicRunner(model::SymbolicController controller)
    : controller_(std::make_shared<const model::SymbolicController>(std::move(controller))) {
  for (const model::Variable& input : controller_->inputs) inputs_ += model::bit_width(input.domain);
  outputs_ = width(controller_->outputs);
  memories_ = width(controller_->memories);
  reset();
}

void SymbolicRunner::reset() {
  state_ = {false, 0, std::vector<bool>(inputs_ + outputs_ + memories_, false)};
}

/// Bits by number: current ones as they are, next ones of the inputs; before the first step those are the
/// current ones. Empty where a value is none of its domain's.
std::vector<bool> SymbolicRunner::with_observation(const model::Valuation& observation) const {
  std::vector<bool> bits(2 * state_.bits.size());
  for (std::size_t p = 0; p < state_.bits.size(); ++p) bits[2 * p] = state_.bits[p];
  if (observation.size() != controller_->inputs.size()) return {};
  std::size_t position = 0;
  for (std::size_t i = 0; i < observation.size(); ++i) {
    const model::Domain& domain = controller_->inputs[i].domain;
    if (observation[i] < domain.low || observation[i] > domain.high) return {};
    const std::int64_t distance = std::int64_t{observation[i]} - domain.low;
    for (std::size_t weight = model::bit_width(domain); weight-- > 0; ++position)
      bits[2 * position + (state_.started ? 1 : 0)] = ((distance >> weight) & 1) != 0;
  }
  if (state_.started) choose_updates(bits);
  return bits;
}

void SymbolicRunner::choose_updates(std::vector<bool>& bits) const {
  for (std::size_t i = 0; i < memories_; ++i)
    bits[2 * (inputs_ + outputs_ + i) + 1] = evaluate(controller_->diagrams, controller_->updates[i], bits);
}

bool SymbolicRunner::accepted(const std::vector<bool>& bits) const {
  const auto& controller = *controller_;
  const auto holds = [&](model::Function function) { return evaluate(controller.diagrams, function, bits); };
  if (bits.size() != 2 * state_.bits.size()) return false;
  return state_.started ? std::all_of(controller.legal.begin(), controller.legal.end(), holds)
                        : holds(controller.start.answered);
}

bool SymbolicRunner::answers(const model::Valuation& observation) const {
  return accepted(with_observation(observation));
}

std::optional<model::Valuation> SymbolicRunner::step(const model::Valuation& observation) {
  std::vector<bool> bits = with_observation(observation);
  if (!accepted(bits)) return std::nullopt;
  const auto& controller = *controller_;
  const auto value = [&](model::Function function) { return evaluate(controller.diagrams, function, bits); };
  if (!state_.started) {
    for (std::size_t i = 0; i < memories_; ++i)
      bits[2 * (inputs_ + outputs_ + i)] = value(controller.start.memories[i]);
    for (std::size_t i = 0; i < outputs_; ++i) bits[2 * (inputs_ + i)] = value(controller.start.outputs[i]);
    for (std::size_t p = 0; p < state_.bits.size(); ++p) state_.bits[p] = bits[2 * p];
    state_.started = true;
    return columns();
  }
  const auto& goal = controller.goals[state_.goal];
  for (std::size_t i = 0; i < outputs_; ++i) bits[2 * (inputs_ + i) + 1] = value(goal.answers[i]);
  if (value(goal.met)) state_.goal = (state_.goal + 1) % static_cast<std::uint32_t>(controller.goals.size());
  for (std::size_t p = 0; p < state_.bits.size(); ++p) state_.bits[p] = bits[2 * p + 1];
  return columns();
}

model::Valuation SymbolicRunner::columns() const {
  model::Valuation result;
  std::size_t position = inputs_;
  for (const auto* list : {&controller_->outputs, &controller_->memories})
    for (const model::Output& column : *list)
      result.push_back(read(column.variable.domain, state_.bits, position));
  std::vector<bool> bits(2 * state_.bits.size());
  for (std::size_t p = 0; p < state_.bits.size(); ++p) bits[2 * p] = state_.bits[p];
  for (const model::Function function : controller_->derived)
    result.push_back(evaluate(controller_->diagrams, function, bits) ? 1 : 0);
  return result;
}

}  // namespace heed::exporter
