#pragma once

#include <heed/model/mealy.h>
#include <heed/util/source.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace heed::model {

/// A JSON document that holds a controller, and what its readers ask of it; every complaint names the key.
class Document {
 public:
  using Json = nlohmann::json;

  /// \throws util::InputError  not JSON, nested too deep, no object
  explicit Document(const util::SourceText& source);

  [[nodiscard]] const Json& root() const { return root_; }
  [[noreturn]] void fail(const std::string& message) const;
  void expect_keys(const Json& object, std::string_view what, const std::vector<std::string>& keys) const;
  [[nodiscard]] const Json& list(const Json& object, const char* key) const;
  [[nodiscard]] std::string text(const Json& value, std::string_view what) const;
  [[nodiscard]] std::vector<std::string> texts(const char* key) const;
  [[nodiscard]] std::int32_t integer(const Json& value, std::string_view what, std::int64_t low,
                                     std::int64_t high) const;
  [[nodiscard]] std::vector<Variable> variables(const char* key) const;
  [[nodiscard]] std::vector<Output> columns(const char* key) const;

 private:
  [[nodiscard]] Variable variable(const Json& item, bool with_role) const;
  [[nodiscard]] Domain domain(const Json& type) const;
  [[nodiscard]] OutputRole role(const Json& item) const;

  util::Location location_;
  Json root_;
};

[[nodiscard]] std::string json_quoted(const std::string& text);
[[nodiscard]] std::string json_variable(const Variable& variable);
[[nodiscard]] std::string json_column(const Output& column);

/// "key": [a, b], and a line feed.
template <class Items, class Print>
void json_list(std::string& out, std::string_view key, const Items& items, Print print) {
  out += fmt::format("\"{}\": [", key);
  bool first = true;
  for (const auto& item : items) {
    out += first ? "" : ", ";
    out += print(item);
    first = false;
  }
  out += "],\n";
}

}  // namespace heed::model
