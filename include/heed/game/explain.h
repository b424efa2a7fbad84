#pragma once

#include <heed/game/solve.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace heed::game {

/// Values of variables by name, as they are printed, in the specification's order.
using Values = std::vector<std::pair<std::string, std::string>>;

/// One step of a play that the environment wins.
struct Turn {
  Values observation;  ///< What the environment gives.
  Values memory;       ///< Where the play stands then: the plant's state and what is remembered.
  Values answer;       ///< The system's; empty where it has none, in the last turn only.
};

/// Why the environment wins, in the specification's names.
struct Defeat {
  std::string
      losing_initial;  ///< A first observation that cannot be answered for good: "sign = false, red = true".
  std::vector<std::string>
      moves;  ///< The environment's first moves and the system's best answers, as sentences.
  std::vector<std::string>
      reasons;              ///< Clauses of the system that cannot be kept together; empty if not found.
  std::vector<Turn> turns;  ///< The play behind `moves`.
  std::vector<spec::Clause> broken;  ///< What no answer in the last turn keeps; empty where that is a goal.
  std::optional<spec::Clause> goal;  ///< What can be kept from happening again after the last turn.
};

struct ExplainOptions {
  std::size_t most_moves = 12;
  /// Bound on the predecessors computed for the core, as a multiple of what solving took, and at least this
  /// many.
  std::uint64_t core_factor = 40;
  std::uint64_t core_steps = 4000;
};

/// Explains an unrealizable game: a losing first observation, a play in which the system always takes the
/// answer that survives longest, and a set of clauses that cannot be kept together and of which none can be
/// left out (as far as the bound on work allows). \pre !region.realizable, region.iterates were kept \throws
/// util::LimitExceeded
[[nodiscard]] Defeat explain(const Game& game, const Region& region, util::Budget& budget,
                             const ExplainOptions& options = {});

/// Indices of parts that contradict each other, none superfluous. \pre their conjunction is false
[[nodiscard]] std::vector<std::size_t> minimal_conflict(const std::vector<bdd::Bdd>& parts);

}  // namespace heed::game
