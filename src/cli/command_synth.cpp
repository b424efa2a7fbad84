#include "commands.h"
#include "output.h"

#include <heed/check/verify.h>
#include <heed/model/mealy.h>
#include <heed/spec/dialect.h>
#include <heed/strategy/synthesize.h>
#include <heed/util/file.h>

#include <fmt/format.h>

namespace heed::cli {
namespace {

spec::Gr1 load_spec(const std::string& path, const util::Limits& limits) {
  return spec::read_any(util::read_file(path, limits), limits);
}

strategy::Options synthesis_options(const Arguments& arguments) {
  strategy::Options options;
  options.only_realizability = arguments.has("--realizability");
  const std::string word = arguments.text("--on-violation", "undefined");
  if (word == "latch")
    options.on_violation = strategy::OnViolation::Latch;
  else if (word != "undefined")
    throw UsageError(fmt::format("--on-violation: unknown word '{}'", word), "undefined or latch");
  return options;
}

int verdict_code(const Arguments& arguments, bool yes) {
  const std::string style = arguments.text("--exit-code", "heed");
  if (style == "syntcomp") return yes ? 10 : 20;
  if (style != "heed")
    throw UsageError(fmt::format("--exit-code: unknown style '{}'", style), "heed or syntcomp");
  return yes ? 0 : 1;
}

Json trace_json(const check::Refutation& refutation, const model::Mealy& machine) {
  Json steps = Json::array();
  for (const check::TraceStep& step : refutation.trace) {
    Json one;
    for (std::size_t i = 0; i < step.input.size(); ++i)
      one["input"][machine.inputs[i].name] = machine.inputs[i].domain.print(step.input[i]);
    for (std::size_t i = 0; i < step.output.size(); ++i)
      one["output"][machine.outputs[i].variable.name] =
          machine.outputs[i].variable.domain.print(step.output[i]);
    steps.push_back(std::move(one));
  }
  return steps;
}

std::string trace_text(const check::Refutation& refutation, const model::Mealy& machine) {
  std::string out;
  for (std::size_t t = 0; t < refutation.trace.size(); ++t) {
    const check::TraceStep& step = refutation.trace[t];
    if (refutation.kind == check::Refutation::Kind::Justice && t == refutation.loop_start)
      out += "  for ever:\n";
    out += fmt::format("  step {}:", t);
    for (std::size_t i = 0; i < step.input.size(); ++i)
      out += fmt::format(" {}={}", machine.inputs[i].name, machine.inputs[i].domain.print(step.input[i]));
    out += step.output.empty() ? " -> no answer" : " ->";
    for (std::size_t i = 0; i < step.output.size(); ++i)
      out += fmt::format(" {}={}", machine.outputs[i].variable.name,
                         machine.outputs[i].variable.domain.print(step.output[i]));
    out += '\n';
  }
  return out;
}

int report_verdict(const Arguments& arguments, const check::Verdict& verdict, const model::Mealy& machine) {
  if (arguments.json()) {
    Json out;
    out["verdict"] = verdict.verified ? "VERIFIED" : "REFUTED";
    out["product_states"] = verdict.product_states;
    out["product_edges"] = verdict.product_edges;
    out["relies_on_broken_justice"] = verdict.relies_on_broken_justice;
    out["refutations"] = Json::array();
    for (const check::Refutation& refutation : verdict.refutations) {
      Json one;
      one["message"] = refutation.message;
      one["clause"] = refutation.clause;
      one["trace"] = trace_json(refutation, machine);
      one["loop_start"] = refutation.loop_start;
      out["refutations"].push_back(std::move(one));
    }
    print_json(out);
    return verdict.verified ? 0 : 1;
  }
  print(fmt::format("{}\n", verdict.verified ? "VERIFIED" : "REFUTED"));
  print(
      fmt::format("{} states and {} edges of the product\n", verdict.product_states, verdict.product_edges));
  if (verdict.relies_on_broken_justice)
    print("It relies somewhere on an assumption that the environment does not meet.\n");
  for (const check::Refutation& refutation : verdict.refutations)
    print(
        fmt::format("{}\n  {}\n{}", refutation.message, refutation.clause, trace_text(refutation, machine)));
  return verdict.verified ? 0 : 1;
}

Json synthesis_json(const strategy::Result& result) {
  Json out;
  out["verdict"] = result.realizable ? "REALIZABLE" : "UNREALIZABLE";
  if (result.machine) {
    out["states"] = result.machine->state_count();
    out["transitions"] = result.machine->transitions.size();
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

/// No machine leaves without its check. \throws std::logic_error  the check refuses what the solver made
void insist_on_verified(const model::Mealy& machine, const spec::Gr1& spec, util::Budget& budget) {
  const check::Verdict verdict = check::verify(machine, spec, budget);
  if (!verdict.verified)
    throw std::logic_error("the independent check refuses the synthesized controller: " +
                           verdict.refutations.front().message);
}

}  // namespace

int synth_command(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  util::Budget budget(limits);
  (void)verdict_code(arguments, true);  // a wrong style is said before the work
  const spec::Gr1 spec = load_spec(arguments.operands().front(), limits);
  const strategy::Result result = strategy::synthesize(spec, budget, synthesis_options(arguments));
  if (result.machine) insist_on_verified(*result.machine, spec, budget);
  const std::string target = arguments.text("--output", "-");
  const bool to_file = result.machine && target != "-";
  if (to_file) util::write_file(target, model::write_mealy(*result.machine));
  if (arguments.json()) {
    Json out = synthesis_json(result);
    if (to_file)
      out["file"] = target;
    else if (result.machine)
      out["controller"] = Json::parse(model::write_mealy(*result.machine));
    print_json(out);
  } else if (result.machine && !to_file) {
    print(model::write_mealy(*result.machine));
  } else {
    print(result.realizable ? "REALIZABLE\n" : "UNREALIZABLE\n");
    if (to_file)
      print(fmt::format("{} states, {} transitions, verified; written to {}\n", result.machine->state_count(),
                        result.machine->transitions.size(), target));
  }
  if (!arguments.json() && result.counter) print_counter(*result.counter);
  return verdict_code(arguments, result.realizable);
}

int verify_command(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  util::Budget budget(limits);
  const model::Mealy machine = model::read_mealy(util::read_file(arguments.operands()[0], limits), limits);
  const spec::Gr1 spec = load_spec(arguments.operands()[1], limits);
  check::Options options;
  options.most = arguments.number("--most", 1, 1000).value_or(1);
  return report_verdict(arguments, check::verify(machine, spec, budget, options), machine);
}

}  // namespace heed::cli
