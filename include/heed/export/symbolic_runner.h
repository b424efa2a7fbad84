#pragma once

#include <heed/model/symbolic.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace heed::exporter {

/// Runs a symbolic controller as it is, by evaluating its functions. Copies share the controller, each has
/// its own state. A step costs O(bits * columns).
class SymbolicRunner {
 public:
  explicit SymbolicRunner(model::SymbolicController controller);

  /// Whether the present state answers \p observation: one value for each input, each in its domain.
  [[nodiscard]] bool answers(const model::Valuation& observation) const;
  /// The columns of the next step: outputs, memories, definitions. Nothing, and no step, where answers() is
  /// false.
  std::optional<model::Valuation> step(const model::Valuation& observation);
  /// Back before the first observation.
  void reset();

  [[nodiscard]] const model::SymbolicController& controller() const { return *controller_; }
  /// All that the future depends on: whether a step was made, the goal, and the current bits, by position.
  struct State {
    bool started = false;
    std::uint32_t goal = 0;
    std::vector<bool> bits;
    auto operator<=>(const State&) const = default;
  };
  [[nodiscard]] const State& state() const { return state_; }

 private:
  [[nodiscard]] std::vector<bool> with_observation(const model::Valuation& observation) const;
  [[nodiscard]] bool accepted(const std::vector<bool>& bits) const;
  void choose_updates(std::vector<bool>& bits) const;
  [[nodiscard]] model::Valuation columns() const;

  std::shared_ptr<const model::SymbolicController> controller_;
  std::size_t inputs_ = 0, outputs_ = 0, memories_ = 0;  ///< Bits of each.
  State state_;
};

}  // namespace heed::exporter
