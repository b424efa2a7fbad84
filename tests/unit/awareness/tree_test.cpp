// The tree's memory, step by step, and the claim that awareness subsumes it.
#include "fixture.h"

#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using test::SmallWorld;
using Values = std::map<std::string, bool>;
using Trace = std::vector<Values>;
using Kind = PolicyOptions::Kind;

const std::vector<std::string> parts{"sign", "red", "octagon"};

/// All sequences of observations of \p length.
std::vector<Trace> traces(std::size_t length) {
  std::vector<Trace> result{{}};
  const auto observations = test::all_assignments(parts);
  for (std::size_t step = 0; step < length; ++step) {
    std::vector<Trace> longer;
    for (const Trace& trace : result)
      for (const Values& seen : observations) {
        longer.push_back(trace);
        longer.back().push_back(seen);
      }
    result = std::move(longer);
  }
  return result;
}

/// Per step, whether the stop sign is recognised.
std::vector<bool> run(const Recognition& recognition, const Trace& trace) {
  std::vector<bool> result;
  Values levels;
  for (const Values& seen : trace) {
    Values now = seen;
    now.insert(levels.begin(), levels.end());
    now = test::react(recognition, now);
    result.push_back(now["recognised_stop"]);
    levels = test::advance(recognition, now);
  }
  return result;
}

Recognition tree(const std::vector<Name>& order, bool latch) {
  const SmallWorld world;
  PolicyOptions options;
  options.kind = Kind::Tree;
  options.order = order;
  options.latch = latch;
  options.entities = {"stop"};
  return compile_policy(world.catalogue, world.perception(), options);
}

/// Level n at time t, by the definition, from all of the past.
bool level(const Trace& trace, std::size_t t, std::size_t n, bool latch) {
  const bool seen = trace[t].at(parts[n - 1]);
  const bool before = n == 1 || (t > 0 && level(trace, t - 1, n - 1, latch));
  if (seen && before) return true;
  return latch && t > 0 && level(trace, t - 1, n, latch);
}

TEST(Tree, OneLevelPerStepInItsOrder) {
  for (const bool latch : {false, true})
    for (std::size_t depth = 1; depth <= 3; ++depth) {
      const std::vector<Name> order(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(depth));
      const Recognition recognition = tree(order, latch);
      EXPECT_EQ(recognition.memories.size(), latch ? depth : depth - 1);
      for (const Trace& trace : traces(4)) {
        const auto detected = run(recognition, trace);
        for (std::size_t t = 0; t < trace.size(); ++t)
          ASSERT_EQ(detected[t], level(trace, t, depth, latch))
              << "step " << t << " depth " << depth << " latch " << latch;
      }
    }
}

TEST(Tree, SeenTogetherIsNotOneAfterTheOther) {
  const Recognition recognition = tree({"sign", "red"}, false);
  const Values both{{"sign", true}, {"red", true}};
  EXPECT_EQ(run(recognition, {both}), (std::vector<bool>{false}));
  EXPECT_EQ(run(recognition, {both, both}), (std::vector<bool>{false, true}));
  EXPECT_EQ(run(recognition, {{{"sign", true}}, {}, {{"red", true}}}),
            (std::vector<bool>{false, false, false}));
  EXPECT_EQ(run(tree({"sign", "red"}, true), {{{"sign", true}}, {}, {{"red", true}}}),
            (std::vector<bool>{false, false, true}));
}

TEST(Tree, ResetForgetsWhatWasReached) {
  const SmallWorld world;
  PolicyOptions options;
  options.kind = Kind::Tree;
  options.order = {"sign", "red"};
  options.latch = true;
  options.entities = {"stop"};
  options.reset = logic::name("passed");
  const Recognition recognition = compile_policy(world.catalogue, world.perception(), options);
  const Values sign{{"sign", true}}, passing{{"sign", true}, {"passed", true}}, red{{"red", true}};
  EXPECT_EQ(run(recognition, {sign, red}), (std::vector<bool>{false, true}));
  EXPECT_EQ(run(recognition, {passing, red}), (std::vector<bool>{false, false}));
  EXPECT_EQ(run(recognition, {sign, red, passing, red}), (std::vector<bool>{false, true, true, false}));
}

TEST(Tree, EntitiesShareTheMemoryOfACommonBeginning) {
  const SmallWorld world;
  PolicyOptions options;
  options.kind = Kind::Tree;
  options.order = {"sign", "main_colour", "shape"};
  const Recognition recognition = compile_policy(world.catalogue, world.perception(), options);
  std::vector<std::string> names;
  for (const LevelMemory& memory : recognition.memories) names.push_back(memory.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"reached_sign", "reached_sign_blue", "reached_sign_red"}));
  EXPECT_NE(recognition.find_entity(SmallWorld::Mandatory), nullptr);
}

TEST(Tree, DoesNotLeadToWhatLacksANamedFeature) {
  const SmallWorld world;
  PolicyOptions options;
  options.kind = Kind::Tree;
  options.order = {"sign", "red"};
  options.entities = {"mandatory", "stop"};
  const Recognition recognition = compile_policy(world.catalogue, world.perception(), options);
  EXPECT_EQ(recognition.find_entity(SmallWorld::Mandatory), nullptr);
  ASSERT_EQ(recognition.notes.size(), 1U);
  EXPECT_EQ(recognition.notes[0].code, "off-the-tree");
}

TEST(Tree, OrFullAddsTheWholeReading) {
  const SmallWorld world;
  PolicyOptions options;
  options.kind = Kind::TreeOrFull;
  options.order = {"sign", "red"};
  options.entities = {"stop"};
  const Recognition recognition = compile_policy(world.catalogue, world.perception(), options);
  EXPECT_EQ(run(recognition, {{{"stop_seen", true}}, {{"sign", true}}, {{"red", true}}}),
            (std::vector<bool>{true, false, true}));
}

/// First step at which it is recognised; the length when never.
std::size_t first(const std::vector<bool>& detected) {
  return static_cast<std::size_t>(std::find(detected.begin(), detected.end(), true) - detected.begin());
}

TEST(Claim, AwarenessDetectsNoLaterThanTreeAndDefinition) {
  const SmallWorld world;
  PolicyOptions options;
  options.entities = {"stop"};
  options.kind = Kind::AtLeast;
  options.over = {"sign", "red", "octagon"};
  options.direct = false;
  const Recognition awareness = compile_policy(world.catalogue, world.perception(), options);
  options.over.clear();
  options.kind = Kind::Definition;
  const Recognition definition = compile_policy(world.catalogue, world.perception(), options);
  const Recognition walk = tree({"sign", "red"}, false);
  std::size_t examined = 0, earlier = 0;
  for (std::size_t length = 1; length <= 5; ++length)
    for (const Trace& trace : traces(length)) {
      const bool parts_only_on_signs = std::all_of(trace.begin(), trace.end(), [](const Values& v) {
        return v.at("sign") || (!v.at("red") && !v.at("octagon"));
      });
      if (!parts_only_on_signs) continue;
      const std::size_t aware = first(run(awareness, trace));
      ASSERT_LE(aware, first(run(walk, trace)));
      ASSERT_LE(aware, first(run(definition, trace)));
      earlier += aware < first(run(walk, trace)) ? 1 : 0;
      ++examined;
    }
  EXPECT_EQ(examined, 5U + 25U + 125U + 625U + 3125U);
  EXPECT_GT(earlier, 0U);
}

}  // namespace
}  // namespace heed::awareness
