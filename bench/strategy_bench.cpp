// Strategies and certificates of specifications: CPU seconds of each stage, and how large the result is.
// Prints one figure a line, row, column and value separated by tabs. Usage: strategy_bench explicit|symbolic|
// verdict SPEC...
#include <fmt/format.h>
#include <heed/certify/certify.h>
#include <heed/check/verify.h>
#include <heed/spec/dialect.h>
#include <heed/strategy/synthesize.h>
#include <heed/util/file.h>

#include <exception>
#include <filesystem>
#include <string>

#include "watch.h"

namespace heed::bench {
namespace {

void measure(const std::string& form, const std::string& path) {
  const std::string row = std::filesystem::path(path).stem().string();
  const auto print = [&](const char* column, double value) {
    fmt::print("{}\t{}\t{:.6g}\n", row, column, value);
    std::fflush(stdout);
  };
  util::Budget budget;
  Watch watch;
  const spec::Gr1 spec = spec::read_any(util::read_file(path));
  print("read s", watch.lap());
  strategy::Options options;
  options.only_realizability = form == "verdict";
  options.claim = form == "verdict";
  options.form = form == "symbolic" ? strategy::Form::Symbolic : strategy::Form::Explicit;
  const strategy::Result result = strategy::synthesize(spec, budget, options);
  print("synthesis s", watch.lap());
  if (result.machine) {
    print("solve wall s", result.statistics.solve_seconds);
    print("extract wall s", result.statistics.extract_seconds);
    print("minimise wall s", result.statistics.minimise_seconds);
    print("extracted", static_cast<double>(result.statistics.states_before_minimisation));
    print("states", result.machine->state_count());
    print("rows", static_cast<double>(result.machine->transitions.size()));
    const check::Verdict verdict = check::verify(*result.machine, spec, budget);
    insist(verdict.verified, verdict.verified ? "" : verdict.refutations.front().message);
    print("check s", watch.lap());
  }
  if (result.symbolic) {
    print("nodes", static_cast<double>(result.symbolic->diagrams.nodes.size()));
    const certify::Verdict verdict = certify::certify(*result.symbolic, spec, budget);
    insist(verdict.certified, verdict.fault);
    print("certify s", watch.lap());
  }
  if (result.claim) {
    print("realizable", result.realizable ? 1 : 0);
    print("nodes", static_cast<double>(result.claim->diagrams.nodes.size()));
    const certify::Verdict verdict = certify::certify(*result.claim, spec, budget);
    insist(verdict.certified, verdict.fault);
    print("certify s", watch.lap());
    print("implications", static_cast<double>(verdict.checks));
  }
  print("peak MB", static_cast<double>(util::peak_resident_bytes()) / 1e6);
}

}  // namespace
}  // namespace heed::bench

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: strategy_bench explicit|symbolic|verdict SPEC...\n");
    return 2;
  }
  try {
    for (int i = 2; i < argc; ++i) heed::bench::measure(argv[1], argv[i]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
