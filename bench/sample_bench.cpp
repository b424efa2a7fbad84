// The case study's nine charts: compiling a profile, the exact distribution, and traces per second on one
// core.
#include <benchmark/benchmark.h>
#include <heed/sim/exact.h>
#include <heed/sim/sample.h>

#include "unit/sim/case_study.h"

namespace heed::sim {
namespace {

const std::vector<case_study::Chart>& charts() {
  static const std::vector<case_study::Chart> all = case_study::charts();
  return all;
}

void compile_profiles(benchmark::State& state) {
  for (auto _ : state) {
    util::Budget budget;
    for (const ProfileSpec& profile : {case_study::p1(), case_study::p2(), case_study::p3()})
      benchmark::DoNotOptimize(compile(profile, budget));
  }
}
BENCHMARK(compile_profiles)->Unit(benchmark::kMicrosecond);

void exact_nine_charts(benchmark::State& state) {
  for (auto _ : state) {
    util::Budget budget;
    for (const case_study::Chart& chart : charts())
      benchmark::DoNotOptimize(exact_outcome(chart.run(), budget));
  }
}
BENCHMARK(exact_nine_charts)->Unit(benchmark::kMicrosecond);

void sample_chart(benchmark::State& state) {
  const case_study::Chart& chart = charts()[static_cast<std::size_t>(state.range(0))];
  util::Budget budget;
  const Sampler sampler(chart.run(), budget);
  SampleOptions options;
  options.traces = 1 << 20;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sampler.sample(options, budget));
    ++options.seed;
  }
  state.SetLabel(chart.name);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(options.traces));
}
BENCHMARK(sample_chart)->DenseRange(0, 8)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace heed::sim

BENCHMARK_MAIN();
