#pragma once

#include <heed/sim/rational.h>
#include <heed/sim/run.h>
#include <heed/util/limits.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace heed::sim {

/// One kind of thing that a road may hold, as perception reports it; `nothing there` is one, too.
struct Passage {
  const Chain* chain;
  const Binding* binding;
};

/// A machine that drives past one thing after another. After one blank observation the approaches follow each
/// other without a pause; the machine keeps its state, each approach is judged by itself. All that is
/// referred to must outlive the analysis.
struct RoadRun {
  const model::Mealy& machine;
  std::vector<Passage> kinds;
  const Judge& judge;
  std::vector<bool> conflict;  ///< Per transition: what is seen contradicts itself; empty: never.
};

/// What stands at one place of a road: the probability of each kind. \pre they add up to 1
using Draw = std::vector<Rational>;

struct RoadOutcome {
  /// By kind and category: how many approaches of that kind are expected to end so.
  std::vector<std::vector<Rational>> expected;
  Rational conflicts = 0;  ///< How many approaches are expected to see a conflict.
  Rational conflict = 0;   ///< P(some approach of the road sees one); not in the long run.
  Rational missing = 0;    ///< P(the machine has no answer at some time: the drive ends there).
};

/// Exact expectations over roads, by linearity: what is remembered between two things is the machine's state
/// and whether there was a conflict.
class RoadAnalysis {
 public:
  /// \pre as for Run, for every kind; the first kind's blank observation comes before the first approach
  RoadAnalysis(RoadRun run, util::Budget& budget) : run_(std::move(run)), budget_(budget) {}

  /// One road: one draw for each of its places. Cost: places x machine states between things x what one
  /// approach costs, once. \throws util::LimitExceeded
  [[nodiscard]] RoadOutcome over(const std::vector<Draw>& places);

  /// The mean over a whole cycle of \p places when they come again and again for ever: the limit of the
  /// averages, which exists for every finite chain, from the machine's start. Solved exactly: transient
  /// states are censored, each recurrent class gets its stationary distribution without a subtraction.
  /// \cite grassmann.85.or
  /// \returns nothing where more than \p most states of the machine lie between two cycles.
  [[nodiscard]] std::optional<RoadOutcome> in_the_long_run(const std::vector<Draw>& places,
                                                           std::size_t most = 200);

 private:
  /// How one approach may end.
  struct End {
    std::uint32_t next = 0;  ///< State of the machine.
    std::optional<std::uint32_t> category;
    bool missing = false, conflict = false;
    Rational probability;
  };
  /// Machine state and whether there was a conflict.
  using Standing = std::map<std::pair<std::uint32_t, bool>, Rational>;

  [[nodiscard]] std::optional<std::uint32_t> start() const;
  [[nodiscard]] const std::vector<End>& approach(std::uint32_t state, std::size_t kind);
  [[nodiscard]] std::vector<End> drive(std::uint32_t state, const Passage& passage);
  [[nodiscard]] RoadOutcome none() const;
  Standing pass(const Standing& before, const Draw& draw, RoadOutcome& outcome);

  RoadRun run_;
  util::Budget& budget_;
  std::map<std::pair<std::uint32_t, std::size_t>, std::vector<End>> approaches_;
};

}  // namespace heed::sim
