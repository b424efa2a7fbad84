#pragma once

#include <heed/sim/rational.h>
#include <heed/sim/run.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace heed::sim {

/// A controller on a profile as one finite Markov chain: what exact_outcome() adds up on the way, kept for
/// other tools. State 0 stands after the blank observation. Every path ends, after at most `cells` steps, in
/// a state with an End and without steps; each other state's probabilities add up to 1, ascending in `next`.
struct Product {
  struct Step {
    Rational probability;  ///< Never 0.
    std::uint32_t next = 0;
  };
  /// How a run ended. Ends that say the same are one state.
  struct End {
    std::optional<std::uint32_t> category;  ///< Of the judge; nothing: no row before the run had one.
    bool missing = false;                   ///< A row was missing.
    bool fallback = false;                  ///< At least one row marked as fallback was taken.
    friend auto operator<=>(const End&, const End&) = default;
  };
  struct State {
    std::uint32_t cells = 0;    ///< Cells passed.
    std::uint32_t machine = 0;  ///< The controller's state; 0 in an end.
    std::optional<End> end;
  };
  std::string controller, profile;
  std::vector<std::string> categories;
  std::vector<State> states;
  std::vector<std::uint32_t> first;  ///< Steps of state s: steps[first[s]] ... steps[first[s+1]-1].
  std::vector<Step> steps;
};

/// Most states that product() lists.
inline constexpr std::size_t product_state_limit = std::size_t{1} << 22;

/// The reachable part of chain x machine, in breadth-first order. Cost: as exact_outcome().
/// \throws util::LimitExceeded  Size: beyond product_state_limit; or the budget's own limits.
[[nodiscard]] Product product(const Run& run, util::Budget& budget);

/// The chain in PRISM's language: a `dtmc` with one module, and a label for every outcome
/// (docs/formats/chain.md). \cite kwiatkowska.11.cav
[[nodiscard]] std::string write_prism(const Product& product);

/// The chain in JANI: an automaton with one location per state, and a property for every outcome.
/// \cite budde.17.tacas
[[nodiscard]] std::string write_jani(const Product& product);

}  // namespace heed::sim
