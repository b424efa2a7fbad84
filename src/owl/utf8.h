#pragma once

#include <cstdint>
#include <string>

namespace heed::owl {

/// \pre code is a Unicode scalar value
void append_utf8(std::uint32_t code, std::string& out);

[[nodiscard]] constexpr bool is_scalar_value(std::uint32_t code) {
  return code <= 0x10FFFF && (code < 0xD800 || code >= 0xE000);
}

}  // namespace heed::owl
