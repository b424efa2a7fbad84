#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/job/play.h>
#include <heed/report/play.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <filesystem>

namespace heed::cli {
namespace {

void write_page(const std::string& path, const report::Play& play) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failed;  // write_file() says what is wrong with the folder
  if (!folder.empty()) std::filesystem::create_directories(folder, failed);
  util::write_file(path, report::to_html(play));
}

}  // namespace

int play_command(const Arguments& arguments) {
  const bool page_wanted = !arguments.json() || arguments.has("--output");
  if (page_wanted && !report::has_play_page())
    throw util::InputError(
        util::Location{}, "no-page", "this program was built without the page of heed play",
        "install Node and its packages with `scripts/setup test`, then configure and build again; "
        "--json prints the page's data without it");
  const job::Scenario scenario = load_scenario(arguments);
  util::Budget budget(arguments.limits());
  job::PlayOptions options;
  if (const auto seed = arguments.number("--seed", 0, UINT32_MAX))
    options.seed = static_cast<std::uint32_t>(*seed);
  const job::PlayResult made = job::play(scenario, options, budget);
  print_diagnostics(made.warnings);
  if (arguments.json()) print(report::to_json(made.play) + "\n");
  if (made.play.controllers.empty()) return 1;
  if (!page_wanted) return 0;
  const std::string stem = std::filesystem::path(arguments.operands().front()).stem().string();
  const std::string path = arguments.text("--output", "out/" + stem + "/play.html");
  write_page(path, made.play);
  if (!arguments.json())
    print(fmt::format("Page: {} with {} controllers; open it in a browser\n", path,
                      made.play.controllers.size()));
  return 0;
}

}  // namespace heed::cli
