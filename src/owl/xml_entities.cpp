#include "xml_entities.h"

#include "utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

namespace heed::owl {
namespace {

constexpr std::string_view blanks = " \t\r\n";

void skip_blanks(std::string_view text, std::size_t& at) {
  at = std::min(text.find_first_not_of(blanks, at), text.size());
}

std::string_view take_word(std::string_view text, std::size_t& at) {
  skip_blanks(text, at);
  const std::size_t end = std::min(text.find_first_of(" \t\r\n\"'", at), text.size());
  const std::string_view word = text.substr(at, end - at);
  at = end;
  return word;
}

/// End of one piece of the internal subset that begins at \p at with '<': after the '>' that closes it.
std::size_t end_of_declaration(std::string_view text, std::size_t at) {
  const auto after = [&](std::string_view closing) {
    const std::size_t found = text.find(closing, at);
    return found == std::string_view::npos ? text.size() : found + closing.size();
  };
  if (text.substr(at, 4) == "<!--") return after("-->");
  if (text.substr(at, 2) == "<?") return after("?>");
  for (char quote = 0; at < text.size(); ++at) {
    if (quote != 0) {
      if (text[at] == quote) quote = 0;
    } else if (text[at] == '"' || text[at] == '\'') {
      quote = text[at];
    } else if (text[at] == '>') {
      return at + 1;
    }
  }
  return text.size();
}

}  // namespace

void XmlEntities::fail(std::size_t offset, const char* code, std::string message, std::string hint) const {
  throw util::InputError(source_, offset, code, std::move(message), std::move(hint));
}

void XmlEntities::declare(std::string_view subset, std::size_t offset) {
  std::size_t at = subset.find('[');
  while (at < subset.size()) {
    at = subset.find_first_of("<%]", at + 1);
    if (at == std::string_view::npos || subset[at] == ']') return;
    if (subset[at] == '%')
      fail(offset + at, "parameter-entity",
           "a parameter entity is used in the document type, which heed does not read",
           "write the declarations out");
    const std::size_t end = end_of_declaration(subset, at);
    const std::string_view declaration = subset.substr(at, end - at);
    if (declaration.substr(0, 8) == "<!ENTITY") declare_one(declaration, offset + at);
    at = end - 1;
  }
}

void XmlEntities::declare_one(std::string_view declaration, std::size_t offset) {
  std::size_t at = 8;
  const std::string name(take_word(declaration, at));
  if (name == "%")
    fail(offset, "parameter-entity", "a parameter entity is declared, which heed does not read",
         "write it out");
  skip_blanks(declaration, at);
  if (at >= declaration.size() || (declaration[at] != '"' && declaration[at] != '\'')) {
    external_.try_emplace(name, offset);
    return;
  }
  const std::size_t end = declaration.find(declaration[at], at + 1);
  if (end == std::string_view::npos)
    fail(offset, "bad-entity", fmt::format("the value of entity '{}' has no end", name));
  const std::string_view raw = declaration.substr(at + 1, end - at - 1);
  std::string value;
  for (std::size_t i = 0; i < raw.size();) {
    const std::size_t semicolon = raw[i] == '&' ? raw.find(';', i) : std::string_view::npos;
    if (semicolon != std::string_view::npos && raw[i + 1] == '#') {
      append_builtin(raw.substr(i + 1, semicolon - i - 1), offset + at + 1 + i, value);
      i = semicolon + 1;
    } else {
      value += raw[i++];
    }
  }
  values_.try_emplace(name, std::move(value));
}

bool XmlEntities::append_builtin(std::string_view name, std::size_t offset, std::string& out) const {
  if (name == "lt") return out += '<', true;
  if (name == "gt") return out += '>', true;
  if (name == "amp") return out += '&', true;
  if (name == "quot") return out += '"', true;
  if (name == "apos") return out += '\'', true;
  if (name.empty() || name[0] != '#') return false;
  const bool hexadecimal = name.size() > 1 && name[1] == 'x';
  const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
  std::uint32_t code = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
  const bool control = code < 0x20 && code != 9 && code != 10 && code != 13;
  if (error != std::errc() || end != digits.data() + digits.size() || !is_scalar_value(code) || control)
    fail(offset, "bad-character-reference", fmt::format("'&{};' is no character of XML", name));
  append_utf8(code, out);
  return true;
}

std::string_view XmlEntities::value_of(std::string_view name, std::size_t offset) {
  const auto found = values_.find(name);
  if (found == values_.end()) {
    if (external_.find(name) != external_.end())
      fail(offset, "external-entity",
           fmt::format("entity '{}' lives outside the document and is not fetched", name),
           "put its text into the document");
    std::vector<std::string> known;
    for (const auto& entry : values_) known.push_back(entry.first);
    fail(offset, "undefined-entity", fmt::format("entity '{}' is not declared", name),
         known.empty() ? "declare it in the DOCTYPE" : util::suggestion(name, known));
  }
  spent_ += found->second.size() + 1;
  if (limits_.entity_bytes != 0 && spent_ > limits_.entity_bytes)
    fail(offset, "entity-expansion",
         fmt::format("entities expand to more than the limit of {} bytes", limits_.entity_bytes),
         "a document that does this on purpose is hostile; raise the limit for a large honest one");
  if (found->second.find('<') != std::string::npos)
    fail(offset, "entity-markup", fmt::format("entity '{}' holds markup, which heed does not expand", name),
         "write it out");
  return found->second;
}

void XmlEntities::expand_nested(std::string_view name, std::size_t offset) {
  struct Open {
    std::string_view name, rest;
  };
  std::vector<Open> open = {{name, value_of(name, offset)}};
  while (!open.empty()) {
    std::string_view& rest = open.back().rest;
    const std::size_t at = std::min(rest.find('&'), rest.size());
    buffer_ += rest.substr(0, at);
    rest.remove_prefix(at);
    if (rest.empty()) {
      open.pop_back();
      continue;
    }
    const std::size_t semicolon = rest.find(';');
    if (semicolon == std::string_view::npos)
      fail(offset, "bad-entity", fmt::format("entity '{}' holds a bare '&'", name));
    const std::string_view inner = rest.substr(1, semicolon - 1);
    rest.remove_prefix(semicolon + 1);
    if (append_builtin(inner, offset, buffer_)) continue;
    if (std::any_of(open.begin(), open.end(), [&](const Open& entry) { return entry.name == inner; }))
      fail(offset, "entity-cycle", fmt::format("entity '{}' refers to itself", inner));
    if (limits_.nesting != 0 && open.size() >= std::min<std::size_t>(limits_.nesting, 1000))
      fail(offset, "entity-nesting", fmt::format("entities nest more than {} deep", open.size()));
    open.push_back(
        {values_.find(inner) == values_.end() ? inner : std::string_view(values_.find(inner)->first),
         value_of(inner, offset)});
  }
}

std::string_view XmlEntities::expand(std::string_view text, std::size_t offset) {
  std::size_t at = text.find('&');
  if (at == std::string_view::npos) return text;
  buffer_.clear();
  std::size_t done = 0;
  for (; at != std::string_view::npos; at = text.find('&', done)) {
    buffer_ += text.substr(done, at - done);
    const std::size_t semicolon = text.find(';', at);
    if (semicolon == std::string_view::npos || semicolon - at > 256 || semicolon == at + 1)
      fail(offset + at, "bare-ampersand", "'&' does not begin a reference", "write &amp;");
    const std::string_view name = text.substr(at + 1, semicolon - at - 1);
    if (!append_builtin(name, offset + at, buffer_)) expand_nested(name, offset + at);
    done = semicolon + 1;
  }
  buffer_ += text.substr(done);
  return buffer_;
}

}  // namespace heed::owl
