#pragma once

#include <heed/logic/formula.h>

#include <cstddef>
#include <string>

namespace heed::logic {

/// to_string(), cut with "..." once \p bytes are written: what a message or a comment can bear of a huge
/// formula.
[[nodiscard]] std::string to_short_string(const Formula& formula, std::size_t bytes = 240);

}  // namespace heed::logic
