#pragma once

#include "portable.h"

#include <string>

namespace heed::spec {

/// \p formula in the infix notation that slugs' structured format and gr1c share: `! & | -> <->`,
/// comparisons, sums, primes after names, every compound operand in parentheses. Iterative.
[[nodiscard]] std::string infix(const logic::Formula& formula, const TargetNames& names, const char* truth,
                                const char* falsehood);

/// Whether all comparisons of \p spec satisfy \p fits.
[[nodiscard]] bool all_comparisons(Portable& spec, const std::function<bool(const logic::Formula&)>& fits);

}  // namespace heed::spec
