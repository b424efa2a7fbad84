#include "commands.h"
#include "output.h"

#include <heed/certify/certify.h>
#include <heed/check/verify.h>
#include <heed/model/mealy.h>
#include <heed/model/symbolic.h>
#include <heed/spec/dialect.h>
#include <heed/util/file.h>

#include <fmt/format.h>

namespace heed::cli {
namespace {

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

int report_verdict(const Arguments& arguments, const certify::Verdict& verdict) {
  if (arguments.json()) {
    Json out;
    out["verdict"] = verdict.certified ? "VERIFIED" : "REFUTED";
    out["implications"] = verdict.checks;
    out["refutations"] = Json::array();
    if (!verdict.certified) out["refutations"].push_back({{"message", verdict.fault}});
    print_json(out);
  } else {
    print(verdict.certified ? "VERIFIED\n" : "REFUTED\n");
    print(fmt::format("by its ranks; {} implications\n", verdict.checks));
    if (!verdict.certified) print(verdict.fault + '\n');
  }
  return verdict.certified ? 0 : 1;
}

}  // namespace

int verify_command(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  util::Budget budget(limits);
  const util::SourceText source = util::read_file(arguments.operands()[0], limits);
  const auto specification = [&] {
    return spec::read_any(util::read_file(arguments.operands()[1], limits), limits);
  };
  check::Options options;
  options.most = arguments.number("--most", 1, 1000).value_or(1);
  if (model::is_symbolic(source)) {
    const model::SymbolicController controller = model::read_symbolic(source, limits);
    return report_verdict(arguments, certify::certify(controller, specification(), budget));
  }
  const model::Mealy machine = model::read_mealy(source, limits);
  return report_verdict(arguments, check::verify(machine, specification(), budget, options), machine);
}

}  // namespace heed::cli
