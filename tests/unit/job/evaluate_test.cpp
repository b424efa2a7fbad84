// The exact analysis of a scenario's controllers: by functions it says the same as state by state.
#include <heed/job/evaluate.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>

namespace heed::job {
namespace {

struct Made {
  explicit Made(const std::string& file)
      : scenario(read_scenario(util::read_file(std::string(HEED_SOURCE_DIR) + "/examples/" + file))),
        world(load_world(scenario, {}, budget)) {}

  strategy::Result synthesized(const ControllerPart& part, strategy::Form form) {
    const Design designed = design(scenario, world, part);
    strategy::Options options;
    options.form = form;
    const auto free = without_perception_assumptions(designed.composed.spec);
    return strategy::synthesize(free.value_or(designed.composed.spec), budget, options);
  }

  util::Budget budget;
  Scenario scenario;
  World world;
};

void expect_same(const Evaluation& one, const Evaluation& other, const std::string& what) {
  ASSERT_TRUE(one.figures.exact && other.figures.exact) << what;
  EXPECT_EQ(one.categories, other.categories);
  EXPECT_EQ(one.exact.probability, other.exact.probability) << what;
  EXPECT_EQ(one.exact.undefined, other.exact.undefined) << what;
}

TEST(Evaluate, MachinesByFunctionsHaveTheOutcomesOfListedOnes) {
  Made made("stop-sign/policies.toml");
  const std::size_t stop = made.world.knowledge.catalogue.entity("StopSign");
  int compared = 0;
  for (const ControllerPart& part : made.scenario.controllers) {
    const auto listed = made.synthesized(part, strategy::Form::Explicit).machine;
    const auto functions = made.synthesized(part, strategy::Form::Symbolic).symbolic;
    ASSERT_TRUE(listed && functions) << part.name.text;
    for (const ProfilePart& profile : made.scenario.profiles)
      for (const Thing thing : {Thing(stop), Thing()}) {
        const EvaluateOptions options{0, 1, 1, true, 0};
        expect_same(evaluate(made.scenario, made.world, profile, *listed, thing, options, made.budget),
                    evaluate(made.scenario, made.world, profile, *functions, thing, options, made.budget),
                    part.name.text + " " + profile.spec.name);
        ++compared;
      }
  }
  EXPECT_GE(compared, 48);
}

TEST(Evaluate, RatesOfAProfileAreReadAndTold) {
  const std::string path = std::string(HEED_SOURCE_DIR) + "/examples/stop-sign/stop-sign.toml";
  std::string text = util::read_file(path).text();
  const std::string rule = "{ feature = \"sign\", uniform = [0, 2] }";
  const auto at = text.find(rule);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, rule.size(),
               "{ feature = \"sign\", fixed = 0, detection = [\"1/2\", 1], false_detection = \"1/9\", "
               "persistent = false }");
  const Scenario scenario = read_scenario(util::SourceText(path, text));
  const ProfilePart& profile = scenario.profiles.at(1);
  const sim::FeatureSpec& sign = profile.spec.features.front();
  EXPECT_EQ(sign.detection, sim::Rational(1, 2));
  EXPECT_EQ(sign.detection_at_end, std::optional<sim::Rational>(1));
  EXPECT_FALSE(sign.false_detection_at_end);
  EXPECT_EQ(sign.persistent, std::optional(false));
  EXPECT_EQ(
      profile.description.front(),
      "sign: seen from cell 0 on; reported with probability 1/2 at the horizon, linearly to 1 in the last "
      "cell; falsely reported with probability 1/9; reported anew in each cell");
}

}  // namespace
}  // namespace heed::job
