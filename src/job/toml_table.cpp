#include "toml_table.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace heed::job {

toml::table parse_toml(const util::SourceText& source) {
  try {
    return toml::parse(source.text(), source.name());
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    std::size_t offset = 0;
    for (std::uint32_t line = 1; line < begin.line && offset != std::string::npos; ++line)
      offset = source.text().find('\n', offset) + 1;
    offset = std::min(offset + (begin.column > 0 ? begin.column - 1 : 0), source.text().size());
    throw util::InputError(source, offset, "toml-syntax", std::string(error.description()),
                           "a scenario is TOML 1.0 (docs/formats/scenario.md)");
  }
}

util::Location TomlTable::at(const toml::node& node) const {
  const auto& begin = node.source().begin;
  return {file_, begin.line, begin.column};
}

util::Location TomlTable::location_of(const std::string& key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr ? at(*node) : location();
}

void TomlTable::fail(const std::string& key, const std::string& code, const std::string& message,
                     const std::string& hint) const {
  throw util::InputError(location_of(key), code, message, hint);
}

void TomlTable::missing(const std::string& key) const {
  // A misspelt key is told as that, not as the absence of the right one.
  for (const auto& [present, node] : *table_)
    if (!util::nearest(std::string(present.str()), {key}).empty())
      throw util::InputError(
          at(node), "unknown-key",
          fmt::format("unknown key '{}' in {}", present.str(), path_.empty() ? "the scenario" : path_),
          fmt::format("did you mean '{}'?", key));
  throw util::InputError(location(), "missing-key",
                         fmt::format("{} lacks the key '{}'", path_.empty() ? "the scenario" : path_, key),
                         "docs/formats/scenario.md lists every key");
}

const toml::node* TomlTable::find(const std::string& key) {
  asked_.insert(key);
  return table_->get(key);
}

bool TomlTable::has(const std::string& key) {
  return find(key) != nullptr;
}

Word TomlTable::read_word(const std::string& key, const toml::node& node) const {
  const auto value = node.value_exact<std::string>();
  if (!value)
    throw util::InputError(at(node), "wrong-type", fmt::format("'{}' must be a string", key),
                           "write it in quotes: \"...\"");
  return {*value, at(node)};
}

Word TomlTable::word(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) missing(key);
  return read_word(key, *node);
}

std::optional<Word> TomlTable::optional_word(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return read_word(key, *node);
}

std::string TomlTable::text(const std::string& key, const std::string& otherwise) {
  const auto word = optional_word(key);
  return word ? word->text : otherwise;
}

bool TomlTable::is_flag(const std::string& key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_boolean();
}

bool TomlTable::is_array(const std::string& key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_array();
}

bool TomlTable::flag(const std::string& key, bool otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) return otherwise;
  const auto value = node->value_exact<bool>();
  if (!value) fail(key, "wrong-type", fmt::format("'{}' must be true or false", key), "without quotes");
  return *value;
}

std::int64_t TomlTable::integer(const std::string& key, std::int64_t otherwise, std::int64_t low,
                                std::int64_t high) {
  const toml::node* node = find(key);
  if (node == nullptr) return otherwise;
  const auto value = node->value_exact<std::int64_t>();
  if (!value)
    fail(key, "wrong-type", fmt::format("'{}' must be an integer", key),
         "such as 5, without quotes and without a point");
  if (*value < low || *value > high)
    fail(key, "out-of-range", fmt::format("'{}' is {}, expected {} ... {}", key, *value, low, high),
         fmt::format("choose one from {} to {}", low, high));
  return *value;
}

double TomlTable::real(const std::string& key, double otherwise, double low, double high) {
  const toml::node* node = find(key);
  if (node == nullptr) return otherwise;
  if (!node->is_number())
    fail(key, "wrong-type", fmt::format("'{}' must be a number", key), "such as 0.5, without quotes");
  const double value = *node->value<double>();
  if (!(value > low) || !(value < high))
    fail(key, "out-of-range",
         fmt::format("'{}' is {}, expected a number between {} and {}", key, value, low, high),
         "the bounds themselves are not allowed");
  return value;
}

std::vector<Word> TomlTable::words(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  if (const toml::array* items = node->as_array()) {
    std::vector<Word> words;
    for (const toml::node& item : *items) words.push_back(read_word(key, item));
    return words;
  }
  if (!node->is_string())
    fail(key, "wrong-type", fmt::format("'{}' must be a string or an array of strings", key),
         fmt::format("such as {} = [\"...\", \"...\"]", key));
  return {read_word(key, *node)};
}

util::SourceText TomlTable::placed(const toml::node& node, const std::string& text) const {
  const util::Location begin = at(node);
  return {*file_, text, begin.line, begin.column + (node.is_string() ? 1 : 0)};
}

util::SourceText TomlTable::source(const std::string& key) {
  const Word found = word(key);
  return placed(*table_->get(key), found.text);
}

std::vector<util::SourceText> TomlTable::sources(const std::string& key) {
  std::vector<util::SourceText> found;
  const toml::node* node = find(key);
  if (node == nullptr) return found;
  if (const toml::array* items = node->as_array()) {
    for (const toml::node& item : *items) found.push_back(placed(item, read_word(key, item).text));
    return found;
  }
  if (!node->is_string())
    fail(key, "wrong-type", fmt::format("'{}' must be a string or an array of strings", key),
         fmt::format("such as {} = [\"...\", \"...\"]", key));
  found.push_back(source(key));
  return found;
}

util::SourceText TomlTable::read_scalar(const std::string& key, const toml::node& node) const {
  if (node.is_string()) return placed(node, read_word(key, node).text);
  if (const auto integer = node.value_exact<std::int64_t>()) return placed(node, std::to_string(*integer));
  if (const auto number = node.value_exact<double>()) return placed(node, fmt::format("{}", *number));
  throw util::InputError(at(node), "wrong-type", fmt::format("'{}' must be a number or a string", key),
                         "such as 0.5 or \"1/2\"");
}

util::SourceText TomlTable::scalar(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) missing(key);
  return read_scalar(key, *node);
}

std::vector<util::SourceText> TomlTable::scalars(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) missing(key);
  const toml::array* items = node->as_array();
  if (items == nullptr)
    fail(key, "wrong-type", fmt::format("'{}' must be an array", key),
         fmt::format("such as {} = [...]", key));
  std::vector<util::SourceText> found;
  for (const toml::node& item : *items) found.push_back(read_scalar(key, item));
  return found;
}

TomlTable TomlTable::table(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) missing(key);
  if (!node->is_table())
    fail(key, "wrong-type", fmt::format("'{}' must be a table", key),
         path_.empty() ? fmt::format("it begins with [{}]", key) : "such as { key = \"value\" }");
  return {*node->as_table(), file_, fmt::format("[{}]", key)};
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) {
  std::vector<TomlTable> tables;
  const toml::node* node = find(key);
  if (node == nullptr) return tables;
  const toml::array* items = node->as_array();
  if (items == nullptr)
    fail(key, "wrong-type", fmt::format("'{}' must be an array of tables", key),
         path_.empty() ? fmt::format("each one begins with [[{}]]", key)
                       : fmt::format("such as {} = [{{ ... }}, {{ ... }}]", key));
  for (const toml::node& item : *items) {
    if (!item.is_table())
      throw util::InputError(at(item), "wrong-type", fmt::format("each item of '{}' must be a table", key),
                             "such as { key = \"value\" }");
    tables.emplace_back(*item.as_table(), file_, fmt::format("[[{}]]", key));
  }
  return tables;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::pair<util::Location, std::string>> found;
  for (const auto& [key, node] : *table_) found.emplace_back(at(node), std::string(key.str()));
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.line, a.first.column, a.second) <
           std::tie(b.first.line, b.first.column, b.second);
  });
  std::vector<std::string> keys;
  for (auto& [location, key] : found) keys.push_back(std::move(key));
  return keys;
}

void TomlTable::finish() const {
  for (const std::string& key : keys())
    if (!asked_.contains(key)) unknown(key, {asked_.begin(), asked_.end()});
}

void TomlTable::allow(const std::vector<std::string>& known) const {
  for (const std::string& key : keys())
    if (std::find(known.begin(), known.end(), key) == known.end()) unknown(key, known);
}

void TomlTable::unknown(const std::string& key, const std::vector<std::string>& known) const {
  fail(key, "unknown-key", fmt::format("unknown key '{}' in {}", key, path_.empty() ? "the scenario" : path_),
       util::suggestion(key, known, 20));
}

}  // namespace heed::job
