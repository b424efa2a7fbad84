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

}  // namespace
}  // namespace heed::job
