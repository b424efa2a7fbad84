#pragma once

#include <string>

namespace heed::job {

/// "0.1.0", as in CMakeLists.txt.
[[nodiscard]] std::string version();

}  // namespace heed::job
