#include "resolve.h"

#include <vector>

namespace heed::owl {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Length of "scheme:" at the front, 0 without one.
std::size_t scheme_length(std::string_view text) {
  if (text.empty() || !is_letter(text[0])) return 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ':') return i + 1;
    if (!is_letter(c) && !is_digit(c) && c != '+' && c != '-' && c != '.') return 0;
  }
  return 0;
}

/// Length of "scheme:" and "//authority" at the front.
std::size_t authority_end(std::string_view text) {
  const std::size_t scheme = scheme_length(text);
  if (text.substr(scheme, 2) != "//") return scheme;
  const std::size_t end = text.find_first_of("/?#", scheme + 2);
  return end == std::string_view::npos ? text.size() : end;
}

std::string without_dots(std::string_view path) {
  std::vector<std::string_view> segments;
  const bool rooted = !path.empty() && path.front() == '/';
  bool folder = false;
  for (std::size_t at = rooted ? 1 : 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string_view segment = path.substr(at, end - at);
    folder = segment == "." || segment == "..";
    if (segment == ".." && !segments.empty()) segments.pop_back();
    if (!folder) segments.push_back(segment);
    at = end + 1;
  }
  std::string out = rooted ? "/" : "";
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i > 0) out += '/';
    out += segments[i];
  }
  if (folder && !segments.empty()) out += '/';
  return out;
}

}  // namespace

bool is_absolute_iri(std::string_view text) {
  return scheme_length(text) > 0;
}

std::size_t first_bad_character(std::string_view iri) {
  if (iri.starts_with("_:")) return 0;
  for (std::size_t i = 0; i < iri.size(); ++i)
    if (static_cast<unsigned char>(iri[i]) <= 0x20 ||
        std::string_view("<>\"{}|\\^`").find(iri[i]) != std::string_view::npos)
      return i;
  return std::string_view::npos;
}

bool is_language_tag(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  bool first = true, empty = true;
  for (const char c : text) {
    if (c == '-' && !empty) {
      first = false;
      empty = true;
    } else if (letter(c) || (!first && c >= '0' && c <= '9')) {
      empty = false;
    } else {
      return false;
    }
  }
  return !empty;
}

void resolve_iri(std::string_view base, std::string_view reference, std::string& out) {
  if (is_absolute_iri(reference)) {
    out.assign(reference);
    return;
  }
  base = base.substr(0, base.find('#'));
  if (reference.empty() || reference.front() == '#') {
    out.assign(base).append(reference);
    return;
  }
  const std::size_t authority = authority_end(base);
  if (reference.substr(0, 2) == "//") {
    out.assign(base.substr(0, scheme_length(base))).append(reference);
    return;
  }
  const std::string_view base_path = base.substr(authority, base.find('?', authority) - authority);
  out.assign(base.substr(0, authority));
  if (reference.front() == '?') {
    out.append(base_path).append(reference);
    return;
  }
  const std::size_t path_end = std::min(reference.find_first_of("?#"), reference.size());
  std::string path;
  if (reference.front() != '/') {
    const std::size_t slash = base_path.rfind('/');
    if (slash != std::string_view::npos)
      path = base_path.substr(0, slash + 1);
    else if (base_path.empty() && authority > 0)
      path = "/";
  }
  path += reference.substr(0, path_end);
  out.append(without_dots(path)).append(reference.substr(path_end));
}

}  // namespace heed::owl
