// How often a profile breaks what is assumed of perception, against a second reading of the assumptions: on
// the sequences of reports themselves.
#include "../src/job/assumed.h"

#include <heed/job/run.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>

#include <map>

namespace heed::job {
namespace {

constexpr std::uint64_t sign = 1, red = 2, octagon = 4, whole = 8;

/// All sequences of reports of a chain.
std::map<std::vector<std::uint64_t>, sim::Rational> sequences(const sim::Chain& chain) {
  std::map<std::pair<std::vector<std::uint64_t>, std::uint32_t>, sim::Rational> layer{{{{}, 0}, 1}};
  for (std::uint32_t cell = 0; cell < chain.cells; ++cell) {
    const auto before = std::exchange(layer, {});
    for (const auto& [at, probability] : before)
      for (std::uint32_t i = chain.first[at.second]; i < chain.first[at.second + 1]; ++i) {
        auto longer = at.first;
        longer.push_back(chain.steps[i].seen);
        layer[{longer, chain.steps[i].next}] += probability * chain.steps[i].probability;
      }
  }
  std::map<std::vector<std::uint64_t>, sim::Rational> law;
  for (const auto& [at, probability] : layer) law[at.first] += probability;
  return law;
}

/// The scenario's assumptions, on the way from location 4 to 0: what is seen stays seen until the last cell,
/// a part is seen on a seen sign only, the whole with a part only.
bool kept(const std::vector<std::uint64_t>& reports) {
  for (std::size_t cell = 0; cell < reports.size(); ++cell) {
    const std::uint64_t seen = reports[cell];
    if ((seen & (red | octagon)) != 0 && (seen & sign) == 0) return false;
    if ((seen & whole) != 0 && (seen & (red | octagon)) == 0) return false;
    if (cell > 0 && (reports[cell - 1] & ~seen) != 0) return false;
  }
  return true;
}

class Assumptions : public testing::Test {
 protected:
  Scenario changed(const std::string& what, const std::string& by) {
    const std::string path = HEED_SOURCE_DIR "/examples/stop-sign/stop-sign.toml";
    std::string text = util::read_file(path, {}).text();
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), by);
    return read_scenario(util::SourceText(path, text));
  }

  /// For P1 and every controller; the enumeration beside it.
  void compare(const Scenario& scenario, bool breaks) {
    util::Budget budget;
    const World world = load_world(scenario, {}, budget);
    const std::size_t stop = world.knowledge.catalogue.entity("StopSign");
    for (const ControllerPart& part : scenario.controllers) {
      const Design designed = design(scenario, world, part);
      const Synthesized done = synthesize(designed, scenario.perception.on_violation, budget);
      const ReadyApproach ready = ready_approach(scenario.profiles.front(), world,
                                                 done.result.machine->inputs, part.name.text, stop, budget);
      sim::Rational broken = 0;
      for (const auto& [reports, probability] : sequences(*ready.chain))
        if (!kept(reports)) broken += probability;
      EXPECT_EQ(broken != 0, breaks);
      EXPECT_EQ(assumptions_broken(designed.composed.spec, ready, *done.result.machine, budget), broken)
          << part.name.text;
    }
  }
};

TEST_F(Assumptions, HoldOnTheCaseStudy) {
  compare(changed("cells = 5", "cells = 5"), false);
}

TEST_F(Assumptions, BreakWhereFeaturesFlicker) {
  compare(changed("cells = 5",
                  "cells = 5\npersistent = false\n"
                  "misreadings = [{ of = \"red\", as = \"octagon\", probability = \"1/10\" }]"),
          true);
}

TEST_F(Assumptions, BreakWhereAPartIsSeenBeforeTheSign) {
  compare(changed("{ feature = \"red\", geometric = \"1/2\", from = \"sign + 1\" }",
                  "{ feature = \"red\", geometric = \"1/2\", false_detection = \"1/20\" }"),
          true);
}

TEST_F(Assumptions, BreakWhereTheSignIsTakenForTheWhole) {
  compare(
      changed("cells = 5",
              "cells = 5\nmisreadings = [{ of = \"sign\", as = \"stop_sign\", probability = [\"1/4\", 0] },"
              "{ of = \"octagon\", as = \"red\", probability = \"1/3\", per = \"approach\" }]"),
      true);
}

}  // namespace
}  // namespace heed::job
