#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace heed::report {

/// A table in plain text: columns aligned by what a terminal shows, two blanks between them, a rule under the
/// head.
class TextTable {
 public:
  enum class Align { Left, Right };
  struct Column {
    std::string head;
    Align align = Align::Left;
    std::size_t most = 40;  ///< Longer cells are shortened.
  };

  explicit TextTable(std::vector<Column> columns);
  /// Missing cells are blank. \pre at most as many cells as columns
  void add(std::vector<std::string> cells);
  /// Indented by two. Never wider than \p width: the widest left-aligned column gives way, then the last
  /// columns fall out of sight behind an ellipsis. Ends with a line feed; empty without rows.
  [[nodiscard]] std::string render(std::size_t width) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// \p text in lines of at most \p width columns, broken at blanks (inside a word only where it is longer than
/// a line); the first line begins with \p first, the others with as many blanks. Ends with a line feed.
[[nodiscard]] std::string wrap(std::string_view text, std::size_t width, std::string_view first = {});

}  // namespace heed::report
