#include "lookup.h"

#include <fmt/format.h>

#include <algorithm>

#include "format.h"

namespace heed::report {

namespace {

template <typename Range>
std::optional<std::size_t> place(const Range& range, std::string_view profile, std::string_view controller) {
  for (std::size_t i = 0; i < range.size(); ++i)
    if (range[i].profile == profile && range[i].controller == controller) return i;
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> find_chart(const RunResult& result, std::string_view profile,
                                      std::string_view controller) {
  return place(result.charts, profile, controller);
}

std::optional<std::size_t> find_encounter(const CatalogueEntry& entry, std::string_view profile,
                                          std::string_view controller) {
  return place(entry.encounters, profile, controller);
}

std::optional<std::size_t> miss_bar(const RunResult& result, const Chart& chart) {
  for (std::size_t i = 0; i < chart.bars.size(); ++i)
    if (chart.bars[i].label == result.miss_label) return i;
  return std::nullopt;
}

std::optional<double> miss_of(const RunResult& result, std::string_view profile,
                              std::string_view controller) {
  const auto chart = find_chart(result, profile, controller);
  if (!chart) return std::nullopt;
  const auto bar = miss_bar(result, result.charts[*chart]);
  if (!bar) return std::nullopt;
  return result.charts[*chart].bars[*bar].exact.value;
}

std::optional<std::size_t> subject_of(const RunResult& result) {
  std::optional<std::size_t> best;
  double fewest = 0;
  for (std::size_t i = 0; i < result.controllers.size(); ++i) {
    const Controller& controller = result.controllers[i];
    if (controller.verdict != Verdict::Verified) continue;
    double sum = 0;
    std::size_t charts = 0;
    for (const Profile& profile : result.profiles)
      if (const auto miss = miss_of(result, profile.name, controller.name)) {
        sum += *miss;
        ++charts;
      }
    if (charts == 0) continue;
    if (controller.name == result.subject) return i;
    if (controller.beside) continue;
    if (!best || sum < fewest) {
      best = i;
      fewest = sum;
    }
  }
  return best;
}

std::vector<std::string> bar_labels(const RunResult& result, std::string_view profile) {
  std::vector<std::string> labels;
  for (const Chart& chart : result.charts) {
    if (!profile.empty() && chart.profile != profile) continue;
    for (const Bar& bar : chart.bars)
      if (std::find(labels.begin(), labels.end(), bar.label) == labels.end()) labels.push_back(bar.label);
  }
  return labels;
}

bool has_errors(const RunResult& result) {
  return !result.catalogue.empty() &&
         std::any_of(result.controllers.begin(), result.controllers.end(),
                     [](const Controller& c) { return c.verdict != Verdict::Unrealizable; });
}

std::string errors_explained(const RunResult& result) {
  return "“Can miss” counts the " + result.kind +
         "s that must be reacted to and that the controller passes without reacting in time with a "
         "probability "
         "above 0 in some profile; a full count says that late perception can defeat it at each of them, not "
         "that "
         "it does so every time. “Needlessly” counts those that neither oblige to react nor excuse it, and "
         "at "
         "which it reacts with a probability above 0.";
}

std::string road_explained(const Road& road) {
  return fmt::format(
      "{} passed one after another: {}. “Needless” and “misses” are how many are to be expected on the whole "
      "road, “a thing” says how many for each thing passed when the road goes on for ever.",
      plural(road.length, "thing"), road.description);
}

bool sees_conflicts(const Road& road) {
  return std::any_of(road.drives.begin(), road.drives.end(),
                     [](const Drive& drive) { return drive.conflict.has_value(); });
}

ErrorCount count_errors(const RunResult& result, std::string_view controller) {
  ErrorCount count;
  for (const CatalogueEntry& entry : result.catalogue) {
    bool judged = false, needless = false, missed = false;
    for (const Encounter& encounter : entry.encounters) {
      if (encounter.controller != controller) continue;
      judged = true;
      if (encounter.miss && encounter.miss->value > 0) missed = true;
      if (!encounter.needless || encounter.needless->value <= 0) continue;
      needless = true;
      if (!entry.name.empty() && encounter.needless->value > count.worst_needless) {
        count.worst_needless = encounter.needless->value;
        count.worst_sign = label_of(entry);
      }
    }
    if (!judged) continue;
    if (entry.name.empty()) {
      count.open_road = needless;
      continue;
    }
    if (entry.prescribes_halt) {
      ++count.halting;
      count.missed += missed ? 1 : 0;
    } else if (!entry.prescribes_give_way) {
      ++count.signs;
      count.needless += needless ? 1 : 0;
    }
  }
  return count;
}

const std::string& title_of(const Controller& controller) {
  return controller.title.empty() ? controller.name : controller.title;
}

const std::string& label_of(const CatalogueEntry& entry) {
  static const std::string open_road = "nothing there";
  if (!entry.label.empty()) return entry.label;
  return entry.name.empty() ? open_road : entry.name;
}

}  // namespace heed::report
