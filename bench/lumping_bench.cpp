// Many independent features over many cells, with misses, false detections and flicker: the awareness
// controller by functions, and its exact outcome distribution. CPU time of synthesis and of the analysis.
// Prints one figure a line, row, column and value separated by tabs. Usage: lumping_bench [PARTS CELLS
// flicker|latched]; without arguments the sizes of RESULTS.md. With `latched` what was rightly reported stays
// reported.
#include <fmt/format.h>
#include <heed/job/controller.h>
#include <heed/job/evaluate.h>
#include <heed/util/file.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "generators/parts_scenario.h"
#include "watch.h"

namespace heed::bench {
namespace {

struct Size {
  unsigned parts, cells;
  bool flicker = true;
};

/// Every part is seen from a cell on that is drawn by itself, is missed in one cell of ten there, and falsely
/// reported in one of ten thousand before.
std::string evaluation_text(const Size& size) {
  std::string out = fmt::format(
      "\n[[profile]]\nname = \"noisy\"\ncells = {}\npersistent = {}\nonsets = [\n"
      "  {{ feature = \"sign\", linear = [0, 1], detection = \"9/10\", false_detection = \"1/10000\" }},\n",
      size.cells, !size.flicker);
  for (unsigned i = 1; i <= size.parts; ++i)
    out += fmt::format(
        "  {{ feature = \"part_{}\", geometric = \"1/{}\", detection = \"9/10\", "
        "false_detection = \"1/10000\" }},\n",
        i, 10 * size.cells);
  out += "]\n\n[evaluate]\nevent = \"X stopping\"\napproached = \"StopSign\"\noutcomes = [\n";
  for (unsigned location = 1; location < size.cells; ++location)
    out += fmt::format("  {{ label = \"stop in {0}\", when = \"location = {0}\" }},\n", location);
  return out + "  { label = \"infeasible\" },\n]\n";
}

model::SymbolicController synthesize(const job::Design& design, util::Budget& budget) {
  const auto free = job::without_perception_assumptions(design.composed.spec);
  insist(free.has_value(), "nothing to drop");
  strategy::Options options;
  options.form = strategy::Form::Symbolic;
  strategy::Result result = strategy::synthesize(*free, budget, options);
  insist(result.symbolic.has_value(), "unrealizable");
  return *std::move(result.symbolic);
}

void measure(const Size& size) {
  const std::string folder = fmt::format(
      "{}/heed-lumping-{}-{}", std::filesystem::temp_directory_path().string(), size.parts, size.cells);
  const std::string path = write_scenario({size.parts, size.cells, "drop"}, folder);
  util::write_file(path, std::string(util::read_file(path).text()) + evaluation_text(size));
  util::Budget budget;
  Watch watch;
  const job::Scenario scenario = job::read_scenario(util::read_file(path));
  const job::World world = job::load_world(scenario, budget.limits(), budget);
  const job::Design design = job::design(scenario, world, scenario.controllers.front());
  const model::SymbolicController controller = synthesize(design, budget);
  const double synthesis = watch.lap();
  const std::size_t before = util::peak_resident_bytes();
  const job::Evaluation found = job::evaluate(scenario, world, scenario.profiles.front(), controller,
                                              world.knowledge.catalogue.entity("StopSign"), {}, budget);
  const double analysis = watch.lap();
  const std::string row = fmt::format("{} features, {} cells, {}", size.parts + 1, size.cells,
                                      size.flicker ? "flicker" : "latched");
  const auto print = [&](const char* column, double value) {
    fmt::print("{}\t{}\t{:.6g}\n", row, column, value);
  };
  print("synthesis s", synthesis);
  print("analysis s", analysis);
  print("peak MB", static_cast<double>(util::peak_resident_bytes()) / 1e6);
  print("before MB", static_cast<double>(before) / 1e6);
  print("components", found.figures.lumps.components);
  print("groups", found.figures.lumps.groups);
  print("widest layer", static_cast<double>(found.figures.lumps.widest_layer));
  print("million steps", static_cast<double>(found.figures.lumps.steps) / 1e6);
  print("infeasible", found.figures.probability.back().value);
  print("error", found.figures.probability.back().error);
  std::fflush(stdout);
  std::filesystem::remove_all(folder);
}

void sizes() {
  for (const unsigned parts : {5U, 10U, 20U, 30U}) measure({parts, 200});
  measure({30, 200, false});
}

}  // namespace
}  // namespace heed::bench

int main(int argc, char** argv) {
  try {
    if (argc == 4)
      heed::bench::measure({static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10)),
                            static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)),
                            std::string(argv[3]) == "flicker"});
    else
      heed::bench::sizes();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
