#include "atoms.h"

namespace heed::awareness {
namespace {

bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
char to_lower(char c) {
  return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
}

/// A word ends before position \p i of \p s: "aB", "a3", and "UTurn" before its T.
bool word_starts(std::string_view s, std::size_t i) {
  if (i == 0) return false;
  const char before = s[i - 1];
  if (is_digit(s[i])) return is_lower(before);
  if (!is_upper(s[i])) return false;
  const bool next_is_lower = i + 1 < s.size() && is_lower(s[i + 1]);
  return is_lower(before) || is_digit(before) || (is_upper(before) && next_is_lower);
}

std::string split_words(std::string_view s) {
  std::string result;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (word_starts(s, i)) result += '_';
    result += to_lower(s[i]);
  }
  return result;
}

std::string only_name_characters(std::string s) {
  for (char& c : s)
    if (!is_upper(c) && !is_lower(c) && !is_digit(c)) c = '_';
  if (s.empty() || is_digit(s.front())) s.insert(s.begin(), '_');
  if (s == "true" || s == "false") s += '_';
  return s;
}

}  // namespace

std::string atom_of(std::string_view local_name) {
  const bool camel = !local_name.empty() && is_upper(local_name.front());
  return only_name_characters(camel ? split_words(local_name) : std::string(local_name));
}

std::string role_atom_of(std::string_view local_name) {
  const bool has = local_name.size() > 3 && local_name.substr(0, 3) == "has" && is_upper(local_name[3]);
  return only_name_characters(split_words(has ? local_name.substr(3) : local_name));
}

std::string AtomTable::claim(const std::string& wanted) {
  std::string name = wanted;
  for (int n = 2; !used_.insert(name).second; ++n) name = wanted + "_" + std::to_string(n);
  return name;
}

}  // namespace heed::awareness
