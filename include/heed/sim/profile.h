#pragma once

#include <heed/sim/rational.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace heed::sim {

/// A cell given relative to the onsets of other features: `max(2, min(red, octagon) + 1)`. An onset is the
/// cell from which a feature is visible: 0 is the horizon, `never` is after every cell. `never + n` and
/// `never - n` are `never`; a value below 0 acts as 0, a value beyond the last cell as `never`.
class OnsetExpression {
 public:
  enum class Operation : std::uint8_t { Number, Feature, Never, Add, Min, Max };
  /// One operation of the postfix form. `number`: the number, the summand, or how many operands min and max
  /// take.
  struct Item {
    Operation operation = Operation::Number;
    std::int64_t number = 0;
    std::string name;
    util::Location location;
  };

  OnsetExpression() : OnsetExpression(0) {}
  OnsetExpression(std::int64_t cell)
      : items_{{Operation::Number, cell, {}, {}}} {}  // NOLINT: a number is an expression
  OnsetExpression(std::vector<Item> items, std::string text)
      : items_(std::move(items)), text_(std::move(text)) {}

  [[nodiscard]] const std::vector<Item>& items() const { return items_; }
  /// As it was written; empty for a number made in code.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Where it begins.
  [[nodiscard]] const util::Location& location() const { return location_; }
  void set_location(util::Location location) { location_ = std::move(location); }

 private:
  std::vector<Item> items_;
  std::string text_;
  util::Location location_;
};

/// Reads an onset expression (grammar: docs/formats/profile.md). Names are resolved by compile().
/// \throws util::InputError `bad-onset` with the position inside \p source; nesting is bounded by
/// `limits.nesting`.
[[nodiscard]] OnsetExpression parse_onset(const util::SourceText& source, const util::Limits& limits = {});

// The onset rules. T is the number of cells.

/// Visible from cell `at` on.
struct FixedOnset {
  OnsetExpression at;
};
/// Every number from ... to is equally likely; numbers of T and more all mean `never`, and a bound that is
/// `never` counts as T. `from` at T or later: never. \throws (by compile) `empty-range` when to < from can
/// happen.
struct UniformOnset {
  OnsetExpression from, to;
};
/// In each cell from `from` on, as long as it is not yet visible: with probability `p`.
struct GeometricOnset {
  Rational p;
  OnsetExpression from;
};
/// The probability to be visible in cell d is start + (end - start) * d / (T - 1): one uniform draw for the
/// whole trace. `never` gets 1 - end. With one cell, `end` counts. \pre 0 <= start <= end <= 1
struct LinearOnset {
  Rational start, end;
};
/// The onset is from + i with probability p[i]; `never` with probability `never`. All together must be 1
/// exactly.
struct TableOnset {
  std::vector<Rational> p;
  Rational never = 0;
  OnsetExpression from;
};
/// The onset is dealt by the one ShuffleSpec that names the feature.
struct ShuffledOnset {};

using Onset = std::variant<FixedOnset, UniformOnset, GeometricOnset, LinearOnset, TableOnset, ShuffledOnset>;

struct FeatureSpec {
  std::string name;
  Onset onset;
  /// The thing on the road does not have this feature: its onset is `never`, for itself and for all that
  /// depend on it.
  bool absent = false;
  /// The thing on the road has something else in this place, a disc where this is the octagon: the onset is
  /// drawn, for all that depend on it, but what is reported is as if it were absent.
  bool replaced = false;
  Rational detection = 1;        ///< Probability to be reported in a cell where it is visible.
  Rational false_detection = 0;  ///< Probability to be reported in a cell where it is not visible, or absent.
  /// The two rates in the last cell, where they change linearly with the distance; else they are the same
  /// everywhere. With one cell, these count.
  std::optional<Rational> detection_at_end{}, false_detection_at_end{};
  std::optional<bool> persistent{};  ///< Instead of the profile's.
  util::Location location{};
};

/// A random permutation: each feature gets one of the cells, all assignments equally likely. An absent
/// feature takes its cell, too, so that the others' onsets stay as they were. \pre as many cells as features
struct ShuffleSpec {
  std::vector<std::string> features;
  std::vector<OnsetExpression> at;
  util::Location location{};
};

/// One feature is reported in place of another: red is read as orange. It happens to what would rightly be
/// reported, and to nothing else. Of one feature and one kind (per cell, per approach) the probabilities add
/// up to 1 at most; with what is left it is read as what it is.
struct Misreading {
  std::string of, as;  ///< Features of the profile.
  Rational probability = 0;
  /// In the last cell, where the probability changes linearly with the distance; per cell only.
  std::optional<Rational> probability_at_end{};
  /// Decided once, for as long as the approach lasts; else in each cell anew. What is decided so comes first.
  bool per_approach = false;
  util::Location location{};
};

/// What perception reports while one thing is approached, cell by cell, as a scenario says it.
struct ProfileSpec {
  std::string name;
  std::uint32_t cells = 5;  ///< T; cell 0 is the horizon, cell T-1 the place of the thing.
  std::vector<FeatureSpec>
      features;  ///< In the order of the bits of Chain::Step::seen; rules may refer to any other.
  std::vector<ShuffleSpec> shuffles;
  /// In this cell everything that exists becomes visible.
  std::optional<std::uint32_t> everything_visible_in;
  /// A feature that was rightly reported once stays reported; otherwise each cell reports anew. Matters where
  /// detection < 1.
  bool persistent = true;
  util::Location location{};
  std::vector<Misreading> misreadings{};
};

/// The profile for a thing that lacks some features. \pre every name is one of the profile's features
[[nodiscard]] ProfileSpec without(ProfileSpec profile, const std::vector<std::string>& absent);

/// A finite Markov chain over what is reported per cell. State 0 is the start; every path has exactly `cells`
/// steps and ends in the one state without steps. Each state's probabilities add up to 1; a state's steps
/// differ in (seen, next) and are ascending in it. States with the same future are one.
struct Chain {
  struct Step {
    Rational probability;  ///< Never 0.
    std::uint32_t next = 0;
    std::uint64_t seen = 0;  ///< Bit i: feature i is reported in this cell.
  };
  std::string profile;
  std::vector<std::string> features;
  std::uint32_t cells = 0;
  std::vector<std::uint32_t> first;  ///< Steps of state s: steps[first[s]] ... steps[first[s+1]-1].
  std::vector<Step> steps;

  [[nodiscard]] std::uint32_t state_count() const {
    return first.empty() ? 0 : static_cast<std::uint32_t>(first.size() - 1);
  }
};

/// Most transitions of a chain, and most branches of one cell, that compile() unfolds before it gives up;
/// that takes some 300 MB.
inline constexpr std::size_t chain_step_limit = std::size_t{1} << 20;
inline constexpr std::size_t chain_branch_limit = std::size_t{1} << 18;

/// For callers that have another way where the chain is large.
struct ChainLimits {
  std::size_t steps = chain_step_limit, branches = chain_branch_limit;
};

/// Turns the profile into its chain. Within a cell a feature is drawn after those that its rule refers to, so
/// `from = "sign"` may be met in the very cell of the sign. Where a rule looks ahead (`at = "sign - 1"`),
/// what it refers to is drawn before the first cell and kept hidden in the state. Cost: states x branches per
/// cell; geometric and independent rules keep it small, since only onsets that a rule still needs are
/// remembered. \throws util::InputError `unknown-feature`, `duplicate-feature`, `too-many-features` (64),
/// `cyclic-onsets`, `misread-as-itself`,
///   `probability-range`, `probability-sum`, `empty-range`, `bad-shuffle`, `bad-cells`.
/// \throws util::LimitExceeded  Size: beyond the two limits above; or the budget's own limits.
[[nodiscard]] Chain compile(const ProfileSpec& profile, util::Budget& budget, const ChainLimits& limits = {});

}  // namespace heed::sim
