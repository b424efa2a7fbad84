#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

/// As much of JSON Schema as docs/formats/result.md uses: $ref, type, properties, required,
/// additionalProperties, items, enum, anyOf. Written from the standard, knowing nothing of the writer.
namespace heed::report::test {

using Json = nlohmann::ordered_json;

/// The text of the first ```json block after \p heading, the last line feed included.
inline std::string fenced(const std::string& text, const std::string& heading) {
  const std::string open = "```json\n";
  const auto at = text.find(open, text.find("\n" + heading + "\n"));
  if (at == std::string::npos) throw std::runtime_error("no block under " + heading);
  const auto begin = at + open.size();
  return text.substr(begin, text.find("```", begin) - begin);
}

inline bool has_type(const Json& value, const std::string& type) {
  if (type == "null") return value.is_null();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "array") return value.is_array();
  return type == "object" && value.is_object();
}

inline bool has_some_type(const Json& value, const Json& types) {
  if (types.is_string()) return has_type(value, types);
  return std::any_of(types.begin(), types.end(), [&](const Json& type) { return has_type(value, type); });
}

struct Validator {
  const Json& root;
  std::vector<std::string> problems{};

  void check(const Json& value, const Json& schema, const std::string& path) {
    if (schema.contains("$ref")) {
      const std::string pointer = schema["$ref"].get<std::string>().substr(1);
      check(value, root.at(Json::json_pointer(pointer)), path);
    }
    if (schema.contains("type") && !has_some_type(value, schema["type"]))
      problems.push_back(path + ": wrong type");
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
      problems.push_back(path + ": not one of the values");
    if (schema.contains("anyOf")) check_any(value, schema["anyOf"], path);
    if (value.is_object()) check_object(value, schema, path);
    if (value.is_array() && schema.contains("items"))
      for (std::size_t i = 0; i < value.size(); ++i)
        check(value[i], schema["items"], path + "/" + std::to_string(i));
  }

  void check_any(const Json& value, const Json& options, const std::string& path) {
    for (const Json& option : options) {
      Validator inner{root};
      inner.check(value, option, path);
      if (inner.problems.empty()) return;
    }
    problems.push_back(path + ": none of the options");
  }

  void check_object(const Json& value, const Json& schema, const std::string& path) {
    if (schema.contains("required"))
      for (const Json& key : schema["required"])
        if (!value.contains(key.get<std::string>()))
          problems.push_back(path + ": misses " + key.get<std::string>());
    if (!schema.contains("properties")) return;
    for (const auto& [key, item] : value.items()) {
      if (schema["properties"].contains(key))
        check(item, schema["properties"][key], path + "/" + key);
      else if (schema.contains("additionalProperties"))
        problems.push_back(path + ": surplus " + key);
    }
  }
};

inline std::vector<std::string> violations(const Json& document, const Json& schema) {
  Validator validator{schema};
  validator.check(document, schema, "");
  return validator.problems;
}

}  // namespace heed::report::test
