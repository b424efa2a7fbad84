#pragma once

#include <string>

namespace heed::report {

/// The page that was built from web/, with a place for its data; empty where it could not be built. Defined
/// in a source that the build makes (cmake/play.cmake).
[[nodiscard]] std::string play_template();

}  // namespace heed::report
