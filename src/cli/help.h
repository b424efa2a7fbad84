#pragma once

#include "table.h"

#include <string>

namespace heed::cli {

[[nodiscard]] std::string help();
[[nodiscard]] std::string help(const Command& command);
/// The man page heed(1) in man(7) macros.
[[nodiscard]] std::string man_page();
/// A completion script for bash.
[[nodiscard]] std::string bash_completion();

}  // namespace heed::cli
