#pragma once

#include <heed/model/mealy.h>
#include <heed/sim/profile.h>

#include <cstdint>
#include <string>
#include <vector>

namespace heed::sim {

/// How what is reported reaches the machine's inputs.
struct Binding {
  struct Wire {
    std::uint32_t feature = 0;  ///< Index into Chain::features.
    std::uint32_t input = 0;    ///< Index into Mealy::inputs.
    std::int32_t value = 1;     ///< What the input is while the feature is reported.
  };
  model::Valuation
      blank;  ///< One value per input when nothing is reported; also the observation before cell 0.
  std::vector<Wire> wires;  ///< A later wire wins over an earlier one on the same input.
};

/// What counts. A run gets the category of the first transition that carries one, else `never`.
struct Judge {
  static constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::string> categories;  ///< Labels: "infeasible", "stop in 1", ...
  std::vector<std::uint32_t> event;     ///< Per transition of the machine: index into categories, or `none`.
  std::uint32_t never = 0;              ///< The category of a run without an event.
};

/// One experiment. A run is the blank observation and then one observation per cell of the chain; the machine
/// starts in state 0. Where the machine has no row for an observation, the run ends there. The four values
/// must outlive the Run. \pre judge.event.size() == machine.transitions.size(), blank.size() ==
/// machine.inputs.size(), every index is in range.
struct Run {
  const Chain& chain;
  const model::Mealy& machine;
  const Binding& binding;
  const Judge& judge;
};

}  // namespace heed::sim
