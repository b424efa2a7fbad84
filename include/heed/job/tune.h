#pragma once

#include <heed/job/controller.h>
#include <heed/job/scenario.h>
#include <heed/report/result.h>
#include <heed/sim/lumping.h>
#include <heed/util/limits.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace heed::job {

/// How one policy does under one profile at one level of noise.
struct TuneFigure {
  std::size_t policy = 0, profile = 0, noise = 0;  ///< Indices into Tuning and the scenario's profiles.
  sim::Figure miss;                                ///< P(the approached thing is missed).
  /// P(needless reaction) when everything of the catalogue that neither obliges to react nor excuses it, and
  /// nothing at all, are equally likely.
  sim::Figure needless;
  sim::Figure distance;  ///< Expected distance of the reaction to the approached thing, in cells.
  /// Of a machine that brakes on a road, in m/s^2: v^2 / (2 n cell) where it reacts n cells before the thing.
  /// The mean and the largest over the runs that react while there is a way left to brake on (n > 0); nothing
  /// where none does, or where the scenario has neither `cell_metres` nor `speed_kmh`.
  std::optional<sim::Figure> braking, hardest;
  /// No other policy is better in misses, needless reactions or distance and as good in the others. Braking
  /// follows from the distance run by run, and its mean over the runs that brake would reward who reacts late
  /// never: it does not decide.
  bool on_front = false;
};

/// A policy that is one of the scenario's controllers.
struct OwnPolicy {
  std::size_t policy = 0, controller = 0;  ///< Indices into Tuning::policies and Scenario::controllers.
};

/// A policy without figures, and why.
struct LeftOut {
  std::string policy, reason;
};

/// Policies side by side. All figures are exact where the analysis is.
struct Tuning {
  std::vector<std::string> policies;  ///< In words, such as "at least 2 of sign, red, octagon".
  std::vector<LeftOut> left_out;      ///< What the scenario does not allow, or no controller can do.
  std::vector<OwnPolicy> own;
  std::size_t things =
      0;  ///< How many things, nothing at all included, a needless reaction is the mean over.
  std::vector<sim::Rational> noise;
  std::vector<TuneFigure> figures;  ///< By profile, noise, then misses ascending.
  /// The policy with the least misses in its worst profile and noise, among those whose needless reactions
  /// stay within the bound in all of them; nothing where none does.
  std::optional<std::size_t> best;
};

struct TuneOptions {
  std::optional<sim::Rational> most_needless;  ///< The bound; none: every policy qualifies.
  /// At level e every feature of a profile is missed with probability e more often, and falsely reported with
  /// probability e where it would not be.
  std::vector<sim::Rational> noise{0};
  /// Only what a report has room and time for: read whole, definition, at least k, and trees of two levels,
  /// with full reading where something is read whole.
  bool simple = false;
};
/// What the scenario says in `[tune]`.
[[nodiscard]] TuneOptions tune_options(const Scenario& scenario);

/// Synthesizes, verifies and evaluates every policy for the approached thing of \p scenario: full,
/// definition, at least k of its features for every k, trees and trees with full reading in every order of
/// two features or more, and identifying in its three ways to act (with a complete catalogue where a
/// controller of the scenario that identifies has one). Its features are those that a controller of the
/// scenario names
/// (`over`), else those that perception reports of it; at most four. \throws util::InputError  also where no
/// policy is possible; util::LimitExceeded
[[nodiscard]] Tuning tune(const Scenario& scenario, const World& world, const TuneOptions& options,
                          util::Budget& budget);

/// The same as the report shows it.
[[nodiscard]] report::Tuning describe_tuning(const Scenario& scenario, const Tuning& tuning,
                                             const TuneOptions& options);

}  // namespace heed::job
