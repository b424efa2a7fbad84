// What a step costs: a machine of the case study's size (96 states, 16 observations) by observation and by
// letter, a large one beyond the caches, one whose rows are searched, and a whole line of the protocol.

#include <heed/export/exec.h>
#include <heed/export/runner.h>
#include <heed/util/random.h>

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace {

using heed::exporter::LineExecutor;
using heed::exporter::Runner;
using namespace heed::model;

Mealy machine(std::uint32_t states, std::size_t bits) {
  heed::util::CounterRandom random(1, 0);
  std::vector<Variable> inputs;
  for (std::size_t i = 0; i < bits; ++i)
    inputs.push_back({"feature_" + std::to_string(i), Domain::boolean(), {}, {}});
  MealyBuilder builder(
      "bench", inputs,
      {{{"action", Domain::enumeration({"go", "slow_down", "hard_stop"}), {}, {}}, OutputRole::Action},
       {{"location", Domain::integer(0, 4), {}, {}}, OutputRole::Plant},
       {{"recognised_stop", Domain::boolean(), "Stop sign: octagon & red", {}}, OutputRole::Recognised},
       {{"prescribed_halt", Domain::boolean(), "Halt: prescribed by Stop sign", {}},
        OutputRole::Prescribed}});
  const auto value = [&](std::uint32_t below) { return static_cast<std::int32_t>(random.below(below)); };
  for (std::uint32_t s = 0; s < states; ++s) builder.add_state();
  for (std::uint32_t s = 0; s < states; ++s)
    for (std::uint32_t letter = 0; letter < 1U << bits; ++letter) {
      Valuation input;
      for (std::size_t i = 0; i < bits; ++i) input.push_back(static_cast<std::int32_t>(letter >> i & 1));
      builder.add(s, input, {value(3), value(5), value(2), value(2)}, random.below(states));
    }
  return builder.finish();
}

/// A thousand observations drawn beforehand.
std::vector<Valuation> observations(const Mealy& m) {
  heed::util::CounterRandom random(2, 0);
  std::vector<Valuation> drawn;
  for (int i = 0; i < 1024; ++i)
    drawn.push_back(m.input_letters[random.below(static_cast<std::uint32_t>(m.input_letters.size()))]);
  return drawn;
}

void step_by_observation(benchmark::State& state, std::uint32_t states, std::size_t bits, std::size_t bytes) {
  Runner runner(machine(states, bits), bytes);
  const std::vector<Valuation> drawn = observations(runner.machine());
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(runner.step(drawn[i++ % 1024]));
}

void step_by_letter(benchmark::State& state) {
  Runner runner(machine(96, 4));
  std::vector<std::uint32_t> letters;
  for (const Valuation& observation : observations(runner.machine()))
    letters.push_back(*runner.letter(observation));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(runner.step_letter(letters[i++ % 1024]));
}

void line(benchmark::State& state) {
  LineExecutor executor(machine(96, 4));
  const std::string lines[] = {
      R"({"feature_0": true, "feature_1": true, "feature_2": false, "feature_3": true})",
      R"({"feature_3": true, "feature_2": true})", "{}"};
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(executor.line(lines[i++ % 3]));
}

BENCHMARK_CAPTURE(step_by_observation, case_study, 96, 4, std::size_t{64} << 20);
BENCHMARK_CAPTURE(step_by_observation, large, 20000, 6, std::size_t{64} << 20);
BENCHMARK_CAPTURE(step_by_observation, searched, 96, 4, 0);
BENCHMARK(step_by_letter);
BENCHMARK(line);

}  // namespace

BENCHMARK_MAIN();
