#pragma once

#include <heed/model/mealy.h>

#include <string>
#include <vector>

namespace heed::exporter {

/// Per input the values that it may have, ascending: an observation is in the cube if each value is.
using Cube = std::vector<std::vector<std::int32_t>>;

/// Cubes whose union is exactly \p letters (all different). Few, not always fewest.
[[nodiscard]] std::vector<Cube> cover(const std::vector<model::Variable>& inputs,
                                      const std::vector<const model::Valuation*>& letters);

/// "red & !octagon & shape != none"; "true" for the cube of all observations. Names stand as \p quote gives
/// them.
[[nodiscard]] std::string print_cube(const std::vector<model::Variable>& inputs, const Cube& cube,
                                     std::string (*quote)(std::string_view));

}  // namespace heed::exporter
