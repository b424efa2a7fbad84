#pragma once

#include <heed/logic/formula.h>

#include <functional>
#include <optional>
#include <set>
#include <string>

namespace heed::logic {

/// Replaces names; `replacement` returns nothing to leave one. Under `Next` the replacement is wrapped in
/// Next: a definition D = f(X) turns X D into X f(X). O(nodes).
[[nodiscard]] Formula substitute(
    const Formula& formula, const std::function<std::optional<Formula>(const std::string&)>& replacement);

/// Pushes Next down to names (`X (a & b)` becomes `a' & b'`). \pre no temporal operator but Next
[[nodiscard]] Formula push_next(const Formula& formula);

/// Names that occur, sorted; `primed`: those below Next.
struct Names {
  std::set<std::string> current, primed;
};
[[nodiscard]] Names names_of(const Formula& formula);

/// True when no temporal operator occurs; with \p next_allowed, a single level of Next may.
[[nodiscard]] bool is_propositional(const Formula& formula, bool next_allowed = false);

}  // namespace heed::logic
