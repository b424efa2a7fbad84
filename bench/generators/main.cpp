// Writes scenario, ontology and plant of the awareness controller at a chosen size, for `heed run`, `heed
// synth` and for peers. Usage: parts_scenario FOLDER PARTS CELLS [drop|latch|undefined]
#include "parts_scenario.h"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>

int main(int argc, char** argv) {
  heed::bench::PartsScenario wanted;
  if (argc >= 4) {
    wanted.parts = static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10));
    wanted.cells = static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10));
  }
  if (argc == 5) wanted.on_violation = argv[4];
  if (argc < 4 || argc > 5 || wanted.parts < 1 || wanted.cells < 2) {
    fmt::print(stderr,
               "usage: parts_scenario FOLDER PARTS CELLS [drop|latch|undefined]\n"
               "       PARTS from 1, CELLS from 2\n");
    return 2;
  }
  try {
    fmt::print("{}\n", heed::bench::write_scenario(wanted, argv[1]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
