#include "text_table.h"

#include <algorithm>
#include <cassert>

#include "format.h"

namespace heed::report {

namespace {

constexpr std::size_t indent = 2, gap = 2, narrowest = 8;

std::string blanks(std::size_t count) {
  return std::string(count, ' ');
}

void strip_end(std::string& line) {
  line.erase(line.find_last_not_of(' ') + 1);
}

/// Terminals show one line per row, whatever a label holds.
std::string flat(const std::string& cell) {
  std::string text = clean(cell);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return text;
}

std::size_t total(const std::vector<std::size_t>& widths) {
  std::size_t sum = indent;
  for (const std::size_t width : widths) sum += width + gap;
  return sum - gap;
}

}  // namespace

TextTable::TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

void TextTable::add(std::vector<std::string> cells) {
  assert(cells.size() <= columns_.size());
  cells.resize(columns_.size());
  for (std::string& cell : cells) cell = flat(cell);
  rows_.push_back(std::move(cells));
}

std::string TextTable::render(std::size_t width) const {
  if (rows_.empty() || columns_.empty()) return {};
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t widest = report::columns(flat(columns_[c].head));
    for (const auto& row : rows_) widest = std::max(widest, report::columns(row[c]));
    widths.push_back(std::min(widest, columns_[c].most));
  }
  while (total(widths) > width) {
    const auto widest = std::max_element(widths.begin(), widths.end());
    if (*widest <= narrowest) break;
    --*widest;
  }
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text = blanks(indent);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::string cell = shorten(cells[c], std::max<std::size_t>(widths[c], 1));
      const std::string padding = blanks(widths[c] - std::min(widths[c], report::columns(cell)));
      text += columns_[c].align == Align::Right ? padding + cell : cell + padding;
      text += blanks(gap);
    }
    strip_end(text);
    return shorten(text, width) + '\n';
  };
  std::vector<std::string> heads, rules;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    heads.push_back(flat(columns_[c].head));
    rules.push_back(std::string(widths[c], '-'));
  }
  std::string text = line(heads) + line(rules);
  for (const auto& row : rows_) text += line(row);
  return text;
}

std::string wrap(std::string_view text, std::size_t width, std::string_view first) {
  const std::string lead = blanks(columns(first));
  const std::size_t room = std::max(width, columns(first) + narrowest) - columns(first);
  std::string rest = flat(std::string(text)), result, line;
  const auto flush = [&] {
    std::string whole = (result.empty() ? std::string(first) : lead) + line;
    strip_end(whole);
    result += whole + '\n';
    line.clear();
  };
  for (std::size_t at = 0; at < rest.size();) {
    const std::size_t end = std::min(rest.find(' ', at), rest.size());
    std::string word = rest.substr(at, end - at);
    at = end + 1;
    // "12 %" is one word.
    if (at < rest.size() && rest[at] == '%' && !word.empty()) {
      const std::size_t after = std::min(rest.find(' ', at), rest.size());
      word += ' ' + rest.substr(at, after - at);
      at = after + 1;
    }
    if (word.empty()) continue;
    if (!line.empty() && columns(line) + 1 + columns(word) > room) flush();
    while (columns(word) > room) {
      const std::string head = shorten(word, room + 1);
      const std::size_t cut = std::max<std::size_t>(head.size() - std::string_view("…").size(), 1);
      line = word.substr(0, cut);
      word.erase(0, cut);
      flush();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty() || result.empty()) flush();
  return result;
}

}  // namespace heed::report
