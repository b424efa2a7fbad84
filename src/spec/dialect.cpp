#include <heed/spec/dialect.h>
#include <heed/spec/gr1c.h>
#include <heed/spec/slugsin.h>
#include <heed/spec/structured_slugs.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>

#include "peer.h"
#include "portable.h"
#include "words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace heed::spec {
namespace {

struct Entry {
  Dialect dialect;
  std::string_view word, extension;
};

constexpr std::array<Entry, 4> dialects{{{Dialect::Gr1, "gr1", ".gr1"},
                                         {Dialect::Slugsin, "slugsin", ".slugsin"},
                                         {Dialect::StructuredSlugs, "structuredslugs", ".structuredslugs"},
                                         {Dialect::Gr1c, "gr1c", ".spc"}}};

constexpr std::array<std::string_view, 8> slugs_words{"[INPUT]",        "[OUTPUT]",      "[ENV_INIT]",
                                                      "[SYS_INIT]",     "[ENV_TRANS]",   "[SYS_TRANS]",
                                                      "[ENV_LIVENESS]", "[SYS_LIVENESS]"};
constexpr std::array<std::string_view, 8> gr1c_words{
    "ENV:", "SYS:", "ENVINIT:", "ENVTRANS:", "ENVGOAL:", "SYSINIT:", "SYSTRANS:", "SYSGOAL:"};

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

/// A line with what only structured slugs knows: an integer's range, or a formula that begins with a name or
/// parenthesis and goes on.
bool is_structured(std::string_view line) {
  if (line.find("...") != std::string_view::npos) return true;
  if (line.find_first_of("()=<>") != std::string_view::npos) return true;
  const std::size_t blank = line.find_first_of(" \t");
  return blank != std::string_view::npos &&
         std::string_view("&|^!$?").find(line[0]) == std::string_view::npos;
}

Dialect by_content(std::string_view text) {
  bool slugs = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    if (line.empty() || line[0] == '#') continue;
    for (const std::string_view word : gr1c_words)
      if (line.starts_with(word)) return Dialect::Gr1c;
    const bool section = std::find(slugs_words.begin(), slugs_words.end(), line) != slugs_words.end();
    if (!slugs && !section) return Dialect::Gr1;
    slugs = true;
    if (!section && is_structured(line)) return Dialect::StructuredSlugs;
  }
  return slugs ? Dialect::Slugsin : Dialect::Gr1;
}

}  // namespace

std::string_view to_string(Dialect dialect) {
  for (const Entry& entry : dialects)
    if (entry.dialect == dialect) return entry.word;
  return {};
}

std::optional<Dialect> dialect_named(std::string_view word) {
  for (const Entry& entry : dialects)
    if (entry.word == word) return entry.dialect;
  return std::nullopt;
}

Dialect dialect_of(const util::SourceText& source) {
  for (const Entry& entry : dialects)
    if (source.name().ends_with(entry.extension)) return entry.dialect;
  return by_content(source.text());
}

Gr1 read_any(const util::SourceText& source, const util::Limits& limits) {
  switch (dialect_of(source)) {
    case Dialect::Gr1:
      break;
    case Dialect::Slugsin:
      return read_slugsin(source, limits);
    case Dialect::StructuredSlugs:
      return read_structured_slugs(source, limits);
    case Dialect::Gr1c:
      return read_gr1c(source, limits);
  }
  return read_gr1(source, limits);
}

namespace {

/// heed's own format has no shared parts either.
std::string write_own(const Gr1& spec) {
  std::vector<logic::Formula> formulas;
  for (const Part& part : parts)
    for (const Clause& clause : spec.*part.clauses) formulas.push_back(clause.formula);
  insist_on_small(formulas, "gr1");
  return write_gr1(spec);
}

}  // namespace

std::string write_as(const Gr1& spec, Dialect dialect) {
  switch (dialect) {
    case Dialect::Gr1:
      break;
    case Dialect::Slugsin:
      return write_slugsin(spec);
    case Dialect::StructuredSlugs:
      return write_structured_slugs(spec);
    case Dialect::Gr1c:
      return write_gr1c(spec);
  }
  return write_own(spec);
}

}  // namespace heed::spec
