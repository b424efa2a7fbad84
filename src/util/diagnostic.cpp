#include <heed/util/diagnostic.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace heed::util {
namespace {

/// The line around \p offset with a caret below, cut to 100 bytes so that a minified file stays readable.
std::string excerpt(const SourceText& source, std::size_t offset) {
  constexpr std::size_t width = 100;
  const std::string_view line = source.line_of(offset);
  const auto line_begin = static_cast<std::size_t>(line.data() - source.text().data());
  std::size_t column = std::min(offset >= line_begin ? offset - line_begin : 0, line.size());
  std::size_t first = column > width / 2 ? column - width / 2 : 0;
  std::string shown(line.substr(first, width));
  for (char& c : shown)
    if (c == '\t') c = ' ';
  return fmt::format("  {}\n  {}^", shown, std::string(column - first, ' '));
}

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other, whatever
/// their case.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({last[j] + (same(a[i], b[j]) ? 0 : 1), last[j + 1] + 1, row[j] + 1});
      const bool swapped = i > 0 && j > 0 && same(a[i], b[j - 1]) && same(a[i - 1], b[j]);
      if (swapped) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row[b.size()];
}

std::string_view word(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "error";
}

}  // namespace

std::string to_string(const Diagnostic& d) {
  std::string out = to_string(d.location);
  if (!out.empty()) out += ": ";
  out += fmt::format("{}: {}", word(d.severity), d.message);
  if (!d.code.empty()) out += fmt::format(" [{}]", d.code);
  if (!d.excerpt.empty()) out += '\n' + d.excerpt;
  if (!d.hint.empty()) out += "\nhint: " + d.hint;
  return out;
}

InputError::InputError(Diagnostic diagnostic)
    : std::runtime_error(to_string(diagnostic)), diagnostic_(std::move(diagnostic)) {}

InputError::InputError(Location location, std::string code, std::string message, std::string hint)
    : InputError(Diagnostic{
          Severity::Error, std::move(location), std::move(code), std::move(message), std::move(hint), {}}) {}

InputError::InputError(const SourceText& source, std::size_t offset, std::string code, std::string message,
                       std::string hint)
    : InputError(Diagnostic{Severity::Error, source.at(offset), std::move(code), std::move(message),
                            std::move(hint), excerpt(source, offset)}) {}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > word.size() + best_distance || word.size() > candidate.size() + best_distance)
      continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates, std::size_t most) {
  if (const std::string near = nearest(word, candidates); !near.empty())
    return fmt::format("did you mean '{}'?", near);
  if (candidates.empty()) return {};
  const std::vector<std::string> first(
      candidates.begin(),
      candidates.begin() + static_cast<std::ptrdiff_t>(std::min(most, candidates.size())));
  return fmt::format("known: {}{}", fmt::join(first, ", "), candidates.size() > most ? ", ..." : "");
}

}  // namespace heed::util
