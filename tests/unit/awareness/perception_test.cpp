#include "fixture.h"

#include <heed/logic/parse.h>
#include <heed/util/diagnostic.h>

#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using test::SmallWorld;

Perception report(std::vector<Reported> reported, bool enumerate = true) {
  const SmallWorld world;
  return resolve_perception(world.catalogue, {std::move(reported), enumerate});
}

Reported symbol(const char* name, std::string atom = {},
                Reported::Reading reading = Reported::Reading::Automatic) {
  return {name, std::move(atom), reading};
}

TEST(Perception, ExclusiveValuesOfOneRoleBecomeOneInput) {
  const Perception p = report({symbol("sign"), symbol("red"), symbol("blue"), symbol("octagon")});
  ASSERT_EQ(p.inputs.size(), 3U);
  EXPECT_EQ(p.inputs[1].name, "main_colour");
  EXPECT_EQ(p.inputs[1].values, (std::vector<std::string>{"unknown", "red", "blue"}));
  EXPECT_EQ(p.inputs[1].meanings[1].value, 2U);
  EXPECT_EQ(p.inputs[1].meanings[1].feature, SmallWorld::Blue);
  EXPECT_EQ(p.inputs[2].name, "octagon");
  EXPECT_TRUE(p.inputs[2].values.empty());
  EXPECT_EQ(logic::to_string(p.over_inputs(logic::parse("sign & red & octagon"))),
            logic::to_string(logic::parse("sign & main_colour = red & octagon")));
}

TEST(Perception, SingleInputsOnRequest) {
  const Perception p = report({symbol("red"), symbol("blue")}, false);
  EXPECT_EQ(p.inputs.size(), 2U);
  EXPECT_EQ(p.over_inputs(logic::name("red")), logic::name("red"));
}

TEST(Perception, ValuesThatMayBeSeenTogetherStaySingle) {
  SmallWorld world;
  world.catalogue.exclusive.erase({SmallWorld::Red, SmallWorld::Blue});
  const Perception p = resolve_perception(world.catalogue, {{symbol("red"), symbol("blue")}, true});
  EXPECT_EQ(p.inputs.size(), 2U);
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0].code, "not-enumerated");
}

TEST(Perception, GroupsAreFeaturesAndLeavesAreReadWhole) {
  const Perception p = report({symbol("sign", "something"), symbol("stop", "stop_seen")});
  EXPECT_EQ(p.feature_atom[SmallWorld::IsSign], "something");
  EXPECT_EQ(p.whole_atom[SmallWorld::Stop], "stop_seen");
  EXPECT_TRUE(p.perceivable[SmallWorld::IsSign]);
}

TEST(Perception, WithoutAListEverythingIsReported) {
  const Perception p = report({}, false);
  EXPECT_EQ(p.symbols.size(), 6U + 4U);
  EXPECT_EQ(p.whole_atom[SmallWorld::Mandatory], "mandatory");
}

std::string code_of(std::vector<Reported> reported) {
  try {
    (void)report(std::move(reported));
  } catch (const util::InputError& error) {
    return error.diagnostic().code + " " + error.diagnostic().hint;
  }
  return "accepted";
}

TEST(Perception, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(code_of({symbol("octagn")}), "unknown-symbol did you mean 'octagon'?");
  EXPECT_TRUE(code_of({symbol("red"), symbol("blue", "red")}).starts_with("duplicate-symbol"));
  EXPECT_TRUE(code_of({symbol("red"), symbol("red", "also_red")}).starts_with("duplicate-symbol"));
  EXPECT_TRUE(code_of({symbol("stop", "", Reported::Reading::Feature)}).starts_with("wrong-reading"));
  EXPECT_TRUE(code_of({symbol("red", "", Reported::Reading::Whole)}).starts_with("wrong-reading"));
}

}  // namespace
}  // namespace heed::awareness
