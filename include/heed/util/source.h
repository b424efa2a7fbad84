#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace heed::util {

/// A place in an input. Line and column count from 1, columns in bytes; line 0 means "the file as a whole".
/// Copies share the file's name, so that a position on each of a million axioms stays cheap.
struct Location {
  std::shared_ptr<const std::string> file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  [[nodiscard]] std::string_view file_name() const {
    return file ? std::string_view(*file) : std::string_view();
  }
  friend bool operator==(const Location& a, const Location& b) {
    return a.line == b.line && a.column == b.column && a.file_name() == b.file_name();
  }
};

/// "file:line:column", without what is unknown.
[[nodiscard]] std::string to_string(const Location& location);

/// A named text whose offsets translate to locations. Immutable; copies share the text.
class SourceText {
 public:
  SourceText() = default;
  /// \param first_line,first_column  Where the text begins in its file: a string inside a scenario keeps its
  /// place.
  SourceText(std::string name, std::string text, std::uint32_t first_line = 1,
             std::uint32_t first_column = 1);

  [[nodiscard]] const std::string& text() const { return data_->text; }
  [[nodiscard]] const std::string& name() const { return *data_->name; }
  /// \param offset  In bytes, 0 ... text().size(). O(log lines).
  [[nodiscard]] Location at(std::size_t offset) const;
  /// The line that holds \p offset, without its end of line; for carets.
  [[nodiscard]] std::string_view line_of(std::size_t offset) const;

 private:
  struct Data {
    std::shared_ptr<const std::string> name;
    std::string text;
    std::vector<std::size_t> line_starts;
    std::uint32_t first_line, first_column;
  };
  std::shared_ptr<const Data> data_;
};

}  // namespace heed::util
