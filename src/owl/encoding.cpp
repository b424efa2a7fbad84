#include "encoding.h"

#include "utf8.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace heed::owl {
namespace {

util::SourceText converted_utf16(const util::SourceText& source, bool big_endian) {
  const std::string_view in = source.text();
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(in[at]), second = static_cast<unsigned char>(in[at + 1]);
    return static_cast<std::uint32_t>(big_endian ? (first << 8) | second : (second << 8) | first);
  };
  std::string out;
  out.reserve(in.size() / 2);
  for (std::size_t at = 2; at + 1 < in.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (code >= 0xD800 && code < 0xDC00 && at + 3 < in.size()) {
      const std::uint32_t low = unit(at + 2);
      if (low >= 0xDC00 && low < 0xE000) {
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        at += 2;
      }
    }
    if (!is_scalar_value(code))
      throw util::InputError(source, at, "bad-encoding", "half a surrogate pair stands alone in UTF-16 text");
    append_utf8(code, out);
  }
  if (in.size() % 2 != 0)
    throw util::InputError(source, in.size() - 1, "bad-encoding", "UTF-16 text ends in half a unit");
  return {source.name(), std::move(out)};
}

util::SourceText converted_latin1(const util::SourceText& source) {
  std::string out;
  out.reserve(source.text().size() + source.text().size() / 8);
  for (const char c : source.text()) append_utf8(static_cast<unsigned char>(c), out);
  return {source.name(), std::move(out)};
}

struct Declared {
  std::string name;  ///< In upper case; empty where none is declared.
  std::size_t offset = 0;
};

Declared declared_encoding(std::string_view text) {
  const std::string_view head = text.substr(0, std::min<std::size_t>(text.find("?>"), 400));
  const std::size_t begin = head.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  if (head.substr(begin, 5) != "<?xml") return {};
  const std::size_t word = head.find("encoding");
  const std::size_t open = word == std::string_view::npos ? word : head.find_first_of("\"'", word);
  if (open == std::string_view::npos) return {};
  const std::size_t close = head.find(head[open], open + 1);
  if (close == std::string_view::npos) return {};
  Declared out{std::string(head.substr(open + 1, close - open - 1)), open + 1};
  for (char& c : out.name)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

}  // namespace

util::SourceText in_utf8(const util::SourceText& source) {
  const std::string_view text = source.text();
  if (text.starts_with("\xFE\xFF")) return converted_utf16(source, true);
  if (text.starts_with("\xFF\xFE")) return converted_utf16(source, false);
  const Declared declared = declared_encoding(text);
  if (declared.name.empty() || declared.name == "UTF-8" || declared.name == "UTF8" ||
      declared.name == "US-ASCII" || declared.name == "ASCII")
    return source;
  if (declared.name == "ISO-8859-1" || declared.name == "LATIN1" || declared.name == "ISO_8859-1")
    return converted_latin1(source);
  const bool sixteen = declared.name.starts_with("UTF-16");
  throw util::InputError(source, declared.offset, "encoding",
                         sixteen
                             ? std::string("the document says that it is UTF-16, but has no byte order mark")
                             : fmt::format("the encoding '{}' is not read", declared.name),
                         "save it as UTF-8; ISO-8859-1 and UTF-16 with a byte order mark are read too");
}

}  // namespace heed::owl
