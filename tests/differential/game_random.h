#pragma once

#include <heed/spec/gr1.h>

#include <cstdint>

namespace heed::reference {

/// A small specification that \p seed fixes: up to 3 inputs and 3 outputs (Boolean, enumerated, integer), up
/// to two memories and two definitions, up to two justices on each side, all timings and quantifiers.
[[nodiscard]] spec::Gr1 random_spec(std::uint64_t seed);

}  // namespace heed::reference
