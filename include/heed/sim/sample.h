#pragma once

#include <heed/sim/run.h>
#include <heed/sim/team.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace heed::sim {

struct SampleOptions {
  std::uint64_t traces = 10'000;
  std::uint64_t seed = 1;
  std::uint64_t first =
      0;                 ///< Index of the first trace: ranges put together are one run, on whatever machines.
  unsigned threads = 1;  ///< 0 = as many as the hardware has. Never changes a count.
  Team* team = nullptr;  ///< Others that draw their part of the traces; never changes a count, either.
};

/// Counts over the traces; `count` and `undefined` add up to `traces`. Meanings as in ExactOutcome.
struct SampleOutcome {
  std::vector<std::uint64_t> count;
  std::uint64_t undefined = 0, missing = 0, fallback = 0;
  std::uint64_t traces = 0;
  friend bool operator==(const SampleOutcome&, const SampleOutcome&) = default;
};

/// The outcome of two ranges of traces together. \pre the same categories
[[nodiscard]] SampleOutcome sum(SampleOutcome a, const SampleOutcome& b);

/// Draws traces cell by cell from the chain and steps the machine through each. Trace i of a seed is a pure
/// function of (seed, i). Its words are those of util::CounterRandom(seed, i): of the n cells in which any
/// state leaves a choice, the j-th uses word j, and word n + j as 32 further bits where those of word j do
/// not decide. Each step's probability is met to within 2^-64. Knows nothing of the exact result.
class Sampler {
 public:
  /// Builds dense tables, [chain state][random] and [machine state][letter]. \throws util::LimitExceeded
  /// Memory, when the tables do not fit the budget.
  Sampler(const Run& run, util::Budget& budget);
  ~Sampler();
  Sampler(Sampler&&) noexcept;
  Sampler& operator=(Sampler&&) noexcept;

  /// \throws util::LimitExceeded  Time or cancellation; what SampleOptions::team throws.
  [[nodiscard]] SampleOutcome sample(const SampleOptions& options, util::Budget& budget) const;
  /// What trace \p index reports, per cell (bits as in Chain::Step::seen): the same trace that sample()
  /// counts.
  [[nodiscard]] std::vector<std::uint64_t> trace(std::uint64_t seed, std::uint64_t index) const;

 private:
  struct Tables;
  [[nodiscard]] SampleOutcome draw(const SampleOptions& options, util::Budget& budget) const;
  std::unique_ptr<const Tables> tables_;
};

struct WidthOptions {
  double width = 0.01;  ///< Of the widest interval over the categories; above 0.
  double confidence = 0.95;
  std::uint64_t most = std::uint64_t{1} << 40;  ///< Traces.
};
struct WidthOutcome {
  SampleOutcome outcome;
  double confidence = 0;  ///< At which to take the intervals of this outcome.
  bool reached = false;   ///< False: `most` came first.
};

/// Samples until every category's Wilson interval is at most `width` wide, looking after 4096, 8192, 16384,
/// ... traces. Looking often finds something by luck: look k is taken at confidence 1 - (1 - c) / (k (k +
/// 1)), so that all looks together hold with c. \param options  `traces` is not used. \throws
/// util::LimitExceeded
[[nodiscard]] WidthOutcome sample_to_width(const Sampler& sampler, const WidthOptions& wanted,
                                           SampleOptions options, util::Budget& budget);

}  // namespace heed::sim
