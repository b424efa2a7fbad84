#pragma once

#include <heed/report/result.h>

#include <optional>
#include <string_view>
#include <vector>

namespace heed::report {

/// The chart of one controller under one profile, and its place in `charts`; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> find_chart(const RunResult& result, std::string_view profile,
                                                    std::string_view controller);

/// The encounter of \p entry, likewise.
[[nodiscard]] std::optional<std::size_t> find_encounter(const CatalogueEntry& entry, std::string_view profile,
                                                        std::string_view controller);

/// The place of the bar that counts as a miss.
[[nodiscard]] std::optional<std::size_t> miss_bar(const RunResult& result, const Chart& chart);

/// The probability of a miss; nothing without chart or bar.
[[nodiscard]] std::optional<double> miss_of(const RunResult& result, std::string_view profile,
                                            std::string_view controller);

/// The controller that the headline is about; nothing where none is verified and has a chart.
[[nodiscard]] std::optional<std::size_t> subject_of(const RunResult& result);

/// Labels of the bars in order of appearance, over all charts of \p profile (all profiles when empty).
[[nodiscard]] std::vector<std::string> bar_labels(const RunResult& result, std::string_view profile = {});

/// Whether anything drove past the catalogue: there is one, and a controller to judge.
[[nodiscard]] bool has_errors(const RunResult& result);

/// What "can miss" and "needlessly" mean, for whoever reads the counts.
[[nodiscard]] std::string errors_explained(const RunResult& result);

/// What stands on the road and what is counted, in a sentence.
[[nodiscard]] std::string road_explained(const Road& road);
/// Whether any controller on it can tell that what is seen contradicts itself.
[[nodiscard]] bool sees_conflicts(const Road& road);

/// How one controller errs over the catalogue.
struct ErrorCount {
  std::uint64_t signs = 0;  ///< Signs for which stopping is needless.
  std::uint64_t needless =
      0;  ///< Of these, how many make the car stop with a probability above 0 in some profile.
  std::uint64_t halting = 0;  ///< Signs that prescribe halting.
  std::uint64_t missed = 0;   ///< Of these, how many are missed with a probability above 0 in some profile.
  double worst_needless = 0;
  std::string worst_sign;  ///< Label; empty when worst_needless is 0.
  bool open_road = false;  ///< The car stops for nothing at all in some profile.
};
[[nodiscard]] ErrorCount count_errors(const RunResult& result, std::string_view controller);

/// Title, else name.
[[nodiscard]] const std::string& title_of(const Controller& controller);
[[nodiscard]] const std::string& label_of(const CatalogueEntry& entry);

}  // namespace heed::report
