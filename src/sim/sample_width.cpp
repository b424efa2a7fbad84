#include <heed/sim/sample.h>
#include <heed/sim/statistics.h>

#include <algorithm>
#include <cassert>

namespace heed::sim {
namespace {

double widest(const SampleOutcome& outcome, double confidence) {
  double width = 0;
  for (const std::uint64_t count : outcome.count) {
    const Interval interval = wilson(count, outcome.traces, confidence);
    width = std::max(width, interval.high - interval.low);
  }
  return width;
}

}  // namespace

WidthOutcome sample_to_width(const Sampler& sampler, const WidthOptions& wanted, SampleOptions options,
                             util::Budget& budget) {
  assert(wanted.width > 0 && wanted.most > 0);
  WidthOutcome result;
  std::uint64_t next = std::min<std::uint64_t>(4096, wanted.most);
  for (unsigned look = 1;; ++look) {
    options.traces = next;
    SampleOutcome part = sampler.sample(options, budget);
    options.first += next;
    result.outcome = look == 1 ? std::move(part) : sum(std::move(result.outcome), part);
    result.confidence = 1 - (1 - wanted.confidence) / (look * (look + 1.0));
    result.reached = widest(result.outcome, result.confidence) <= wanted.width;
    const std::uint64_t done = result.outcome.traces;
    if (result.reached || done >= wanted.most) return result;
    next = std::min(done, wanted.most - done);
  }
}

}  // namespace heed::sim
