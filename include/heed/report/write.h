#pragma once

#include <heed/report/result.h>

#include <string>
#include <utility>
#include <vector>

namespace heed::report {

/// One JSON document (docs/formats/result.md): keys in a fixed order, figures exact and as decimal,
/// everything that depends on the machine under the one key `timings`. Invalid UTF-8 is replaced by U+FFFD.
/// Ends with a line feed.
[[nodiscard]] std::string to_json(const RunResult& result);

struct TextOptions {
  bool details = false;     ///< Also σ and the axioms behind it.
  std::size_t width = 100;  ///< Columns, 60 or more; long texts are wrapped, tables never exceed it.
};

/// Plain text for the terminal, no escapes, UTF-8. Ends with a line feed.
[[nodiscard]] std::string to_text(const RunResult& result, const TextOptions& options = {});

/// One self-contained page, XHTML-compatible HTML with inline SVG: no network, no script, light and dark,
/// prints. Every number of a chart carries its JSON value in `data-value` and its place in the document in
/// `data-path`.
[[nodiscard]] std::string to_html(const RunResult& result);

/// What a profile reports, for a picture: per feature the probability that it is reported in each cell.
struct ProfilePicture {
  std::string name, title;
  std::vector<std::pair<std::string, std::vector<double>>> features;
};
/// One row per profile, one plot per feature. Same value, same bytes.
[[nodiscard]] std::string to_svg(const std::vector<ProfilePicture>& profiles);

/// The policies as an SVG document: one panel for each profile and level of noise, misses over needless
/// reactions, with the front. Same value, same bytes.
[[nodiscard]] std::string to_svg(const Tuning& tuning);

}  // namespace heed::report
