#pragma once

#include <heed/model/mealy.h>
#include <heed/model/symbolic.h>
#include <heed/sim/lumping.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "components.h"
#include "reactions.h"

namespace heed::sim {

/// The rows of a listed machine. What it is made from must outlive it.
[[nodiscard]] std::unique_ptr<ReactionSource> reactions_of(const model::Mealy& machine,
                                                           const Binding& binding, const Judge& judge,
                                                           const std::vector<Component>& components);

/// The functions of a machine that is not listed: a state is what they have become under the values of the
/// step before. What it is made from must outlive it.
[[nodiscard]] std::unique_ptr<ReactionSource> reactions_of(const model::SymbolicController& machine,
                                                           const Binding& binding, const SymbolicJudge& judge,
                                                           const std::vector<Component>& components,
                                                           util::Budget& budget);

}  // namespace heed::sim
