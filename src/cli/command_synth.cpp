#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/certify/certify.h>
#include <heed/check/verify.h>
#include <heed/game/techniques.h>
#include <heed/job/controller.h>
#include <heed/model/mealy.h>
#include <heed/model/symbolic.h>
#include <heed/spec/dialect.h>
#include <heed/strategy/synthesize.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace heed::cli {
namespace {

/// The file, or what one controller of a scenario is to keep, as `heed spec --gr1` prints it.
spec::Gr1 load_spec(const Arguments& arguments, util::Budget& budget) {
  const std::string& path = arguments.operands().front();
  const util::Limits limits = arguments.limits();
  if (!is_scenario(path)) {
    if (arguments.has("--controller"))
      throw UsageError("--controller: a specification has one only", "it is for scenarios (.toml)");
    return spec::read_any(util::read_file(path, limits), limits);
  }
  const job::Scenario scenario = load_scenario(arguments);
  const auto chosen = chosen_controllers(arguments, scenario);
  if (chosen.size() != 1) {
    std::vector<std::string> names;
    for (const job::ControllerPart* part : chosen) names.push_back(part->name.text);
    throw UsageError(fmt::format("{} has {} controllers", path, chosen.size()),
                     fmt::format("say which: --controller {}", fmt::join(names, "|")));
  }
  const job::World world = job::load_world(scenario, limits, budget);
  return job::design(scenario, world, *chosen.front()).composed.spec;
}

strategy::Form form(const Arguments& arguments) {
  const std::string word = arguments.text("--strategy", "auto");
  if (word == "auto") return strategy::Form::Auto;
  if (word == "explicit") return strategy::Form::Explicit;
  if (word == "symbolic") return strategy::Form::Symbolic;
  throw UsageError(fmt::format("--strategy: unknown word '{}'", word),
                   util::suggestion(word, {"explicit", "symbolic", "auto"}));
}

/// "NAME=VALUE" as often as given, the last one counts.
game::Techniques techniques(const Arguments& arguments) {
  game::Techniques result;
  for (const std::string& word : arguments.texts("--solver-option")) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    if (equals == std::string::npos)
      throw UsageError(fmt::format("--solver-option: '{}' is no NAME=VALUE", word),
                       "such as frontier-sets=off");
    try {
      game::set_technique(result, name, word.substr(equals + 1));
    } catch (const std::invalid_argument& error) {
      const auto names = game::technique_names();
      const bool known = std::find(names.begin(), names.end(), name) != names.end();
      throw UsageError(fmt::format("--solver-option: {}", error.what()),
                       known ? std::string() : util::suggestion(name, names));
    }
  }
  return result;
}

strategy::Options synthesis_options(const Arguments& arguments) {
  strategy::Options options;
  options.techniques = techniques(arguments);
  options.only_realizability = arguments.has("--realizability");
  const std::string word = arguments.text("--on-violation", "undefined");
  if (word == "latch")
    options.on_violation = strategy::OnViolation::Latch;
  else if (word != "undefined")
    throw UsageError(fmt::format("--on-violation: unknown word '{}'", word), "undefined or latch");
  options.claim = arguments.has("--certify");
  options.form = form(arguments);
  options.auto_states = arguments.number("--max-states", 1, 1'000'000'000).value_or(options.auto_states);
  options.auto_rows = 20 * options.auto_states;
  options.auto_steps = 100 * options.auto_states;
  if (options.form == strategy::Form::Explicit)
    options.max_states = std::max(options.max_states, options.auto_states);
  if (options.form == strategy::Form::Symbolic && word == "latch")
    throw UsageError(
        "--on-violation latch lists an answer to every observation, and a symbolic strategy lists nothing",
        "leave out one of the two");
  return options;
}

int verdict_code(const Arguments& arguments, bool yes) {
  const std::string style = arguments.text("--exit-code", "heed");
  if (style == "syntcomp") return yes ? 10 : 20;
  if (style != "heed")
    throw UsageError(fmt::format("--exit-code: unknown style '{}'", style), "heed or syntcomp");
  return yes ? 0 : 1;
}

Json synthesis_json(const strategy::Result& result) {
  Json out;
  out["verdict"] = result.realizable ? "REALIZABLE" : "UNREALIZABLE";
  if (result.machine || result.symbolic) {
    out["strategy"] = result.machine ? "explicit" : "symbolic";
    if (result.machine) {
      out["states"] = result.machine->state_count();
      out["transitions"] = result.machine->transitions.size();
    } else {
      out["nodes"] = result.symbolic->diagrams.nodes.size();
    }
    out["relies_on_broken_justice"] = result.relies_on_broken_justice;
  }
  if (result.counter) {
    out["losing_initial"] = result.counter->losing_initial;
    out["moves"] = result.counter->moves;
    out["reasons"] = result.counter->reasons;
  }
  return out;
}

void print_counter(const strategy::CounterPlay& counter) {
  fmt::print(stderr, "The environment wins from: {}\n", counter.losing_initial);
  for (const std::string& move : counter.moves) fmt::print(stderr, "  {}\n", move);
  if (!counter.reasons.empty()) fmt::print(stderr, "These cannot be kept together:\n");
  for (const std::string& reason : counter.reasons) fmt::print(stderr, "  {}\n", reason);
}

/// No strategy leaves without its check. \throws std::logic_error  what the solver made is refused
void insist_on_verified(const strategy::Result& result, const spec::Gr1& spec, util::Budget& budget) {
  std::string fault;
  if (result.machine) {
    const check::Verdict verdict = check::verify(*result.machine, spec, budget);
    if (!verdict.verified) fault = verdict.refutations.front().message;
  } else if (result.symbolic) {
    fault = certify::certify(*result.symbolic, spec, budget).fault;
  }
  if (!fault.empty())
    throw std::logic_error("the independent check refuses the synthesized controller: " + fault);
}

/// The verdict's own certificate, where it was asked for. \throws std::logic_error  it is refused
certify::Verdict certificate(const strategy::Result& result, const spec::Gr1& spec, util::Budget& budget) {
  if (!result.claim) return {};
  certify::Verdict verdict = certify::certify(*result.claim, spec, budget);
  if (!verdict.certified)
    throw std::logic_error(fmt::format("the certificate of the verdict '{}' is refused: {}",
                                       result.realizable ? "realizable" : "unrealizable", verdict.fault));
  return verdict;
}

/// "480 states, 1920 transitions", or of what the functions consist.
std::string size_text(const strategy::Result& result) {
  if (result.machine)
    return fmt::format("explicit strategy: {} states, {} transitions", result.machine->state_count(),
                       result.machine->transitions.size());
  return fmt::format("symbolic strategy: {} goals, {} nodes", result.symbolic->goals.size(),
                     result.symbolic->diagrams.nodes.size());
}

std::string document(const strategy::Result& result) {
  if (result.machine) return model::write_mealy(*result.machine);
  return result.symbolic ? model::write_symbolic(*result.symbolic) : std::string();
}

void report_json(const strategy::Result& result, const certify::Verdict& certified, const std::string& file) {
  Json out = synthesis_json(result);
  if (result.claim) out["certificate"] = {{"verdict", "VERIFIED"}, {"implications", certified.checks}};
  const std::string controller = document(result);
  if (!controller.empty() && file != "-")
    out["file"] = file;
  else if (!controller.empty())
    out["controller"] = Json::parse(controller);
  print_json(out);
}

void report_text(const strategy::Result& result, const certify::Verdict& certified, const std::string& file) {
  const bool strategy = result.machine || result.symbolic;
  const std::string note =
      result.claim ? fmt::format("certified: {} implications hold\n", certified.checks) : std::string();
  if (strategy && file == "-") {
    print(document(result));
    fmt::print(stderr, "{}", note);
    return;
  }
  print((result.realizable ? "REALIZABLE\n" : "UNREALIZABLE\n") + note);
  if (strategy) print(fmt::format("{}, verified; written to {}\n", size_text(result), file));
  if (result.counter) print_counter(*result.counter);
}

}  // namespace

int synth_command(const Arguments& arguments) {
  util::Budget budget(arguments.limits());
  (void)verdict_code(arguments, true);  // a wrong style is said before the work
  const strategy::Options options = synthesis_options(arguments);
  const spec::Gr1 spec = load_spec(arguments, budget);
  const strategy::Result result = strategy::synthesize(spec, budget, options);
  insist_on_verified(result, spec, budget);
  const certify::Verdict certified = certificate(result, spec, budget);
  const std::string target = arguments.text("--output", "-");
  if ((result.machine || result.symbolic) && target != "-") util::write_file(target, document(result));
  (arguments.json() ? report_json : report_text)(result, certified, target);
  return verdict_code(arguments, result.realizable);
}

}  // namespace heed::cli
