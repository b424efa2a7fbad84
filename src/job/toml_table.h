#pragma once

#include <heed/job/scenario.h>
#include <heed/util/source.h>

#include <toml++/toml.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace heed::job {

/// A table of the scenario that remembers which keys were asked for, so that finish() can name the others.
class TomlTable {
 public:
  TomlTable(const toml::table& table, std::shared_ptr<const std::string> file, std::string path)
      : table_(&table), file_(std::move(file)), path_(std::move(path)) {}

  [[nodiscard]] bool has(const std::string& key);
  [[nodiscard]] Word word(const std::string& key);
  [[nodiscard]] std::optional<Word> optional_word(const std::string& key);
  [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise);
  [[nodiscard]] bool is_flag(const std::string& key) const;
  [[nodiscard]] bool flag(const std::string& key, bool otherwise);
  [[nodiscard]] std::int64_t integer(const std::string& key, std::int64_t otherwise, std::int64_t low,
                                     std::int64_t high);
  [[nodiscard]] double real(const std::string& key, double otherwise, double low, double high);
  /// An array of strings, or one string.
  [[nodiscard]] std::vector<Word> words(const std::string& key);
  /// The text of one word, placed where it stands in the scenario.
  [[nodiscard]] util::SourceText source(const std::string& key);
  [[nodiscard]] std::vector<util::SourceText> sources(const std::string& key);
  /// A number, or a string, as the text of a rational or an onset; each item of an array of them.
  [[nodiscard]] util::SourceText scalar(const std::string& key);
  [[nodiscard]] std::vector<util::SourceText> scalars(const std::string& key);
  [[nodiscard]] bool is_array(const std::string& key) const;
  [[nodiscard]] TomlTable table(const std::string& key);
  [[nodiscard]] std::vector<TomlTable> tables(const std::string& key);
  [[nodiscard]] std::vector<std::string> keys() const;

  /// \throws util::InputError  for the first key that is none of \p known: told before anything that lacks
  /// because of it.
  void allow(const std::vector<std::string>& known) const;
  /// \throws util::InputError  for the first key that nobody asked for.
  void finish() const;
  [[noreturn]] void fail(const std::string& key, const std::string& code, const std::string& message,
                         const std::string& hint = {}) const;
  [[nodiscard]] util::Location location() const { return at(*table_); }
  [[nodiscard]] util::Location location_of(const std::string& key) const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[nodiscard]] const toml::node* find(const std::string& key);
  [[nodiscard]] util::Location at(const toml::node& node) const;
  [[nodiscard]] util::SourceText placed(const toml::node& node, const std::string& text) const;
  [[nodiscard]] Word read_word(const std::string& key, const toml::node& node) const;
  [[nodiscard]] util::SourceText read_scalar(const std::string& key, const toml::node& node) const;
  [[noreturn]] void missing(const std::string& key) const;
  [[noreturn]] void unknown(const std::string& key, const std::vector<std::string>& known) const;

  const toml::table* table_;
  std::shared_ptr<const std::string> file_;
  std::string path_;
  std::set<std::string> asked_;
};

/// Parses TOML. \throws util::InputError with the position.
[[nodiscard]] toml::table parse_toml(const util::SourceText& source);

}  // namespace heed::job
