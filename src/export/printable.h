#pragma once

#include <string>
#include <string_view>

namespace heed::exporter {

/// \p text on one line and in valid UTF-8: control characters become blanks; bytes that are no UTF-8,
/// directional controls and other invisible characters, which could make code read differently from what it
/// is, become asterisks. \cite boucher.23.usenix
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace heed::exporter
