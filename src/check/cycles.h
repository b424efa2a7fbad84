#pragma once

#include "explore.h"

namespace heed::check {

/// Looks, for each system justice, for a cycle that never meets it although it meets every environment
/// justice. The machine is deterministic, so a path is the environment's choice: such a cycle is a play that
/// the machine loses. Without the edges that meet the justice, it lies within one strongly connected
/// component. Adds refutations with lasso traces, and says whether a cycle without the justice is left that
/// fails some assumption. O(system justices * edges). \cite tarjan.72.sicomp
void check_justice(const Explorer& explorer, const Rules& rules, util::Budget& budget, const Options& options,
                   Verdict& verdict);

}  // namespace heed::check
