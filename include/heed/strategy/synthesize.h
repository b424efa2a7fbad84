#pragma once

#include <heed/game/explain.h>
#include <heed/model/mealy.h>
#include <heed/model/symbolic.h>
#include <heed/spec/gr1.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace heed::strategy {

/// What to do when the environment breaks an assumption at run time.
enum class OnViolation : std::uint8_t {
  Undefined,  ///< The machine has no row for such an observation.
  Latch  ///< The row of the nearest legal observation: with what was seen before, else what was seen before,
         ///< else the first legal one; marked as fallback.
};

/// How a strategy is written down.
enum class Form : std::uint8_t {
  Explicit,  ///< As a Mealy machine, state by state.
  Symbolic,  ///< As functions.
  Auto       ///< Explicit where `auto_states`, `auto_rows` and `auto_steps` suffice, else symbolic.
};

struct Options {
  bool only_realizability = false;
  bool claim = false;  ///< Also say why the verdict is right, so that certify can see to it.
  Form form = Form::Explicit;
  std::uint64_t auto_states = 100'000, auto_rows = 2'000'000;  ///< Before minimisation.
  std::uint64_t auto_steps = 10'000'000;  ///< Of diagrams: few states may hide in long functions.
  OnViolation on_violation = OnViolation::Undefined;
  std::uint64_t max_states = 10'000'000;  ///< Before minimisation. More: util::LimitExceeded (Size).
  std::uint64_t max_rows = 0;             ///< The same for rows; 0: no bound.
  std::uint64_t max_steps = 0;            ///< The same for bdd::Statistics::steps of the listing.
  std::size_t legal_nodes = 2000;         ///< Up to so many, what is legal is one diagram, else several.
  game::Techniques techniques{};          ///< How the game is solved; the result is the same.
};

struct Statistics {
  double solve_seconds = 0, extract_seconds = 0, minimise_seconds = 0;
  std::uint64_t bdd_nodes_peak = 0, state_bits = 0;
  std::uint64_t states_before_minimisation = 0;
  std::uint64_t outer_iterations = 0;
};

/// Why the environment wins: a losing first step, and how it goes on (as far as there is a choice to show).
using CounterPlay = game::Defeat;

struct Result {
  bool realizable = false;
  std::optional<model::Mealy> machine;                ///< Realizable and asked for: this one,
  std::optional<model::SymbolicController> symbolic;  ///< or this one.
  std::optional<model::Claim> claim;                  ///< Asked for.
  std::optional<CounterPlay> counter;                 ///< Unrealizable.
  bool relies_on_broken_justice = false;  ///< The strategy somewhere waits for an assumption to fail.
  Statistics statistics;
};

/// Solves the game of \p spec and extracts a minimised Mealy machine, or a symbolic controller. A symbolic
/// one has no rows for illegal observations: OnViolation::Latch is explicit. \throws util::LimitExceeded,
/// util::InputError
[[nodiscard]] Result synthesize(const spec::Gr1& spec, util::Budget& budget, const Options& options = {});

}  // namespace heed::strategy
