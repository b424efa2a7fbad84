#include "document.h"

#include <heed/util/diagnostic.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace heed::model {
namespace {

using Json = Document::Json;

constexpr std::array<std::string_view, 6> roles = {"action", "output",     "plant",
                                                   "memory", "recognised", "prescribed"};

}  // namespace

Document::Document(const util::SourceText& source) : location_{source.at(0).file, 0, 0} {
  try {
    // The callback refuses deep nesting before the parser's own recursion-free stack grows without bound.
    root_ = Json::parse(source.text(), [](int depth, Json::parse_event_t, Json&) {
      if (depth > 8) throw std::length_error("nested deeper than a controller is");
      return true;
    });
  } catch (const Json::parse_error& error) {
    throw util::InputError(source, error.byte > 0 ? error.byte - 1 : 0, "bad-json", "not JSON here",
                           "a controller file is one JSON document");
  } catch (const std::length_error& error) {
    fail(error.what());
  }
  if (!root_.is_object()) fail("expected a JSON object");
}

void Document::fail(const std::string& message) const {
  throw util::InputError(
      location_, "bad-controller", message,
      "a controller file is written by `heed run` or `heed synth` (docs/formats/controller.md)");
}

void Document::expect_keys(const Json& object, std::string_view what,
                           const std::vector<std::string>& keys) const {
  for (const std::string& key : keys)
    if (!object.contains(key)) fail(fmt::format("{} lacks the key '{}'", what, key));
  for (const auto& [key, value] : object.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      fail(fmt::format("unknown key '{}' in {}; {}", key, what, util::suggestion(key, keys)));
}

const Json& Document::list(const Json& object, const char* key) const {
  if (!object[key].is_array()) fail(fmt::format("'{}' must be an array", key));
  return object[key];
}

std::string Document::text(const Json& value, std::string_view what) const {
  if (!value.is_string()) fail(fmt::format("'{}' must hold text", what));
  return value.get<std::string>();
}

std::vector<std::string> Document::texts(const char* key) const {
  std::vector<std::string> result;
  for (const Json& item : list(root_, key)) result.push_back(text(item, key));
  return result;
}

std::int32_t Document::integer(const Json& value, std::string_view what, std::int64_t low,
                               std::int64_t high) const {
  if (!value.is_number_integer())
    fail(fmt::format("{}: expected an integer, found {}", what, value.dump().substr(0, 40)));
  const auto number = value.get<std::int64_t>();
  if (number < low || number > high)
    fail(fmt::format("{}: {} is outside {} ... {}", what, number, low, high));
  return static_cast<std::int32_t>(number);
}

Variable Document::variable(const Json& item, bool with_role) const {
  if (!item.is_object()) fail("a variable must be an object with 'name' and 'type'");
  std::vector<std::string> keys{"name", "type"};
  if (with_role) keys.emplace_back("role");
  if (item.contains("comment")) keys.emplace_back("comment");
  expect_keys(item, "a variable", keys);
  Variable variable{text(item["name"], "name"), domain(item["type"]), {}, {}};
  if (item.contains("comment")) variable.comment = text(item["comment"], "comment");
  return variable;
}

std::vector<Variable> Document::variables(const char* key) const {
  std::vector<Variable> result;
  for (const Json& item : list(root_, key)) result.push_back(variable(item, false));
  return result;
}

std::vector<Output> Document::columns(const char* key) const {
  std::vector<Output> result;
  for (const Json& item : list(root_, key)) {
    Variable read = variable(item, true);
    result.push_back({std::move(read), role(item)});
  }
  return result;
}

Domain Document::domain(const Json& type) const {
  if (type == "boolean") return Domain::boolean();
  if (!type.is_array() || type.empty()) fail("'type' must be \"boolean\", [low, high] or an array of names");
  if (type[0].is_string()) {
    std::vector<std::string> values;
    for (const Json& value : type) values.push_back(text(value, "type"));
    return Domain::enumeration(std::move(values));
  }
  if (type.size() != 2) fail("an integer type is [low, high]");
  const std::int32_t low = integer(type[0], "type", INT32_MIN / 2, INT32_MAX / 2);
  return Domain::integer(low, integer(type[1], "type", low, INT32_MAX / 2));
}

OutputRole Document::role(const Json& item) const {
  const std::string name = text(item["role"], "role");
  const auto found = std::find(roles.begin(), roles.end(), name);
  if (found == roles.end())
    fail(fmt::format("unknown role '{}'; {}", name, util::suggestion(name, {roles.begin(), roles.end()})));
  return static_cast<OutputRole>(found - roles.begin());
}

std::string json_quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

namespace {

std::string open_variable(const Variable& variable) {
  std::string type;
  switch (variable.domain.kind) {
    case Domain::Kind::Boolean:
      type = "\"boolean\"";
      break;
    case Domain::Kind::Integer:
      type = fmt::format("[{}, {}]", variable.domain.low, variable.domain.high);
      break;
    case Domain::Kind::Enumeration: {
      for (const std::string& value : variable.domain.values)
        type += (type.empty() ? "[" : ", ") + json_quoted(value);
      type += ']';
    }
  }
  std::string out = fmt::format("{{\"name\": {}, \"type\": {}", json_quoted(variable.name), type);
  if (!variable.comment.empty()) out += fmt::format(", \"comment\": {}", json_quoted(variable.comment));
  return out;
}

}  // namespace

std::string json_variable(const Variable& variable) {
  return open_variable(variable) + '}';
}

std::string json_column(const Output& column) {
  return fmt::format("{}, \"role\": \"{}\"}}", open_variable(column.variable),
                     roles[static_cast<std::size_t>(column.role)]);
}

}  // namespace heed::model
