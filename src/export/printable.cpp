#include <algorithm>

#include "printable.h"

namespace heed::exporter {
namespace {

/// Length of the UTF-8 character at \p i, 0 where there is none.
std::size_t character_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const std::size_t length = byte(i) < 0x80 ? 1 : byte(i) >= 0xF0 ? 4 : byte(i) >= 0xE0 ? 3 : 2;
  if (length == 1) return 1;
  if (byte(i) < 0xC2 || byte(i) > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  const unsigned second = byte(i + 1);
  const bool overlong = (byte(i) == 0xE0 && second < 0xA0) || (byte(i) == 0xF0 && second < 0x90);
  const bool outside = (byte(i) == 0xED && second >= 0xA0) || (byte(i) == 0xF4 && second >= 0x90);
  return overlong || outside ? 0 : length;
}

/// Directional marks, embeddings and isolates, line and paragraph separators, C1 controls.
bool is_invisible(std::string_view character) {
  if (character.size() == 2)
    return character == "\u061C" ||
           (character[0] == '\xC2' && static_cast<unsigned char>(character[1]) < 0xA0);
  if (character.size() != 3 || character[0] != '\xE2') return false;
  const auto second = static_cast<unsigned char>(character[1]);
  const auto third = static_cast<unsigned char>(character[2]);
  return (second == 0x80 && third >= 0x8B && third <= 0xAE && !(third >= 0x90 && third <= 0xA7)) ||
         (second == 0x81 && third >= 0xA0 && third <= 0xAF);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    const std::string_view character = text.substr(i, std::max<std::size_t>(length, 1));
    i += character.size();
    const auto byte = static_cast<unsigned char>(character[0]);
    if (length == 0 || is_invisible(character))
      out += '*';
    else if (byte < 0x20 || byte == 0x7F)
      out += ' ';
    else
      out += character;
  }
  return out;
}

}  // namespace heed::exporter
