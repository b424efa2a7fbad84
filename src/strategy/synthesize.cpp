#include <heed/strategy/synthesize.h>

#include "claims.h"
#include "extract.h"
#include "rules.h"
#include "symbolic.h"

#include <heed/game/explain.h>
#include <heed/game/solve.h>

#include <algorithm>
#include <chrono>
#include <optional>

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
  result.ranks = options.claim || !options.only_realizability;
  result.iterates = options.claim || !options.only_realizability;
  result.stop_early = options.only_realizability;
  result.techniques = options.techniques;
  return result;
}

/// The machine, state by state. Nothing when Form::Auto finds it too large.
std::optional<Extracted> list_machine(const game::Game& game, const game::Region& region,
                                      util::Budget& budget, Options options) {
  if (options.form == Form::Symbolic && options.on_violation == OnViolation::Undefined) return std::nullopt;
  const bool may_fail = options.form == Form::Auto && options.on_violation == OnViolation::Undefined;
  if (may_fail) {
    options.max_states = std::min(options.max_states, options.auto_states);
    options.max_rows = options.auto_rows;
    options.max_steps = options.auto_steps;
  }
  try {
    return extract(game, region, budget, options);
  } catch (const util::LimitExceeded& limit) {
    if (!may_fail || limit.kind() != util::LimitExceeded::Kind::Size) throw;
    return std::nullopt;
  }
}

void add_strategy(const game::Game& game, const game::Region& region, util::Budget& budget,
                  const Options& options, Result& result) {
  Stopwatch watch;
  Statistics& statistics = result.statistics;
  if (const std::optional<Extracted> extracted = list_machine(game, region, budget, options)) {
    statistics.extract_seconds = watch.lap();
    statistics.states_before_minimisation = extracted->machine.state_count();
    result.relies_on_broken_justice = extracted->relies_on_broken_justice;
    result.machine = model::minimise(extracted->machine);
    statistics.minimise_seconds = watch.lap();
    return;
  }
  result.symbolic = make_symbolic(game, region, budget);
  result.relies_on_broken_justice = !result.symbolic->notes.empty();
  statistics.extract_seconds = watch.lap();
}

}  // namespace

Result synthesize(const spec::Gr1& spec, util::Budget& budget, const Options& options) {
  Stopwatch watch;
  Result result;
  // Only strategies and counter-strategies speak of inputs that nobody reads.
  const game::Techniques& techniques = options.techniques;
  const bool whole = !options.only_realizability || !techniques.partition_environment;
  game::Game game = game::build_game(spec, budget, {whole, techniques});
  const game::Region region = game::solve(game, budget, solve_options(options));
  result.realizable = region.realizable;
  Statistics& statistics = result.statistics;
  statistics.solve_seconds = watch.lap();
  statistics.outer_iterations = region.outer_iterations;
  statistics.state_bits = game.manager->variable_count() / 2;
  if (options.claim) result.claim = make_claim(game, region, budget);
  if (!options.only_realizability) gather_assumptions(game, options.legal_nodes);
  if (!options.only_realizability && region.realizable)
    add_strategy(game, region, budget, options, result);
  else if (!options.only_realizability)
    result.counter = game::explain(game, region, budget);
  statistics.bdd_nodes_peak = game.manager->statistics().peak_nodes;
  return result;
}

}  // namespace heed::strategy
