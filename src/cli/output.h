#pragma once

#include <heed/util/diagnostic.h>

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace heed::cli {

using Json = nlohmann::ordered_json;

/// Writes to standard output at once; a reader that went away is no error of ours.
void print(std::string_view text);
/// One JSON document and a line feed.
[[nodiscard]] std::string to_text(const Json& document);
void print_json(const Json& document);
/// Warnings and notes to standard error, one after the other; at most \p most notes.
void print_diagnostics(const util::Diagnostics& diagnostics, std::size_t most_notes = 5);

[[nodiscard]] Json to_json(const util::Location& location);
[[nodiscard]] Json to_json(const util::Diagnostic& diagnostic);
[[nodiscard]] Json to_json(const util::Diagnostics& diagnostics);

}  // namespace heed::cli
