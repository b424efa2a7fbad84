#pragma once

#include <heed/model/mealy.h>

#include <cstddef>
#include <string>

namespace heed::exporter {

struct DotOptions {
  std::size_t max_states = 250;  ///< A larger machine is cut here, in the order of its states; > 0.
  std::size_t max_cubes = 8;     ///< Conditions written on one edge; the rest is counted.
};

/// The machine as a Graphviz graph. Edges with the same ends and the same visible outputs (actions, outputs,
/// recognised, prescribed) are one; its label is a list of cubes over the inputs that covers exactly the
/// observations that take it, where all the others of the state count as "not". A graph that was cut says so
/// in a note. O(rows * inputs * domain), edges of more than 4096 observations are listed unmerged.
[[nodiscard]] std::string to_dot(const model::Mealy& machine, const DotOptions& options = {});

}  // namespace heed::exporter
