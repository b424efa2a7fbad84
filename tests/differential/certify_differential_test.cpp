// Symbolic verification against the explicit one and against the explicit-state solver, on everything small.
#include "certify_support.h"
#include "game_random.h"
#include "game_reference.h"

#include <heed/certify/certify.h>
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

/// \param apart  Every assumption stays a diagram of its own.
strategy::Result solved(const spec::Gr1& spec, bool apart) {
  util::Budget budget;
  strategy::Options options;
  if (apart) options.legal_nodes = 0;
  options.form = strategy::Form::Symbolic;
  options.claim = true;
  return strategy::synthesize(spec, budget, options);
}

std::string fault_of(const model::Mealy& machine, const spec::Gr1& spec) {
  util::Budget budget;
  const check::Verdict verdict = check::verify(machine, spec, budget);
  return verdict.verified ? "" : verdict.refutations.front().message;
}

TEST(CertifyDifferential, EveryVerdictIsCertified) {
  std::uint64_t realizable = 0, unrealizable = 0, waiting = 0, rounds = 0;
  for (std::uint64_t seed = 0; seed < specifications() && !HasFatalFailure(); ++seed) {
    const spec::Gr1 spec = reference::random_spec(seed);
    const strategy::Result result = solved(spec, seed % 2 == 0);
    util::Budget budget;
    ASSERT_EQ(result.realizable, reference::realizable(reference::Rules(spec))) << "seed " << seed;
    ASSERT_TRUE(result.claim);
    EXPECT_EQ(result.claim->realizable, result.realizable);
    const certify::Verdict claim = certify::certify(*result.claim, spec, budget);
    EXPECT_TRUE(claim.certified) << "seed " << seed << ": " << claim.fault << "\n" << spec::write_gr1(spec);
    strategy::Options asked;
    asked.only_realizability = asked.claim = true;
    const certify::Verdict verdict =
        certify::certify(*strategy::synthesize(spec, budget, asked).claim, spec, budget);
    EXPECT_TRUE(verdict.certified) << "seed " << seed << ": " << verdict.fault << "\n"
                                   << spec::write_gr1(spec);
    ++(result.realizable ? realizable : unrealizable);
    rounds += result.claim->rounds.size() > 1 ? 1 : 0;
    if (!result.realizable) continue;
    ASSERT_TRUE(result.symbolic);
    waiting += result.relies_on_broken_justice ? 1 : 0;
    const certify::Verdict strategy = certify::certify(*result.symbolic, spec, budget);
    EXPECT_TRUE(strategy.certified) << "seed " << seed << ": " << strategy.fault << "\n"
                                    << spec::write_gr1(spec);
    const auto machine = reference::listed(*result.symbolic);
    ASSERT_TRUE(machine) << "seed " << seed;
    EXPECT_EQ(fault_of(*machine, spec), "") << "seed " << seed << "\n" << spec::write_gr1(spec);
    EXPECT_EQ(reference::fault(*machine, reference::Rules(spec)), "") << "seed " << seed;
  }
  std::cout << "realizable " << realizable << ", unrealizable " << unrealizable << ", waiting " << waiting
            << ", several rounds " << rounds << "\n";
  EXPECT_GT(realizable, specifications() / 5);
  EXPECT_GT(unrealizable, specifications() / 5);
  EXPECT_GT(waiting, specifications() / 200);
  EXPECT_GT(rounds, specifications() / 50);
}

// What the explicit check refuses, the symbolic one refuses: it never believes more. The other way round it
// may believe less, since it knows only the ranks that it was given.
TEST(CertifyDifferential, WhatCheckRefusesIsRefused) {
  std::uint64_t refused = 0, kept = 0, doubted = 0;
  for (std::uint64_t seed = 0; refused < specifications() && !HasFatalFailure(); ++seed) {
    const spec::Gr1 spec = reference::random_spec(seed % 2'000);
    const strategy::Result result = solved(spec, seed % 2 == 0);
    if (!result.symbolic) continue;
    for (std::uint64_t variant = 0; variant < 4; ++variant) {
      const model::SymbolicController wrong = reference::mutated(*result.symbolic, 4 * seed + variant);
      const auto machine = reference::listed(wrong);
      util::Budget budget;
      const certify::Verdict verdict = certify::certify(wrong, spec, budget);
      const std::string fault = machine ? fault_of(*machine, spec) : "not listed";
      const bool right = fault.empty();
      ASSERT_FALSE(!right && verdict.certified) << "seed " << seed << "." << variant << ": " << fault << "\n"
                                                << spec::write_gr1(spec);
      ++(!right ? refused : verdict.certified ? kept : doubted);
    }
  }
  std::cout << "refused by both " << refused << ", accepted by both " << kept << ", only by the explicit one "
            << doubted << "\n";
  EXPECT_GE(refused, 600U);
}

// A claim of the wrong verdict cannot be made good by any change of its sets, and most changes of a right one
// break it.
TEST(CertifyDifferential, ChangedClaimsAreNeverBelievedOfTheWrongVerdict) {
  std::uint64_t refused = 0, harmless = 0;
  for (std::uint64_t seed = 0; seed < specifications() && !HasFatalFailure(); ++seed) {
    const spec::Gr1 spec = reference::random_spec(seed);
    const strategy::Result result = solved(spec, seed % 2 == 0);
    util::Budget budget;
    const certify::Verdict verdict = certify::certify(reference::mutated(*result.claim, seed), spec, budget);
    ++(verdict.certified ? harmless : refused);
    // The claim about a neighbour that has the other verdict: nothing may save it.
    model::Claim other = *result.claim;
    other.realizable = !other.realizable;
    other.winning = model::function_true;
    other.ranks.assign(std::max<std::size_t>(1, spec.sys_justice.size()), {{model::function_true, {}}});
    EXPECT_FALSE(certify::certify(other, spec, budget).certified) << "seed " << seed;
  }
  std::cout << "refused " << refused << ", harmless " << harmless << "\n";
  EXPECT_GT(refused, specifications() / 3);
}

}  // namespace
}  // namespace heed
