// The awareness controller as parts and cells grow: CPU time of composing, of synthesis with its explicit
// machine (solved, extracted, minimised) and of verification, each apart, and the states of the machine.
// Prints one figure a line, row, column and value separated by tabs. Usage: scaling_bench [PARTS CELLS
// ON_VIOLATION [symbolic]]; without arguments the sweeps of RESULTS.md. With `symbolic` the strategy is one
// of functions, certified together with the verdict.
#include <fmt/format.h>
#include <heed/certify/certify.h>
#include <heed/job/controller.h>
#include <heed/util/file.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>

#include "generators/parts_scenario.h"
#include "watch.h"

namespace heed::bench {
namespace {

/// As `heed run` would: without the assumptions on perception where they may be dropped.
spec::Gr1 played(const job::Design& design, job::Violation on_violation) {
  if (on_violation == job::Violation::Drop)
    if (auto free = job::without_perception_assumptions(design.composed.spec)) return *std::move(free);
  return design.composed.spec;
}

using Print = std::function<void(const char*, double)>;

void measure_explicit(const spec::Gr1& spec, job::Violation on_violation, util::Budget& budget,
                      const Print& print) {
  Watch watch;
  strategy::Options options;
  if (on_violation == job::Violation::Latch) options.on_violation = strategy::OnViolation::Latch;
  const strategy::Result result = strategy::synthesize(spec, budget, options);
  print("synthesis s", watch.lap());
  insist(result.machine.has_value(), "unrealizable");
  const check::Verdict verdict = check::verify(*result.machine, spec, budget);
  print("verify s", watch.lap());
  insist(verdict.verified, "refuted");
  print("extracted", static_cast<double>(result.statistics.states_before_minimisation));
  print("states", result.machine->state_count());
  print("rows", static_cast<double>(result.machine->transitions.size()));
}

void measure_symbolic(const spec::Gr1& spec, util::Budget& budget, const Print& print) {
  Watch watch;
  strategy::Options options;
  options.form = strategy::Form::Symbolic;
  options.claim = true;
  const strategy::Result result = strategy::synthesize(spec, budget, options);
  print("symbolic s", watch.lap());
  insist(result.symbolic.has_value(), "unrealizable");
  const certify::Verdict strategy = certify::certify(*result.symbolic, spec, budget);
  print("certify s", watch.lap());
  insist(strategy.certified, strategy.fault);
  const certify::Verdict claim = certify::certify(*result.claim, spec, budget);
  print("verdict s", watch.lap());
  insist(claim.certified, claim.fault);
  print("nodes", static_cast<double>(result.symbolic->diagrams.nodes.size()));
}

void measure(const PartsScenario& wanted, bool symbolic = false) {
  const std::string folder =
      fmt::format("{}/heed-scaling-{}-{}-{}", std::filesystem::temp_directory_path().string(), wanted.parts,
                  wanted.cells, wanted.on_violation);
  const std::string path = write_scenario(wanted, folder);
  util::Budget budget;
  Watch watch;
  const job::Scenario scenario = job::read_scenario(util::read_file(path));
  const job::World world = job::load_world(scenario, budget.limits(), budget);
  const double load = watch.lap();
  const job::Design design = job::design(scenario, world, scenario.controllers.front());
  const spec::Gr1 spec = played(design, scenario.perception.on_violation);
  const double compose = watch.lap();
  const std::string row =
      fmt::format("{} parts, {} cells, {}", wanted.parts, wanted.cells, wanted.on_violation);
  const auto print = [&](const char* column, double value) {
    fmt::print("{}\t{}\t{:.6g}\n", row, column, value);
    std::fflush(stdout);
  };
  print("load s", load);
  print("compose s", compose);
  if (symbolic)
    measure_symbolic(spec, budget, print);
  else
    measure_explicit(spec, scenario.perception.on_violation, budget, print);
  std::filesystem::remove_all(folder);
}

void sweep() {
  for (unsigned parts = 2; parts <= 11; ++parts) measure({parts, 5, "drop"});
  for (const unsigned cells : {10U, 20U, 50U, 100U, 200U}) measure({2, cells, "drop"});
  for (unsigned parts = 2; parts <= 11; ++parts) measure({parts, 5, "undefined"});
  for (const unsigned cells : {10U, 20U, 50U, 100U, 200U}) measure({2, cells, "undefined"});
  for (unsigned parts = 2; parts <= 8; ++parts) measure({parts, 5, "latch"});
  for (const char* on_violation : {"drop", "undefined"}) {
    for (const unsigned parts : {5U, 10U, 20U, 30U}) measure({parts, 5, on_violation}, true);
    for (const unsigned cells : {100U, 1'000U, 10'000U}) measure({2, cells, on_violation}, true);
  }
}

}  // namespace
}  // namespace heed::bench

int main(int argc, char** argv) {
  using heed::bench::measure;
  try {
    if (argc == 4 || argc == 5)
      measure({static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10)),
               static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)), argv[3]},
              argc == 5);
    else
      heed::bench::sweep();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
