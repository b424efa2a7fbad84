#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/job/tune.h>
#include <heed/report/write.h>
#include <heed/sim/rational.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace heed::cli {
namespace {

sim::Rational probability(const std::string& option, const std::string& text) {
  sim::Rational value = sim::parse_rational(util::SourceText(option, text));
  if (value > 1)
    throw UsageError(fmt::format("{}: {} is no probability", option, text), "such as 1/100 or 0.01");
  return value;
}

job::TuneOptions read_options(const Arguments& arguments, const job::Scenario& scenario) {
  job::TuneOptions options = job::tune_options(scenario);
  if (arguments.has("--false-braking"))
    options.most_needless = probability("--false-braking", arguments.text("--false-braking"));
  if (!arguments.has("--noise")) return options;
  options.noise.clear();
  std::istringstream levels(arguments.text("--noise"));
  for (std::string level; std::getline(levels, level, ',');)
    options.noise.push_back(probability("--noise", level));
  if (options.noise.empty()) throw UsageError("--noise names no level", "such as --noise 0,1/100,1/20");
  return options;
}

Json figure_json(const sim::Figure& figure) {
  Json out{{"exact", nullptr}};
  if (figure.exact) out["exact"] = sim::fraction(*figure.exact);
  out["value"] = figure.value;
  out["error"] = figure.exact ? 0 : figure.error;
  return out;
}

Json tuning_json(const job::Tuning& tuning, const job::Scenario& scenario) {
  Json figures = Json::array();
  for (const job::TuneFigure& figure : tuning.figures)
    figures.push_back({{"policy", tuning.policies[figure.policy]},
                       {"profile", scenario.profiles[figure.profile].spec.name},
                       {"noise", sim::fraction(tuning.noise[figure.noise])},
                       {"miss", figure_json(figure.miss)},
                       {"needless", figure_json(figure.needless)},
                       {"cells_left", figure_json(figure.distance)},
                       {"braking", figure.braking ? figure_json(*figure.braking) : Json(nullptr)},
                       {"hardest_braking", figure.hardest ? figure_json(*figure.hardest) : Json(nullptr)},
                       {"on_front", figure.on_front}});
  Json left_out = Json::array();
  for (const job::LeftOut& one : tuning.left_out)
    left_out.push_back({{"policy", one.policy}, {"reason", one.reason}});
  return {{"best", tuning.best ? Json(tuning.policies[*tuning.best]) : Json(nullptr)},
          {"left_out", std::move(left_out)},
          {"figures", std::move(figures)}};
}

std::size_t longest(const std::vector<std::string>& words) {
  std::size_t width = 6;
  for (const std::string& word : words) width = std::max(width, word.size());
  return width;
}

bool brakes(const job::Tuning& tuning) {
  return std::any_of(tuning.figures.begin(), tuning.figures.end(),
                     [](const job::TuneFigure& figure) { return figure.braking.has_value(); });
}

std::string braking(const job::TuneFigure& figure) {
  if (!figure.braking) return fmt::format(" {:>10} {:>10}", "-", "-");
  return fmt::format(" {:>10.3f} {:>10.3f}", figure.braking->value, figure.hardest->value);
}

std::string tables(const job::Tuning& tuning, const job::Scenario& scenario, bool all) {
  std::string out;
  const std::size_t width = longest(tuning.policies);
  const job::TuneFigure* before = nullptr;
  for (const job::TuneFigure& figure : tuning.figures) {
    if (before == nullptr || before->profile != figure.profile || before->noise != figure.noise)
      out +=
          fmt::format("{}{}: {}, noise {}\n  {:<{}} {:>10} {:>10} {:>10}{}\n", out.empty() ? "" : "\n",
                      scenario.profiles[figure.profile].spec.name, scenario.profiles[figure.profile].title,
                      sim::fraction(tuning.noise[figure.noise]), "policy", width, "misses", "needless",
                      "cells left", brakes(tuning) ? fmt::format(" {:>10} {:>10}", "m/s2", "hardest") : "");
    before = &figure;
    if (all || figure.on_front)
      out += fmt::format("{} {:<{}} {:>10.6f} {:>10.6f} {:>10.4f}{}\n", figure.on_front ? '*' : ' ',
                         tuning.policies[figure.policy], width, figure.miss.value, figure.needless.value,
                         figure.distance.value, brakes(tuning) ? braking(figure) : "");
  }
  return out;
}

/// The answer, with the exact figures of every profile and level of noise.
std::string answer(const job::Tuning& tuning, const job::Scenario& scenario,
                   const job::TuneOptions& options) {
  const std::string bound = options.most_needless
                                ? fmt::format(" with needless reactions of {} at most everywhere",
                                              sim::fraction(*options.most_needless))
                                : std::string();
  std::string out;
  for (const job::LeftOut& one : tuning.left_out)
    out += fmt::format("\nLeft out: {}: {}", one.policy, one.reason);
  if (!out.empty()) out += '\n';
  if (!tuning.best) return out + fmt::format("\nNo policy{}.\n", bound);
  out += fmt::format("\nFewest misses in its worst case{}: {}\n", bound, tuning.policies[*tuning.best]);
  for (const job::TuneFigure& figure : tuning.figures) {
    if (figure.policy != *tuning.best) continue;
    const auto exact = [](const sim::Figure& one) {
      return one.exact ? sim::fraction(*one.exact) : fmt::format("{} +- {:.1e}", one.value, one.error);
    };
    out += fmt::format("  {}, noise {}: misses {}, needless {}, cells left {}\n",
                       scenario.profiles[figure.profile].spec.name, sim::fraction(tuning.noise[figure.noise]),
                       exact(figure.miss), exact(figure.needless), exact(figure.distance));
  }
  return out;
}

}  // namespace

int tune_command(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  util::Budget budget(limits);
  const job::Scenario scenario = load_scenario(arguments);
  const job::TuneOptions options = read_options(arguments, scenario);
  if (!scenario.evaluate || scenario.profiles.empty())
    throw UsageError("the scenario has no [[profile]] and [evaluate]",
                     "they say what is seen and what counts");
  const job::World world = job::load_world(scenario, limits, budget);
  const job::Tuning tuning = job::tune(scenario, world, options, budget);
  if (const std::string path = arguments.text("--output"); !path.empty())
    util::write_file(path, report::to_svg(job::describe_tuning(scenario, tuning, options)));
  if (arguments.json())
    print_json(tuning_json(tuning, scenario));
  else
    print(tables(tuning, scenario, arguments.has("--all")) + answer(tuning, scenario, options));
  return tuning.best ? 0 : 1;
}

}  // namespace heed::cli
