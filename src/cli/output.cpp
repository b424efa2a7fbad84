#include "output.h"

#include <fmt/format.h>

#include <cstdio>

namespace heed::cli {

void print(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

std::string to_text(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void print_json(const Json& document) {
  print(to_text(document));
}

void print_diagnostics(const util::Diagnostics& diagnostics, std::size_t most_notes) {
  std::size_t notes = 0;
  for (const util::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == util::Severity::Note && ++notes > most_notes) continue;
    fmt::print(stderr, "{}\n", util::to_string(diagnostic));
  }
  if (notes > most_notes) fmt::print(stderr, "note: and {} more notes\n", notes - most_notes);
}

Json to_json(const util::Location& location) {
  if (location.line == 0 && location.file_name().empty()) return nullptr;
  Json out;
  out["file"] = std::string(location.file_name());
  if (location.line != 0) out["line"] = location.line;
  if (location.column != 0) out["column"] = location.column;
  return out;
}

Json to_json(const util::Diagnostic& diagnostic) {
  static constexpr std::string_view words[] = {"note", "warning", "error"};
  Json out;
  out["severity"] = words[static_cast<std::size_t>(diagnostic.severity)];
  out["code"] = diagnostic.code;
  out["message"] = diagnostic.message;
  if (!diagnostic.hint.empty()) out["hint"] = diagnostic.hint;
  out["location"] = to_json(diagnostic.location);
  return out;
}

Json to_json(const util::Diagnostics& diagnostics) {
  Json out = Json::array();
  for (const util::Diagnostic& diagnostic : diagnostics) out.push_back(to_json(diagnostic));
  return out;
}

}  // namespace heed::cli
