#pragma once

#include <heed/job/evaluate.h>

namespace heed::job {

/// P(what is reported on \p approach breaks an assumption of \p spec on the environment), whatever answers
/// then: those on the first step and on every step, not those that speak of infinitely often. A run ends
/// where it breaks one, or where \p machine has no answer, which breaks one as well. \param machine  Of that
/// specification; its columns say what the assumptions say of the plant. \throws util::LimitExceeded  Size:
/// the approach has no small chain
[[nodiscard]] sim::Rational assumptions_broken(const spec::Gr1& spec, const ReadyApproach& approach,
                                               const model::Mealy& machine, util::Budget& budget);

}  // namespace heed::job
