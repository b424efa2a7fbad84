#include <heed/report/result.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

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

/// "297 of 1,000": what is not 0 or all is never said to be.
std::string of_thousand(double share) {
  const auto count = static_cast<std::uint64_t>(std::lround(1000 * share));
  if (count == 0 && share > 0) return "<1";
  if (count == 1000 && share < 1) return ">999";
  return grouped(count);
}

std::string listed(const std::vector<std::string>& items) {
  std::string out;
  for (std::size_t i = 0; i < items.size(); ++i)
    out += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return out;
}

/// Both kinds of error in one sentence.
void add_answer(const RunResult& result, std::size_t subject, std::vector<std::string>& sentences) {
  constexpr std::size_t most_profiles = 4;
  const Controller& controller = result.controllers[subject];
  std::vector<std::string> counts, names;
  double fewest = 1, most = 0;
  for (const Profile& profile : result.profiles) {
    const auto miss = miss_of(result, profile.name, controller.name);
    if (!miss) continue;
    counts.push_back(of_thousand(*miss));
    names.push_back(profile.name);
    fewest = std::min(fewest, *miss);
    most = std::max(most, *miss);
  }
  if (counts.empty()) return;
  const std::string misses = counts.size() <= most_profiles
                                 ? listed(counts)
                                 : fmt::format("{} to {}", of_thousand(fewest), of_thousand(most));
  const bool each = counts.size() > 1 && counts.size() <= most_profiles;
  std::string sentence = fmt::format("{} misses {} of 1,000 approaches{}", capital(title_of(controller)),
                                     misses, each ? fmt::format(" ({})", join(names, ", ")) : "");
  const ErrorCount errors = count_errors(result, controller.name);
  if (errors.signs > 0)
    sentence +=
        fmt::format(" and reacts needlessly to {} of {}", errors.needless, plural(errors.signs, result.kind));
  sentences.push_back(std::move(sentence));
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

/// The figures of one policy over the profiles, at the first level of noise.
std::vector<const TunedPolicy*> row_of(const Tuning& tuning, const std::string& policy) {
  std::vector<const TunedPolicy*> row;
  for (const TunedPolicy& one : tuning.figures)
    if (one.policy == policy && one.noise == tuning.figures.front().noise) row.push_back(&one);
  return row;
}

std::string shares(const std::vector<const TunedPolicy*>& row, Number TunedPolicy::*figure) {
  std::vector<std::string> texts;
  const bool same = std::all_of(row.begin(), row.end(), [&](const TunedPolicy* one) {
    return (one->*figure).value == (row.front()->*figure).value;
  });
  if (same) return percent((row.front()->*figure).value) + (row.size() > 1 ? " everywhere" : "");
  for (const TunedPolicy* one : row)
    texts.push_back(fmt::format("{} ({})", percent((one->*figure).value), one->profile));
  return join(texts, ", ");
}

/// Both errors at most as often in every profile, and one less often in some.
bool better(const std::vector<const TunedPolicy*>& a, const std::vector<const TunedPolicy*>& b) {
  bool somewhere = false;
  for (std::size_t p = 0; p < a.size(); ++p) {
    if (a[p]->miss.value > b[p]->miss.value || a[p]->needless.value > b[p]->needless.value) return false;
    somewhere |= a[p]->miss.value < b[p]->miss.value || a[p]->needless.value < b[p]->needless.value;
  }
  return somewhere;
}

/// Of "1/10".
double value_of(const std::string& fraction) {
  const auto slash = fraction.find('/');
  const double over = std::strtod(fraction.c_str(), nullptr);
  return slash == std::string::npos ? over : over / std::strtod(fraction.c_str() + slash + 1, nullptr);
}

/// What the subject's policy costs, and what does better.
void add_policies(const RunResult& result, std::size_t subject, std::vector<std::string>& sentences) {
  const Tuning& tuning = result.tuning;
  const Controller& controller = result.controllers[subject];
  std::vector<std::string> policies;
  std::string own;
  for (const TunedPolicy& one : tuning.figures) {
    if (std::find(policies.begin(), policies.end(), one.policy) == policies.end())
      policies.push_back(one.policy);
    if (one.controller == controller.name) own = one.policy;
  }
  if (own.empty()) return;
  const auto row = row_of(tuning, own);
  sentences.push_back(
      fmt::format("What “{}” costs: past what asks for no reaction (mean over {}) it reacts in {}", own,
                  plural(tuning.things, "thing"), shares(row, &TunedPolicy::needless)));
  const auto winner = std::find_if(policies.begin(), policies.end(), [&](const std::string& policy) {
    return better(row_of(tuning, policy), row);
  });
  if (winner != policies.end())
    sentences.push_back(fmt::format("“{}” is better in both: it misses {} and reacts needlessly in {}",
                                    *winner, shares(row_of(tuning, *winner), &TunedPolicy::miss),
                                    shares(row_of(tuning, *winner), &TunedPolicy::needless)));
  else
    sentences.push_back(fmt::format(
        "None of the {} other policies compared makes fewer errors of one kind without more of the other",
        policies.size() - 1));
  if (tuning.best.empty() || tuning.best == own) return;
  const std::string bound = tuning.bound.empty() ? ""
                                                 : fmt::format(" with needless reactions in {} at most",
                                                               percent(value_of(tuning.bound)));
  sentences.push_back(fmt::format("The fewest misses{}: “{}”, which misses {} and reacts needlessly in {}",
                                  bound, tuning.best, shares(row_of(tuning, tuning.best), &TunedPolicy::miss),
                                  shares(row_of(tuning, tuning.best), &TunedPolicy::needless)));
}

}  // namespace

std::vector<std::string> headline_of(const RunResult& result) {
  std::vector<std::string> sentences;
  if (const auto subject = subject_of(result)) {
    add_answer(result, *subject, sentences);
    add_policies(result, *subject, sentences);
    add_needless(result, *subject, sentences);
    add_overview(result, *subject, sentences);
    add_profiles(result, *subject, sentences);
  }
  add_verdicts(result, sentences);
  add_sampling(result, sentences);
  return sentences;
}

}  // namespace heed::report
