#include <heed/model/variable.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <utility>

namespace heed::model {

Domain Domain::enumeration(std::vector<std::string> names) {
  assert(!names.empty());
  const auto high = static_cast<std::int32_t>(names.size()) - 1;
  std::unordered_map<std::string, std::int32_t> codes;
  for (std::int32_t code = 0; code <= high; ++code)
    codes.emplace(names[static_cast<std::size_t>(code)], code);
  return {Kind::Enumeration, 0, high, std::move(names),
          std::make_shared<const std::unordered_map<std::string, std::int32_t>>(std::move(codes))};
}

std::string Domain::print(std::int32_t code) const {
  assert(low <= code && code <= high);
  switch (kind) {
    case Kind::Boolean:
      return code != 0 ? "true" : "false";
    case Kind::Integer:
      return std::to_string(code);
    case Kind::Enumeration:
      return values[static_cast<std::size_t>(code)];
  }
  return {};
}

std::optional<std::int32_t> Domain::read(const std::string& text) const {
  if (kind == Kind::Boolean) {
    if (text == "true") return 1;
    if (text == "false") return 0;
    return std::nullopt;
  }
  // Names may have been added since, or be there twice: then the list decides.
  if (kind == Kind::Enumeration && codes && codes->size() == values.size()) {
    const auto found = codes->find(text);
    return found == codes->end() ? std::nullopt : std::optional(found->second);
  }
  if (kind == Kind::Enumeration) {
    const auto found = std::find(values.begin(), values.end(), text);
    if (found == values.end()) return std::nullopt;
    return static_cast<std::int32_t>(found - values.begin());
  }
  std::int32_t code = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code);
  if (error != std::errc() || end != text.data() + text.size() || code < low || code > high)
    return std::nullopt;
  // "-0" and "007" are numbers, but not how a value is printed: one text per value keeps files comparable.
  if (std::to_string(code) != text) return std::nullopt;
  return code;
}

}  // namespace heed::model
