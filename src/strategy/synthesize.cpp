#include <heed/strategy/synthesize.h>

#include "extract.h"

#include <heed/game/explain.h>
#include <heed/game/solve.h>

#include <chrono>

namespace heed::strategy {
namespace {

/// Seconds since it was made or last read; for the statistics only.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

game::SolveOptions solve_options(const Options& options) {
  game::SolveOptions result;
  result.ranks = !options.only_realizability;
  result.iterates = !options.only_realizability;
  result.stop_early = options.only_realizability;
  return result;
}

}  // namespace

Result synthesize(const spec::Gr1& spec, util::Budget& budget, const Options& options) {
  Stopwatch watch;
  Result result;
  const game::Game game = game::build_game(spec, budget);
  const game::Region region = game::solve(game, budget, solve_options(options));
  result.realizable = region.realizable;
  Statistics& statistics = result.statistics;
  statistics.solve_seconds = watch.lap();
  statistics.outer_iterations = region.outer_iterations;
  statistics.state_bits = game.manager->variable_count() / 2;
  if (!options.only_realizability && region.realizable) {
    Extracted extracted = extract(game, region, budget, options);
    statistics.extract_seconds = watch.lap();
    statistics.states_before_minimisation = extracted.machine.state_count();
    result.relies_on_broken_justice = extracted.relies_on_broken_justice;
    result.machine = model::minimise(extracted.machine);
    statistics.minimise_seconds = watch.lap();
  } else if (!options.only_realizability) {
    result.counter = game::explain(game, region, budget);
  }
  statistics.bdd_nodes_peak = game.manager->statistics().peak_nodes;
  return result;
}

}  // namespace heed::strategy
