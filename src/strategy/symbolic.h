#pragma once

#include <heed/game/solve.h>
#include <heed/model/symbolic.h>
#include <heed/util/limits.h>

namespace heed::strategy {

/// The strategy that the ranks of \p region hold, as functions: nothing is listed.
/// \pre region.realizable and its ranks were kept
[[nodiscard]] model::SymbolicController make_symbolic(const game::Game& game, const game::Region& region,
                                                      util::Budget& budget);

/// The assumptions of \p spec as formulas, for whoever runs the controller.
[[nodiscard]] std::vector<std::string> assumption_texts(const spec::Gr1& spec);

}  // namespace heed::strategy
