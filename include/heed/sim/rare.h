#pragma once

#include <heed/sim/run.h>
#include <heed/sim/statistics.h>
#include <heed/sim/team.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <vector>

namespace heed::sim {

struct RareOptions {
  std::uint32_t category = 0;        ///< Of the judge: the outcome that hardly ever comes.
  std::uint32_t particles = 20'000;  ///< Runs that are kept alive at once.
  std::uint32_t replicates = 16;     ///< Independent repetitions, which give the error. At least 2.
  std::uint64_t seed = 1;
  double confidence = 0.95;
  Team* team = nullptr;  ///< Others that do their part of the repetitions; never changes a bit of the result.
};

struct RareEstimate {
  double probability = 0;     ///< Mean over the replicates; unbiased.
  double standard_error = 0;  ///< Of that mean.
  Interval interval;          ///< By Student's distribution over the replicates, cut to [0, 1].
  std::uint32_t extinct = 0;  ///< Replicates in which no run came through: each counts as 0.
  /// Per cell, the share of runs that could still get the category; mean over the replicates that got there.
  std::vector<double> survival;
};

/// Estimates the probability of an outcome too rare to be met by sampling: fixed-effort splitting over cells.
/// In each cell all runs move on by chance; those that got another category are dropped, and as many runs as
/// before go on from the survivors. The product of the shares that survive is an unbiased estimate, whose
/// relative error grows with the number of cells and not with 1 / probability. It helps where the outcome is
/// the end of many small misfortunes, such as a sign that is missed cell after cell; where a single draw
/// decides, it is no better than sampling, and `extinct` tells. Knows nothing of the exact result.
/// \cite glasserman.99.or
/// \returns the same for the same options, on any machine.  \throws util::LimitExceeded
[[nodiscard]] RareEstimate estimate_rare(const Run& run, const RareOptions& options, util::Budget& budget);

}  // namespace heed::sim
