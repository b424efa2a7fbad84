#pragma once

#include <string>

namespace heed::bench {

/// The case study's awareness controller at any size: a stop sign described by being a sign and by \p parts
/// parts, each of which perception reports, on a road of \p cells cells. It is recognised by any two of the
/// `parts + 1` features; perception is persistent within one approach, a part is only seen on a seen sign and
/// the whole only with a part, as in the case study (which has parts = 2, cells = 5).
struct PartsScenario {
  unsigned parts = 2;                 ///< 1 or more, `sign` not counted.
  unsigned cells = 5;                 ///< 2 or more.
  std::string on_violation = "drop";  ///< The scenario's key: `drop`, `latch` or `undefined`.
};

/// Turtle: the sign, its parts, the stop sign with its description, and what it prescribes.
[[nodiscard]] std::string ontology_text(const PartsScenario& wanted);

/// The car's transition system: moving and stopping in each cell, as in the case study.
[[nodiscard]] std::string plant_text(const PartsScenario& wanted);

/// The scenario over `parts.ttl` and `car.fts`, with the one controller `awareness`.
[[nodiscard]] std::string scenario_text(const PartsScenario& wanted);

/// Writes `parts.ttl`, `car.fts` and `scenario.toml` into \p folder, which is made when missing.
/// \returns the path of the scenario. \throws util::InputError  the folder cannot be written
std::string write_scenario(const PartsScenario& wanted, const std::string& folder);

}  // namespace heed::bench
