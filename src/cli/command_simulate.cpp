#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/job/chain.h>
#include <heed/job/evaluate.h>
#include <heed/model/symbolic.h>
#include <heed/sim/rational.h>
#include <heed/sim/statistics.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>
#include <variant>

namespace heed::cli {
namespace {

/// What is simulated: scenario and what stands beside it.
struct Setting {
  const job::Scenario& scenario;
  const job::World& world;
  job::Thing thing;
  job::EvaluateOptions options;
};

job::Thing thing_on_road(const Arguments& arguments, const job::Scenario& scenario, const job::World& world) {
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  const std::string word = arguments.text("--thing");
  if (word == "none") return std::nullopt;
  if (!word.empty()) return catalogue.entity(word);
  if (const auto& approached = scenario.evaluate->approached)
    return catalogue.entity(awareness::Name(approached->text, approached->location));
  throw UsageError("what is on the road?", "name it with --thing, or as 'approached' in [evaluate]");
}

std::vector<const job::ProfilePart*> chosen_profiles(const Arguments& arguments,
                                                     const job::Scenario& scenario) {
  const std::string wanted = arguments.text("--profile");
  std::vector<const job::ProfilePart*> chosen;
  std::vector<std::string> known;
  for (const job::ProfilePart& profile : scenario.profiles) {
    known.push_back(profile.spec.name);
    if (wanted.empty() || wanted == profile.spec.name) chosen.push_back(&profile);
  }
  if (chosen.empty())
    throw UsageError(fmt::format("the scenario has no profile '{}'", wanted),
                     util::suggestion(wanted, known));
  return chosen;
}

void add_figure(const sim::Figure& figure, Json& out) {
  out["exact"] = figure.exact ? Json(sim::fraction(*figure.exact)) : Json(nullptr);
  out["value"] = figure.value;
  if (!figure.exact) out["error"] = figure.error;
}

/// "0.296875  19/64"; what is rounded, or too long to be read, with its bound.
std::string figure_text(const sim::Figure& figure) {
  constexpr std::size_t most = 60;
  const std::string exact = figure.exact ? sim::fraction(*figure.exact) : std::string();
  if (!figure.exact) return fmt::format("{:>8.6g}  +- {:<17.1e}", figure.value, figure.error);
  return fmt::format("{:>8}  {:<20}", sim::decimal(*figure.exact, 6), exact.size() > most ? "" : exact);
}

Json reaction_json(const sim::LumpedOutcome& figures) {
  const sim::ReactionDistance distance = sim::reaction_distance(figures);
  Json out;
  add_figure(distance.mean, out["mean"]);
  out["when_it_reacts"] = nullptr;
  if (distance.when_it_reacts) add_figure(*distance.when_it_reacts, out["when_it_reacts"] = Json::object());
  return out;
}

Json lumps_json(const sim::Lumps& lumps) {
  return {{"components", lumps.components},
          {"groups", lumps.groups},
          {"largest_group", lumps.largest_group},
          {"machine_states", lumps.machine_states},
          {"widest_layer", lumps.widest_layer}};
}

Json evaluation_json(const job::Evaluation& found) {
  Json out = Json::array();
  for (std::size_t c = 0; c < found.categories.size(); ++c) {
    Json bar;
    bar["label"] = found.categories[c];
    add_figure(found.figures.probability[c], bar);
    if (found.sampled.traces > 0) {
      const sim::Interval interval =
          sim::wilson(found.sampled.count[c], found.sampled.traces, found.confidence);
      bar["sampled"] = found.sampled.count[c];
      bar["low"] = interval.low;
      bar["high"] = interval.high;
    }
    out.push_back(std::move(bar));
  }
  return out;
}

std::string evaluation_text(const job::Evaluation& found) {
  std::string out;
  for (std::size_t c = 0; c < found.categories.size(); ++c) {
    out += fmt::format("  {:<14} {}", found.categories[c], figure_text(found.figures.probability[c]));
    if (found.sampled.traces > 0) {
      const sim::Interval interval =
          sim::wilson(found.sampled.count[c], found.sampled.traces, found.confidence);
      out +=
          fmt::format(" sampled {:.6f} [{:.6f}, {:.6f}]",
                      static_cast<double>(found.sampled.count[c]) / static_cast<double>(found.sampled.traces),
                      interval.low, interval.high);
    }
    out += '\n';
  }
  const sim::ReactionDistance distance = sim::reaction_distance(found.figures);
  out += fmt::format("  {:<14} {} on average, 0 where it does not react\n", "cells left",
                     figure_text(distance.mean));
  const sim::Figure& undefined = found.figures.undefined;
  if (undefined.value > 0) out += fmt::format("  {:<14} {}\n", "no answer", figure_text(undefined));
  return out;
}

/// A word for a file's name.
std::string file_word(const std::string& name) {
  std::string word;
  for (const char c : name)
    word += std::isalnum(static_cast<unsigned char>(c)) != 0
                ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                : '-';
  return word;
}

/// Writes the chain of a controller on a profile where --chain asks for it.
void write_chain(const Arguments& arguments, const Setting& setting, const job::ProfilePart& profile,
                 const model::Mealy& machine, util::Budget& budget) {
  const std::string format = arguments.text("--chain");
  if (format.empty() || !arguments.writes()) return;
  const sim::Product chain =
      job::chain(setting.scenario, setting.world, profile, machine, setting.thing, budget);
  const std::string folder = arguments.text("--output", ".");
  std::error_code unwritable;  // write_file() says so
  std::filesystem::create_directories(folder, unwritable);
  util::write_file(
      fmt::format("{}/{}-{}.{}", folder, file_word(machine.name), file_word(profile.spec.name), format),
      format == "prism" ? sim::write_prism(chain) : sim::write_jani(chain));
}

/// What splitting finds for the outcome that --rare names.
struct Rare {
  std::string outcome;
  sim::Figure exact;
  sim::RareEstimate estimate;
};

std::optional<Rare> find_rare(const Arguments& arguments, const Setting& setting,
                              const job::ProfilePart& profile, const model::Mealy& machine,
                              const job::Evaluation& found, util::Budget& budget) {
  const std::string wanted = arguments.text("--rare");
  if (wanted.empty()) return std::nullopt;
  const auto place = std::find(found.categories.begin(), found.categories.end(), wanted);
  if (place == found.categories.end())
    throw UsageError(fmt::format("--rare: the scenario has no outcome '{}'", wanted),
                     util::suggestion(wanted, found.categories));
  sim::RareOptions options;
  options.category = static_cast<std::uint32_t>(place - found.categories.begin());
  options.seed = setting.options.seed;
  options.confidence = setting.scenario.evaluate->confidence;
  options.team = arguments.team();
  options.particles =
      static_cast<std::uint32_t>(arguments.number("--particles", 1, 100'000'000).value_or(options.particles));
  return Rare{
      wanted, found.figures.probability[options.category],
      job::estimate_rare(setting.scenario, setting.world, profile, machine, setting.thing, options, budget)};
}

std::string rare_text(const Rare& rare) {
  const sim::RareEstimate& found = rare.estimate;
  std::string out =
      fmt::format("  {} by splitting: {:.4g} [{:.4g}, {:.4g}], standard error {:.2g}\n", rare.outcome,
                  found.probability, found.interval.low, found.interval.high, found.standard_error);
  if (found.extinct > 0)
    out += fmt::format("  no run came through in {} repetitions: more --particles may help\n", found.extinct);
  return out;
}

Json rare_json(const Rare& rare) {
  const sim::RareEstimate& found = rare.estimate;
  Json out{{"outcome", rare.outcome}};
  out["exact"] = rare.exact.exact ? Json(sim::fraction(*rare.exact.exact)) : Json(nullptr);
  out.update({{"estimate", found.probability},
              {"standard_error", found.standard_error},
              {"low", found.interval.low},
              {"high", found.interval.high},
              {"extinct", found.extinct},
              {"survival", found.survival}});
  return out;
}

/// A controller from disk: listed state by state, or by functions.
using AnyController = std::variant<model::Mealy, model::SymbolicController>;

AnyController read_controller(const std::string& path, const util::Limits& limits) {
  const util::SourceText source = util::read_file(path, limits);
  if (model::is_symbolic(source)) return model::read_symbolic(source, limits);
  return model::read_mealy(source, limits);
}

/// \throws UsageError  an option that needs every state listed
const model::Mealy* listed(const Arguments& arguments, const AnyController& controller) {
  const auto* machine = std::get_if<model::Mealy>(&controller);
  for (const char* option : {"--chain", "--rare", "--width"})
    if (machine == nullptr && arguments.has(option))
      throw UsageError(fmt::format("{} needs a controller that is listed state by state", option),
                       "heed synth --strategy explicit writes one, where it is not too large");
  return machine;
}

void print_evaluation(const Setting& setting, const std::string& controller, const job::ProfilePart& profile,
                      const job::Evaluation& found, const std::string& rare) {
  print(fmt::format("{} under {} ({})\n{}{}", controller, profile.spec.name, profile.title,
                    evaluation_text(found), rare));
  const sim::Lumps& lumps = found.figures.lumps;
  if (lumps.components > 0)
    print(fmt::format("  {} independent components in {} groups of exchangeable ones; {}\n", lumps.components,
                      lumps.groups, found.figures.exact ? "exact" : "rounded, each figure with its bound"));
  if (found.sampled.traces == 0 && setting.options.traces > 0)
    print("  not sampled: that takes the whole chain, which is too large\n");
  if (setting.options.width > 0)
    print(fmt::format("  {} traces; intervals hold with {}{}\n", found.sampled.traces,
                      setting.scenario.evaluate->confidence,
                      found.width_reached ? "" : "; --traces came before --width"));
}

/// One controller: text to standard output, or JSON to \p documents.
void simulate_controller(const Arguments& arguments, const Setting& setting, const AnyController& controller,
                         util::Budget& budget, Json& documents) {
  const model::Mealy* machine = listed(arguments, controller);
  const std::string name = std::visit([](const auto& any) { return any.name; }, controller);
  for (const job::ProfilePart* profile : chosen_profiles(arguments, setting.scenario)) {
    if (machine != nullptr) write_chain(arguments, setting, *profile, *machine, budget);
    const job::Evaluation found = std::visit(
        [&](const auto& any) {
          return job::evaluate(setting.scenario, setting.world, *profile, any, setting.thing, setting.options,
                               budget);
        },
        controller);
    const std::optional<Rare> rare =
        machine != nullptr ? find_rare(arguments, setting, *profile, *machine, found, budget) : std::nullopt;
    if (!arguments.json()) {
      print_evaluation(setting, name, *profile, found, rare ? rare_text(*rare) : "");
      continue;
    }
    Json one;
    one["controller"] = name;
    one["profile"] = profile->spec.name;
    one["traces"] = found.sampled.traces;
    one["outcomes"] = evaluation_json(found);
    one["reaction"] = reaction_json(found.figures);
    Json undefined;
    add_figure(found.figures.undefined, undefined);
    one["no_answer"] = undefined["exact"].is_null() ? undefined["value"] : undefined["exact"];
    if (found.figures.lumps.components > 0) one["lumps"] = lumps_json(found.figures.lumps);
    if (setting.options.width > 0) one["width_reached"] = found.width_reached;
    if (rare) one["rare"] = rare_json(*rare);
    documents.push_back(std::move(one));
  }
}

/// \throws UsageError  no number above 0 and below 1
double read_width(const Arguments& arguments) {
  if (!arguments.has("--width")) return 0;
  const std::string text = arguments.text("--width");
  double width = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), width);
  if (error != std::errc{} || rest != text.data() + text.size() || !(width > 0) || width >= 1)
    throw UsageError(fmt::format("--width: '{}' is no number between 0 and 1", text),
                     "such as --width 0.001");
  return width;
}

}  // namespace

int simulate_command(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  util::Budget budget(limits);
  const std::string chain = arguments.text("--chain");
  if (!chain.empty() && chain != "prism" && chain != "jani")
    throw UsageError(fmt::format("--chain must be prism or jani, not '{}'", chain),
                     util::suggestion(chain, {"prism", "jani"}));
  const job::Scenario scenario = load_scenario(arguments);
  if (!scenario.evaluate || scenario.profiles.empty())
    throw UsageError("the scenario has no [[profile]] and [evaluate]",
                     "they say what is seen and what counts");
  const job::World world = job::load_world(scenario, limits, budget);
  Setting setting{scenario, world, thing_on_road(arguments, scenario, world), {}};
  setting.options.width = read_width(arguments);
  const std::uint64_t usual = setting.options.width > 0 ? 1'000'000'000 : scenario.evaluate->traces;
  setting.options.traces = arguments.number("--traces", 0, 1'000'000'000'000).value_or(usual);
  setting.options.seed = arguments.number("--seed", 0, INT64_MAX).value_or(scenario.evaluate->seed);
  setting.options.threads = static_cast<unsigned>(arguments.number("--threads", 1, 256).value_or(1));
  setting.options.team = arguments.team();
  Json documents = Json::array();
  for (std::size_t i = 1; i < arguments.operands().size(); ++i) {
    const AnyController controller = read_controller(arguments.operands()[i], limits);
    simulate_controller(arguments, setting, controller, budget, documents);
  }
  // One document: none before all have come through.
  if (sim::Team* const team = arguments.team()) team->sum({});
  if (arguments.json()) {
    Json out;
    out["seed"] = setting.options.seed;
    out["results"] = std::move(documents);
    print_json(out);
  }
  return 0;
}

}  // namespace heed::cli
