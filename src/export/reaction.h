#pragma once

#include <heed/model/mealy.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace heed::exporter {

/// \p text as a JSON string; bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string json_quoted(std::string_view text);

/// Writes reactions as members of a JSON object (docs/formats/exec.md), from "recognised" to "why". What can
/// be quoted beforehand is.
class ReactionWriter {
 public:
  explicit ReactionWriter(const std::vector<model::Output>& columns);
  /// \param letter  Values of the output columns, or nullptr: before any reaction.
  void append(std::string& out, const model::Valuation* letter) const;

 private:
  struct Column {
    model::Domain::Kind kind;
    std::string name, comment;        ///< Quoted; comment empty where there is none.
    std::vector<std::string> values;  ///< Quoted, of an enumeration.
  };
  static constexpr std::size_t none = SIZE_MAX;

  void append_list(std::string& out, std::string_view key, const std::vector<std::size_t>& columns,
                   const model::Valuation* letter, std::string Column::*text) const;
  void append_value(std::string& out, std::size_t column, const model::Valuation* letter) const;

  std::vector<Column> columns_;
  std::vector<std::size_t> recognised_, prescribed_, derived_, others_;
  std::size_t action_ = none, plant_ = none;
};

}  // namespace heed::exporter
