#pragma once

#include "local.h"

namespace heed::logic {

/// Negation pushed down to local parts; what is left above them is And, Or, Next, Always, Eventually, Until,
/// WeakUntil. Local parts stay as they were written. \throws util::InputError  a future operator below a past
/// one
[[nodiscard]] Formula negation_normal_form(const Formula& formula, Locality& locality);

/// Applies the laws that hold whatever stands around: G (a & b), F (a | b), G G, F F, F G F, G F F, F X, G X,
/// F (a U b), GF of disjunctions and of `a & F b`. \returns the formula itself where none applies.
[[nodiscard]] Formula apply_law(const Formula& formula, Locality& locality);

/// Refuses \p formula, saying where it was read and why. [code: not-gr1]
[[noreturn]] void refuse(const Formula& formula, const std::string& reason);

}  // namespace heed::logic
