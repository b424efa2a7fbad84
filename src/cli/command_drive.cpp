#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/job/drive.h>
#include <heed/report/drive.h>

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

namespace heed::cli {
namespace {

/// As a command line that repeats the figures.
std::string repeated(const Arguments& arguments) {
  std::string command = "heed drive " + arguments.operands().front();
  for (const char* option : {"--controller", "--profile", "--thing", "--roads", "--seed"})
    for (const std::string& value : arguments.texts(option)) command += fmt::format(" {} {}", option, value);
  return command;
}

job::DriveOptions read_options(const Arguments& arguments) {
  job::DriveOptions options;
  options.output = arguments.text(
      "--output", "out/" + std::filesystem::path(arguments.operands().front()).stem().string());
  options.command = repeated(arguments);
  options.controllers = arguments.texts("--controller");
  options.profiles = arguments.texts("--profile");
  if (arguments.has("--thing")) options.thing = arguments.text("--thing");
  options.seed = arguments.number("--seed", 0, INT64_MAX);
  if (const auto roads = arguments.number("--roads", 1, 100'000))
    options.roads = static_cast<std::uint32_t>(*roads);
  if (!arguments.json() && isatty(2) != 0)
    options.progress = [](std::string_view stage, double done) {
      fmt::print(stderr, "\r\x1b[K{:3.0f} % {}", 100 * done, stage);
    };
  return options;
}

}  // namespace

int drive_command(const Arguments& arguments) {
  const job::DriveOptions options = read_options(arguments);
  const job::Scenario scenario = load_scenario(arguments);
  util::Budget budget(arguments.limits());
  const job::Driven driven = job::drive(scenario, options, budget);
  if (options.progress) fmt::print(stderr, "\r\x1b[K");
  print_diagnostics(driven.warnings);
  if (driven.result.runs.empty()) return 1;
  if (arguments.json()) {
    print(report::to_json(driven.result));
    return 0;
  }
  print(report::to_text(driven.result));
  print(
      fmt::format("\nRoads: {0}/drive.csv, in short {0}/drive-summary.csv, drive.json; pictures: "
                  "{0}/drive-metres.svg, drive-braking.svg, drive-speed.svg\n",
                  options.output));
  return 0;
}

}  // namespace heed::cli
