#include "game_random.h"
#include "game_reference.h"

#include <heed/check/verify.h>
#include <heed/spec/text.h>
#include <heed/strategy/synthesize.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace heed {
namespace {

std::uint64_t specifications() {
  const char* slow = std::getenv("HEED_SLOW");
  return slow != nullptr && std::string(slow) == "1" ? 10'000 : 1'000;
}

struct Counts {
  std::uint64_t realizable = 0, unrealizable = 0, waiting = 0, cores = 0;
};

/// Latched, every state answers every observation, unless the environment cannot move there or the system
/// chooses how the play begins, and keeps what it kept.
void compare_latched(std::uint64_t seed, const spec::Gr1& spec, const reference::Rules& rules) {
  util::Budget budget;
  strategy::Options latch;
  latch.on_violation = strategy::OnViolation::Latch;
  const model::Mealy machine = *strategy::synthesize(spec, budget, latch).machine;
  for (std::uint32_t state = 0; state < machine.state_count(); ++state) {
    const std::size_t rows = machine.first[state + 1] - machine.first[state];
    const bool chosen = state == 0 && spec.initial == spec::InitialQuantifiers::ExistsExists;
    EXPECT_TRUE(rows == 0 || rows == rules.inputs().size() || chosen)
        << "seed " << seed << " state " << state;
  }
  EXPECT_EQ(reference::fault(machine, rules), "") << "latched, seed " << seed;
  EXPECT_TRUE(check::verify(machine, spec, budget).verified) << "latched, seed " << seed;
}

/// Some of the solver's techniques switched, others with every seed.
game::Techniques some_techniques(std::uint64_t seed) {
  game::Techniques result;
  std::uint64_t bits = seed * 0x9e3779b97f4a7c15ULL >> 32;
  for (const std::string& name : game::technique_names()) {
    if (name == "cluster-nodes")
      set_technique(result, name, bits % 2 == 0 ? "0" : "30");
    else
      set_technique(result, name, bits % 2 == 0 ? "on" : "off");
    bits /= 2;
  }
  return result;
}

void compare(std::uint64_t seed, Counts& counts) {
  const spec::Gr1 spec = reference::random_spec(seed);
  const reference::Rules rules(spec);
  util::Budget budget;
  const strategy::Result result = strategy::synthesize(spec, budget);
  ASSERT_EQ(result.realizable, reference::realizable(rules)) << "seed " << seed << "\n"
                                                             << spec::write_gr1(spec);
  strategy::Options asked;
  asked.only_realizability = true;
  asked.techniques = some_techniques(seed);
  EXPECT_EQ(strategy::synthesize(spec, budget, asked).realizable, result.realizable) << "seed " << seed;
  ++(result.realizable ? counts.realizable : counts.unrealizable);
  if (!result.realizable) {
    ASSERT_TRUE(result.counter) << "seed " << seed;
    counts.cores += result.counter->reasons.empty() ? 0 : 1;
    return;
  }
  ASSERT_TRUE(result.machine) << "seed " << seed;
  counts.waiting += result.relies_on_broken_justice ? 1 : 0;
  const check::Verdict verdict = check::verify(*result.machine, spec, budget);
  EXPECT_TRUE(verdict.verified) << "seed " << seed << ": "
                                << (verdict.refutations.empty() ? "" : verdict.refutations.front().message)
                                << "\n"
                                << spec::write_gr1(spec);
  EXPECT_EQ(reference::fault(*result.machine, rules), "") << "seed " << seed << "\n" << spec::write_gr1(spec);
  if (seed % 4 == 0) compare_latched(seed, spec, rules);
  // What is legal is the same in one diagram and in several, and so is the machine.
  if (seed % 4 != 1) return;
  strategy::Options apart;
  apart.legal_nodes = 0;
  EXPECT_EQ(*strategy::synthesize(spec, budget, apart).machine, *result.machine) << "seed " << seed;
}

TEST(GameDifferential, VerdictsAndMachinesAgreeWithTheExplicitReference) {
  Counts counts;
  for (std::uint64_t seed = 0; seed < specifications() && !HasFatalFailure(); ++seed) compare(seed, counts);
  std::cout << "realizable " << counts.realizable << ", unrealizable " << counts.unrealizable << ", waiting "
            << counts.waiting << ", with core " << counts.cores << "\n";
  EXPECT_GT(counts.realizable, specifications() / 5);
  EXPECT_GT(counts.unrealizable, specifications() / 5);
  EXPECT_GT(counts.waiting, specifications() / 200);
}

}  // namespace
}  // namespace heed
