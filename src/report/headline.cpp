#include <heed/report/result.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "format.h"
#include "lookup.h"

namespace heed::report {

namespace {

/// Below this a chart's samples contradict its exact figures rather than scatter around them.
constexpr double contradiction = 1e-6;

std::string capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// "Perception tree" inside a sentence is "perception tree"; names such as "P2" and "LTL" keep their
/// capitals.
std::string inside(std::string text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])))
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

bool competes(const RunResult& result, const Controller& controller, std::size_t subject) {
  return !controller.beside && controller.name != result.controllers[subject].name &&
         controller.verdict == Verdict::Verified;
}

/// The misses of the others under \p profile, the best first; ties as in the scenario.
std::vector<std::pair<double, std::string>> rivals(const RunResult& result, const std::string& profile,
                                                   std::size_t subject) {
  std::vector<std::pair<double, std::string>> found;
  for (const Controller& controller : result.controllers) {
    if (!competes(result, controller, subject)) continue;
    if (const auto miss = miss_of(result, profile, controller.name))
      found.emplace_back(*miss, inside(title_of(controller)));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return found;
}

void add_overview(const RunResult& result, std::size_t subject, std::vector<std::string>& sentences) {
  const Controller& controller = result.controllers[subject];
  std::size_t judged = 0, won = 0;
  for (const Profile& profile : result.profiles) {
    const auto miss = miss_of(result, profile.name, controller.name);
    const auto others = rivals(result, profile.name, subject);
    if (!miss || others.empty()) continue;
    ++judged;
    if (*miss < others.front().first) ++won;
  }
  if (judged < 2) return;
  const std::string name = capital(title_of(controller));
  if (won == judged)
    sentences.push_back(
        fmt::format("{} misses {} least often in all {} perception profiles", name, result.thing, judged));
  else
    sentences.push_back(fmt::format("{} misses {} least often in {} of {} perception profiles", name,
                                    result.thing, won, judged));
}

void add_profiles(const RunResult& result, std::size_t subject, std::vector<std::string>& sentences) {
  const Controller& controller = result.controllers[subject];
  for (const Profile& profile : result.profiles) {
    const auto miss = miss_of(result, profile.name, controller.name);
    if (!miss) continue;
    std::vector<std::string> others;
    for (const auto& [value, name] : rivals(result, profile.name, subject))
      others.push_back(fmt::format("{} {}", name, percent(value)));
    std::string sentence =
        fmt::format("{} misses {} in {} of approaches in {}", capital(title_of(controller)), result.thing,
                    percent(*miss), profile.name);
    if (!others.empty()) sentence += fmt::format(" ({})", join(others, ", "));
    sentences.push_back(std::move(sentence));
  }
}

void add_needless(const RunResult& result, std::size_t subject, std::vector<std::string>& sentences) {
  const ErrorCount own = count_errors(result, result.controllers[subject].name);
  if (own.signs == 0) return;
  std::string sentence =
      fmt::format("It reacts needlessly to {} of {}", own.needless, plural(own.signs, result.kind));
  if (own.needless > 0)
    sentence +=
        fmt::format(", at worst with probability {} ({})", percent(own.worst_needless), own.worst_sign);
  std::vector<std::string> others;
  for (const Controller& controller : result.controllers)
    if (competes(result, controller, subject))
      others.push_back(
          fmt::format("{} {}", inside(title_of(controller)), count_errors(result, controller.name).needless));
  if (!others.empty()) sentence += fmt::format("; {}", join(others, ", "));
  sentences.push_back(std::move(sentence));
  if (own.open_road)
    sentences.push_back(fmt::format("It also reacts where there is no {} at all", result.kind));
}

/// The answer where there is nothing to compare: it must stay short enough for a title.
bool add_none(const RunResult& result, std::vector<std::string>& sentences) {
  const auto lost = [](const Controller& c) { return c.verdict == Verdict::Unrealizable; };
  if (result.controllers.empty() || !std::all_of(result.controllers.begin(), result.controllers.end(), lost))
    return false;
  sentences.emplace_back("No controller exists");
  for (const Controller& controller : result.controllers)
    if (!controller.reasons.empty())
      sentences.push_back(fmt::format("{}: {}", capital(title_of(controller)), controller.reasons.front()));
  return true;
}

void add_verdicts(const RunResult& result, std::vector<std::string>& sentences) {
  if (add_none(result, sentences)) return;
  std::size_t verified = 0;
  for (const Controller& controller : result.controllers) {
    if (controller.verdict == Verdict::Verified) {
      ++verified;
      continue;
    }
    const bool refuted = controller.verdict == Verdict::Refuted;
    std::string sentence =
        refuted ? fmt::format("{} is refuted by the independent check", capital(title_of(controller)))
                : fmt::format("No controller exists for {}", inside(title_of(controller)));
    if (!controller.reasons.empty()) sentence += ": " + controller.reasons.front();
    sentences.push_back(std::move(sentence));
  }
  if (verified == 0) return;
  if (verified == 1 && result.controllers.size() == 1)
    sentences.push_back("The controller passed the independent check");
  else if (verified == result.controllers.size())
    sentences.push_back(fmt::format("All {} controllers passed the independent check", verified));
  else
    sentences.push_back(fmt::format("{} of {} controllers passed the independent check", verified,
                                    result.controllers.size()));
}

void add_sampling(const RunResult& result, std::vector<std::string>& sentences) {
  std::uint64_t traces = 0;
  double smallest = 1;
  std::size_t charts = 0, refuted = 0;
  for (const Chart& chart : result.charts) {
    if (chart.traces == 0) continue;
    ++charts;
    traces += chart.traces;
    smallest = std::min(smallest, chart.p_value);
    if (chart.p_value < contradiction) ++refuted;
  }
  if (charts == 0) return;
  if (refuted > 0)
    sentences.push_back(fmt::format("Sampling contradicts the exact figures in {} (smallest p = {:.2g})",
                                    plural(refuted, "chart"), smallest));
  else
    sentences.push_back(
        fmt::format("{} sampled traces agree with the exact figures (smallest p of {} = {:.2g})",
                    grouped(traces), plural(charts, "chart"), smallest));
}

}  // namespace

std::vector<std::string> headline_of(const RunResult& result) {
  std::vector<std::string> sentences;
  if (const auto subject = subject_of(result)) {
    add_overview(result, *subject, sentences);
    add_profiles(result, *subject, sentences);
    add_needless(result, *subject, sentences);
  }
  add_verdicts(result, sentences);
  add_sampling(result, sentences);
  return sentences;
}

}  // namespace heed::report
