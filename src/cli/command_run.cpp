#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/job/run.h>
#include <heed/job/version.h>
#include <heed/report/write.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace heed::cli {
namespace {

/// One line that overwrites itself, on a terminal only.
util::Progress progress_bar(bool wanted) {
  if (!wanted || isatty(2) == 0) return {};
  return [](std::string_view stage, double done) {
    constexpr int width = 24;
    const int filled = static_cast<int>(done * width);
    fmt::print(stderr, "\r\x1b[K[{:#<{}}{:<{}}] {}", "", filled, "", width - filled, stage);
  };
}

int exit_code(const report::RunResult& result) {
  const auto has = [&](report::Verdict verdict) {
    return std::any_of(result.controllers.begin(), result.controllers.end(),
                       [&](const report::Controller& c) { return c.verdict == verdict; });
  };
  if (has(report::Verdict::Refuted)) return 4;
  return has(report::Verdict::Unrealizable) ? 1 : 0;
}

}  // namespace

int run_command(const Arguments& arguments) {
  const job::Scenario scenario = load_scenario(arguments);
  util::Budget budget(arguments.limits());
  job::RunOptions options;
  options.output = arguments.text(
      "--output", "out/" + std::filesystem::path(arguments.operands().front()).stem().string());
  options.seed = arguments.number("--seed", 0, INT64_MAX);
  options.traces = arguments.number("--traces", 0, 1'000'000'000'000);
  // How to repeat the figures; folder and threads do not matter for them.
  options.command = "heed run " + arguments.operands().front();
  if (options.seed) options.command += fmt::format(" --seed {}", *options.seed);
  if (options.traces) options.command += fmt::format(" --traces {}", *options.traces);
  options.threads = static_cast<unsigned>(arguments.number("--threads", 1, 256).value_or(1));
  options.drive = arguments.has("--drive");
  if (options.drive) options.command += " --drive";
  options.progress = progress_bar(!arguments.json());
  const report::RunResult result = job::run(scenario, options, budget);
  if (options.progress) fmt::print(stderr, "\r\x1b[K");
  if (arguments.json()) {
    print(report::to_json(result));
  } else {
    report::TextOptions how;
    how.details = arguments.has("--details");
    print(report::to_text(result, how));
    const bool any = std::any_of(result.controllers.begin(), result.controllers.end(),
                                 [](const report::Controller& c) { return !c.file.empty(); });
    print(fmt::format("\nReport: {0}/report.html (and report.json); {1}: {0}/*.{2}\n", options.output,
                      any ? "controllers" : "specifications", any ? "controller.json" : "gr1"));
  }
  return exit_code(result);
}

int version_command(const Arguments& arguments) {
  if (arguments.json()) {
    Json out;
    out["name"] = "heed";
    out["version"] = job::version();
    print_json(out);
  } else {
    print(fmt::format("heed {}\n", job::version()));
  }
  return 0;
}

}  // namespace heed::cli
