#pragma once

#include <heed/spec/gr1.h>

#include <cstddef>
#include <vector>

namespace heed::game {

/// The order in which the variables of \p spec (inputs, then outputs, then memories) should stand in a
/// diagram: by the FORCE heuristic over the clauses, definitions expanded, starting from the order of
/// declaration. Deterministic. O(rounds * occurrences). \cite aloul.03.glsvlsi
[[nodiscard]] std::vector<std::size_t> static_order(const spec::Gr1& spec);

}  // namespace heed::game
