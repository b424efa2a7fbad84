#pragma once

#include "rules.h"

#include <heed/game/solve.h>
#include <heed/model/mealy.h>
#include <heed/strategy/synthesize.h>
#include <heed/util/limits.h>

#include <cstdint>

namespace heed::strategy {

struct Extracted {
  model::Mealy machine;  ///< Not yet minimised.
  bool relies_on_broken_justice = false;
};

/// Lists the reachable part of the strategy that the ranks of \p region hold.
/// \pre region.realizable and its ranks were kept. \throws util::LimitExceeded  Size: more than max_states,
/// max_rows or max_steps
[[nodiscard]] Extracted extract(const game::Game& game, const game::Region& region, util::Budget& budget,
                                const Options& options);

}  // namespace heed::strategy
