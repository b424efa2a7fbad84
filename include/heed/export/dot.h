#pragma once

#include <heed/model/mealy.h>

#include <cstddef>
#include <string>

namespace heed::exporter {

struct DotOptions {
  std::size_t max_states = 250;  ///< A larger machine is cut here, in the order of its states; > 0.
  std::size_t max_cubes = 8;     ///< Conditions written on one edge; the rest is counted. > 0.
};

/// The machine as a Graphviz graph. Edges with the same ends and the same visible outputs (actions, outputs,
/// recognised, prescribed) are one. Its label is a list of conditions over the inputs, one of which holds for
/// exactly the observations that take it; beyond 4096 observations it only says how many. Fallbacks are
/// dashed. A state is labelled with its number and, where that is clear, the plant's state. A graph that was
/// cut says so in its title. O(rows * inputs * log rows), and a bounded effort per edge.
[[nodiscard]] std::string to_dot(const model::Mealy& machine, const DotOptions& options = {});

}  // namespace heed::exporter
