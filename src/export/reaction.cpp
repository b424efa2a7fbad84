#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

#include "reaction.h"

namespace heed::exporter {

using model::Domain;
using model::OutputRole;

std::string json_quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

ReactionWriter::ReactionWriter(const std::vector<model::Output>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto& [variable, role] = columns[i];
    Column column{variable.domain.kind, json_quoted(variable.name), {}, {}};
    if (!variable.comment.empty()) column.comment = json_quoted(variable.comment);
    for (const std::string& value : variable.domain.values) column.values.push_back(json_quoted(value));
    columns_.push_back(std::move(column));
    const bool boolean = variable.domain.kind == Domain::Kind::Boolean;
    if (role == OutputRole::Action && action_ == none)
      action_ = i;
    else if (role == OutputRole::Plant && plant_ == none)
      plant_ = i;
    else if (role == OutputRole::Recognised && boolean)
      recognised_.push_back(i);
    else if (role == OutputRole::Prescribed && boolean)
      prescribed_.push_back(i);
    else
      others_.push_back(i);
  }
  derived_ = recognised_;
  derived_.insert(derived_.end(), prescribed_.begin(), prescribed_.end());
}

void ReactionWriter::append_list(std::string& out, std::string_view key,
                                 const std::vector<std::size_t>& columns, const model::Valuation* letter,
                                 std::string Column::*text) const {
  out += ", \"";
  out += key;
  out += "\": [";
  bool first = true;
  for (const std::size_t column : columns) {
    const std::string& quoted = columns_[column].*text;
    if (letter == nullptr || (*letter)[column] == 0 || quoted.empty()) continue;
    if (!first) out += ", ";
    out += quoted;
    first = false;
  }
  out += ']';
}

void ReactionWriter::append_value(std::string& out, std::size_t column,
                                  const model::Valuation* letter) const {
  if (letter == nullptr || column == none) {
    out += "null";
    return;
  }
  const std::int32_t value = (*letter)[column];
  switch (columns_[column].kind) {
    case Domain::Kind::Boolean:
      out += value != 0 ? "true" : "false";
      return;
    case Domain::Kind::Integer:
      fmt::format_to(std::back_inserter(out), "{}", value);
      return;
    case Domain::Kind::Enumeration:
      out += columns_[column].values[static_cast<std::size_t>(value)];
      return;
  }
}

void ReactionWriter::append(std::string& out, const model::Valuation* letter) const {
  append_list(out, "recognised", recognised_, letter, &Column::name);
  append_list(out, "prescribed", prescribed_, letter, &Column::name);
  out += ", \"action\": ";
  append_value(out, action_, letter);
  out += ", \"state\": ";
  append_value(out, plant_, letter);
  out += ", \"outputs\": {";
  if (letter != nullptr)
    for (std::size_t i = 0; i < others_.size(); ++i) {
      if (i > 0) out += ", ";
      out += columns_[others_[i]].name;
      out += ": ";
      append_value(out, others_[i], letter);
    }
  out += '}';
  append_list(out, "why", derived_, letter, &Column::comment);
}

}  // namespace heed::exporter
