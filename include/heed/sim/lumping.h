#pragma once

#include <heed/model/symbolic.h>
#include <heed/sim/rational.h>
#include <heed/sim/run.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace heed::sim {

/// A figure of the exact analysis: the true value lies within `error` of `value`; where it is known, it is
/// `exact`.
struct Figure {
  std::optional<Rational> exact;
  double value = 0;
  double error = 0;
};

/// A figure that is known. `error` covers the rounding of `value`.
[[nodiscard]] Figure known(Rational value);
/// Their errors add up; exact where both are.
[[nodiscard]] Figure operator+(const Figure& a, const Figure& b);
/// 1 - a
[[nodiscard]] Figure complement(const Figure& a);
[[nodiscard]] Figure scaled(const Figure& a, unsigned factor);
/// \pre b is surely above 0
[[nodiscard]] Figure ratio(const Figure& a, const Figure& b);

/// How an analysis went: what was lumped, and how much was left.
struct Lumps {
  std::uint32_t components = 0;     ///< Independent parts of the profile that the machine tells apart.
  std::uint32_t groups = 0;         ///< Of components that are exchangeable.
  std::uint32_t largest_group = 0;  ///< Components in it.
  std::uint64_t machine_states = 0;
  std::uint64_t widest_layer = 0;  ///< Most states after one cell.
  std::uint64_t steps = 0;         ///< Products that were added up.
};

/// As ExactOutcome.
struct LumpedOutcome {
  std::vector<Figure> probability;
  Figure undefined, missing, fallback;
  std::vector<Figure> event_at;
  bool exact = false;  ///< All figures are exact.
  Lumps lumps;
};

/// How the steps of a machine that is not listed are judged.
struct SymbolicJudge {
  std::vector<std::string> categories;
  std::uint32_t never = 0;
  /// Inputs that the event depends on; the others may be given blank.
  std::vector<std::uint32_t> reads;
  /// The category of a step with these inputs and these columns (outputs, memories, definitions), or
  /// Judge::none.
  std::function<std::uint32_t(const model::Valuation& inputs, const model::Valuation& columns)> event;
};

/// How far away the thing still is when the machine reacts, in cells: an event in the last cell counts 0, one
/// in the cell before 1.
struct ReactionDistance {
  Figure mean;                           ///< Over all runs: 0 for those without an event.
  Figure reacts;                         ///< P(there is an event).
  std::optional<Figure> when_it_reacts;  ///< Over the runs with an event; nothing where there are none.
};
[[nodiscard]] ReactionDistance reaction_distance(const LumpedOutcome& outcome);

struct LumpOptions {
  /// Words of arithmetic that exact fractions may cost; above it doubles with a bound.
  double exact_work = 2e7;
  /// Most states of one layer, half-way ones included.
  std::uint64_t most_states = std::uint64_t{1} << 20;
};

/// The outcome distribution of \p machine on \p profile, without ever making their whole chain. The profile
/// falls into independent components; what the machine does not tell apart is one; components with the same
/// chain that the machine treats alike are counted instead of named, so that 30 of them make 31 states and
/// not 2^30. Whether it treats them alike is decided on the decision diagrams of its answers, for every
/// state.
///
/// With doubles the error is bounded rigorously: all terms are positive, so a sum of products that took r
/// roundings is within ((1 + u)^r - 1) of its true value, relatively, u = 2^-53; r is counted along the way.
/// \cite higham.02.siam
/// \throws util::LimitExceeded  Size: what does not lump is too large.
[[nodiscard]] LumpedOutcome lumped_outcome(const ProfileSpec& profile, const model::Mealy& machine,
                                           const Binding& binding, const Judge& judge,
                                           const LumpOptions& options, util::Budget& budget);
[[nodiscard]] LumpedOutcome lumped_outcome(const ProfileSpec& profile,
                                           const model::SymbolicController& machine, const Binding& binding,
                                           const SymbolicJudge& judge, const LumpOptions& options,
                                           util::Budget& budget);

}  // namespace heed::sim
