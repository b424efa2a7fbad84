#include <heed/job/play.h>
#include <heed/util/file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace heed::job {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string examples = std::string(HEED_SOURCE_DIR) + "/examples/";

/// The page's data of an example with some text replaced.
PlayResult made(const std::string& file,
                const std::vector<std::pair<std::string, std::string>>& changes = {}) {
  std::string text = util::read_file(examples + file).text();
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  util::Budget budget;
  return play(read_scenario(util::SourceText(examples + file, text)), {}, budget);
}

std::vector<std::string> labels(const report::Play& play, const std::vector<std::size_t>& symbols) {
  std::vector<std::string> words;
  for (const std::size_t symbol : symbols) words.push_back(play.symbols[symbol].label);
  return words;
}

const report::PlayEntity& entity(const report::Play& play, const std::string& name) {
  const auto found = std::find_if(play.entities.begin(), play.entities.end(),
                                  [&](const auto& one) { return one.name == name; });
  EXPECT_NE(found, play.entities.end()) << name;
  return *found;
}

TEST(Play, SaysWhatCanBeSeenOfAThing) {
  const report::Play play = made("stop-sign/stop-sign.toml").play;
  ASSERT_TRUE(play.approached);
  EXPECT_EQ(play.entities[*play.approached].name, "stop_sign");
  EXPECT_THAT(labels(play, entity(play, "stop_sign").shows),
              ElementsAre("traffic sign", "main colour red", "shape octagon", "the whole ‘stop’"));
  EXPECT_THAT(labels(play, entity(play, "yield_sign").shows), ElementsAre("traffic sign", "main colour red"));
  EXPECT_EQ(entity(play, "stop_sign").react, "must");
  EXPECT_EQ(entity(play, "yield_sign").react, "may");
  EXPECT_EQ(entity(play, "parking_sign").react, "");
  EXPECT_EQ(play.plant.way, "location");
}

/// A red main colour rules out what is mainly blue; reading the whole leaves one.
TEST(Play, NarrowsTheCandidates) {
  const report::Play play = made("stop-sign/stop-sign.toml").play;
  ASSERT_TRUE(play.candidates);
  const auto candidates = [&](const std::vector<std::int32_t>& letter) {
    const auto at = std::find(play.observations.begin(), play.observations.end(), letter);
    std::vector<std::string> names;
    for (const std::size_t e :
         play.candidates->sets[play.candidates->of[static_cast<std::size_t>(at - play.observations.begin())]])
      names.push_back(play.entities[e].name);
    return names;
  };
  EXPECT_EQ(candidates({0, 0, 0, 0}).size(), play.entities.size());
  EXPECT_THAT(candidates({1, 1, 0, 0}), testing::Contains("yield_sign"));
  EXPECT_THAT(candidates({1, 1, 0, 0}), Not(testing::Contains("parking_sign")));
  EXPECT_THAT(candidates({1, 1, 1, 1}), ElementsAre("stop_sign"));
}

TEST(Play, EveryReasonHasItsAxiomAndFormula) {
  const report::Play play = made("stop-sign/stop-sign.toml").play;
  std::size_t found = 0;
  for (const report::PlayController& controller : play.controllers)
    for (const report::PlayPrescribed& prescribed : controller.prescribes) {
      if (prescribed.effect != "stopping") continue;
      ++found;
      ASSERT_THAT(prescribed.because, testing::SizeIs(1));
      ASSERT_THAT(prescribed.because.front().axioms, Not(IsEmpty()));
      const std::string& id = prescribed.because.front().axioms.front();
      const auto axiom =
          std::find_if(play.axioms.begin(), play.axioms.end(), [&](const auto& one) { return one.id == id; });
      ASSERT_NE(axiom, play.axioms.end());
      EXPECT_THAT(axiom->text, HasSubstr("prescribes some halt"));
      EXPECT_GT(axiom->line, 0U);
      const auto sigma = std::find_if(controller.sigma.begin(), controller.sigma.end(), [&](const auto& one) {
        return one.id == prescribed.because.front().sigma;
      });
      ASSERT_NE(sigma, controller.sigma.end());
      EXPECT_THAT(sigma->text, HasSubstr("-> X halt"));
    }
  EXPECT_EQ(found, play.controllers.size());
}

/// The paper's car without its hard stop: two controllers have no answer in M1.
TEST(Play, LeavesOutWhatDoesNotExist) {
  const std::string plant = util::read_file(examples + "stop-sign/car.fts").text();
  std::string soft = plant;
  soft.erase(soft.find("M1 -hard_stop-> S0"), 18);
  const PlayResult result =
      made("stop-sign/stop-sign.toml", {{"fts = \"car.fts\"", "text = '''" + soft + "'''"}});
  EXPECT_THAT(result.play.controllers, testing::SizeIs(testing::Lt(4U)));
  ASSERT_THAT(result.warnings, Not(IsEmpty()));
  EXPECT_EQ(result.warnings.front().code, "unrealizable");
}

TEST(Play, NeedsNeitherProfileNorJudgement) {
  const report::Play play = made("yield-roles/yield.toml").play;
  EXPECT_THAT(play.profiles, IsEmpty());
  EXPECT_THAT(play.outcomes, IsEmpty());
  EXPECT_THAT(play.controllers, testing::SizeIs(1));
}

/// Two hundred cells and an onset to be remembered for sixty: the chain is replaced by ways through it, which
/// begin at its start and end after as many cells.
TEST(Play, SamplesWhatIsTooLongToWriteDown) {
  const report::Play play = made("stop-sign/stop-sign.toml",
                                 {{"cells = 5\nonsets = [\n  { feature = \"sign\", uniform = [0, 3] }",
                                   "cells = 200\nonsets = [\n  { feature = \"sign\", uniform = [0, 198] }"},
                                  {"{ feature = \"octagon\", uniform = [\"sign\", \"never\"] }",
                                   "{ feature = \"octagon\", fixed = \"sign + 60\" }"}})
                                .play;
  const report::PlayProfile& profile = play.profiles.back();
  const report::PlayApproach& approach = profile.approaches[profile.of[*play.approached]];
  ASSERT_TRUE(approach.sampled);
  const report::PlayChain& chain = profile.chains[approach.chain];
  ASSERT_EQ(chain.front().size(), 64U);
  for (const report::PlayDraw& first : chain.front()) {
    EXPECT_EQ(first.probability, "1/64");
    std::size_t length = 1;
    for (std::size_t at = first.next; !chain[at].empty(); at = chain[at].front().next) ++length;
    EXPECT_EQ(length, 200U);
  }
}

std::string code_of(const std::vector<std::pair<std::string, std::string>>& changes) {
  try {
    (void)made("stop-sign/stop-sign.toml", changes);
  } catch (const util::InputError& error) {
    return error.diagnostic().code;
  }
  return "none";
}

TEST(Play, RefusesWhatAPageCannotShow) {
  EXPECT_EQ(code_of({{"cells = 5", "cells = 401"}}), "too-many-cells");
  const std::string plant = util::read_file(examples + "stop-sign/car.fts").text();
  EXPECT_EQ(code_of({{"fts = \"car.fts\"", "text = '''" + plant + "M4 -go-> M2\n'''"}}),
            "nondeterministic-plant");
}

}  // namespace
}  // namespace heed::job
