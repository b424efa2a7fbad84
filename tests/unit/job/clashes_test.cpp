#include <heed/job/clashes.h>
#include <heed/logic/parse.h>
#include <heed/util/file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heed::job {
namespace {

using testing::HasSubstr;

const std::string warehouse = std::string(HEED_SOURCE_DIR) + "/examples/warehouse/warehouse.toml";

/// The warehouse with one text replaced, and what comes of its last controller.
struct Changed {
  Scenario scenario;
  World world;
  Design design;
  util::Budget budget;

  Changed(const std::string& from, const std::string& to) {
    std::string text = util::read_file(warehouse).text();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    scenario = read_scenario(util::SourceText(warehouse, text));
    world = load_world(scenario, {}, budget);
    design = job::design(scenario, world, scenario.controllers.back());
  }

  [[nodiscard]] std::vector<std::string> bindings() const {
    std::vector<std::string> texts;
    for (const spec::Clause& clause : design.composed.spec.sys_safety)
      if (clause.origin == spec::Origin::Binding) texts.push_back(clause.text);
    return texts;
  }
  util::Diagnostics settle() { return settle_clashes(scenario, world, design, budget); }
};

TEST(Clashes, AreRefusedWithAnExampleAndItsPlace) {
  Changed changed("priority = [\"Wait\"]", "");
  try {
    (void)changed.settle();
    FAIL() << "nobody said which comes first";
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "conflicting-behaviours");
    EXPECT_THAT(error.diagnostic().message, HasSubstr("walking, vest in view"));
    EXPECT_THAT(error.diagnostic().hint, HasSubstr("priority = [\"Wait\", \"Approach\"]"));
    EXPECT_EQ(error.diagnostic().location.line, 31U);
  }
}

TEST(Clashes, APrioritySettlesThemAndSaysSo) {
  Changed changed("GF dist = 0", "GF dist = 0");
  EXPECT_THAT(changed.bindings(),
              testing::ElementsAre("prescribed_wait -> X (waiting)",
                                   "prescribed_approach & !prescribed_wait -> X (driving)"));
  const util::Diagnostics notes = changed.settle();
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].code, "behaviours-by-priority");
  EXPECT_THAT(notes[0].message, HasSubstr("'Wait' comes first"));
}

TEST(Clashes, TheOtherPriorityTurnsThemAround) {
  const Changed changed("priority = [\"Wait\"]", "priority = [\"Approach\"]");
  EXPECT_THAT(changed.bindings(),
              testing::ElementsAre("prescribed_wait & !prescribed_approach -> X (waiting)",
                                   "prescribed_approach -> X (driving)"));
}

TEST(Clashes, FormulasThatAgreeSomewhereAreNone) {
  Changed changed("Approach = \"driving\"", "Approach = \"driving | waiting\"");
  EXPECT_THAT(changed.bindings(), testing::ElementsAre("prescribed_wait -> X (waiting)",
                                                       "prescribed_approach -> X (driving | waiting)"));
  EXPECT_TRUE(changed.settle().empty());
}

// What the assumptions rule out never asks for both at once.
TEST(Clashes, AssumptionsKeepThemApart) {
  Changed changed("assumptions = [\"GF !prescribed_wait\"]", "assumptions = [\"G !prescribed_wait\"]");
  EXPECT_TRUE(changed.settle().empty());
  Changed refused("priority = [\"Wait\"]", "");
  EXPECT_THROW((void)refused.settle(), util::InputError);
}

}  // namespace
}  // namespace heed::job
