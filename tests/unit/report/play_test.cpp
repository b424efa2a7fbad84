#include <gtest/gtest.h>
#include <heed/report/play.h>
#include <heed/util/file.h>

#include <nlohmann/json.hpp>

#include <string>

#include "unit/report/schema.h"

namespace heed::report {

namespace {

using Json = nlohmann::ordered_json;

PlayController echo() {
  PlayController out{"echo", "Echo", "red is seen"};
  PlayVariable action{"action", false, 0, 1, {"go", "halt"}};
  out.outputs = {{action, "action"},
                 {{"recognised_stop_light"}, "recognised"},
                 {{"prescribed_halt", true, 0, 1, {}, "halt: prescribed by stop light"}, "prescribed"}};
  out.reactions = {{0, 0, 0}, {1, 1, 1}};
  out.states = {{{0, 0, 0}, {1, 1, 1, 1}}, {{0, 0, 1, std::nullopt, true}, {1, 1, 1}}};
  out.recognises = {{1, "stop light", {{{"red"}, {}, "k1"}}}};
  out.prescribes = {{2, "halt", "halted", {{1, {"a1"}, "k2"}}}};
  out.sigma = {{"k2",
                "prescription",
                "G (stop_light -> X halt)",
                "A 'stop light' prescribes to 'halt' next.",
                {"a1"}}};
  return out;
}

/// The example of docs/formats/play.md.
Play example() {
  Play play;
  play.scenario = "Echo";
  play.thing = "the light";
  play.kind = "light";
  play.approached = 0;
  play.cells = 2;
  play.subject = "echo";
  play.inputs = {{"red"}};
  play.symbols = {{"red", "colour red", "feature", 0, 1, 0, std::nullopt}};
  play.features = {{"red", "colour", "red"}};
  play.entities = {{"stop_light", "stop light", "", {0}, {"halt"}, "must", {0}}};
  play.plant = {{"G1", "G0", "H0"}, {{"halted", {2}}}, {{"way", {1, 0, 0}}}, "way"};
  play.speed = PlaySpeed{10, 30};
  play.event = "X halted";
  play.outcomes = {"missed", "halts"};
  const PlayChain chain{{{"1/2", 1, {}}, {"1/2", 1, {0}}}, {{"1", 2, {0}}}, {}};
  play.profiles = {{"P", "sooner or later", 2, {"red: uniform 0 ... 1"}, {chain}, {{0, {0}}}, {0, 0}}};
  play.observations = {{0}, {1}};
  play.candidates = PlayCandidates{{{0}}, {0, 0}};
  play.axioms = {{"a1", "StopLight SubClassOf prescribes some Halt", "lights.owl", 12}};
  play.controllers = {echo()};
  play.versions = {{"heed", "0.1.0"}};
  return play;
}

TEST(PlayJson, IsTheExampleOfTheDocumentation) {
  const std::string page = util::read_file(HEED_SOURCE_DIR "/docs/formats/play.md").text();
  const Json documented = Json::parse(test::fenced(page, "## Example"));
  const Json written = Json::parse(to_json(example()));
  EXPECT_EQ(Json::diff(documented, written), Json::array());
  EXPECT_EQ(documented.dump(), written.dump()) << "the keys stand in another order";
}

TEST(PlayJson, SaysWhatIsNotThere) {
  const Json out = Json::parse(to_json(Play{"empty"}));
  EXPECT_EQ(out["approached"], -1);
  EXPECT_TRUE(out["speed"].is_null());
  EXPECT_TRUE(out["candidates"].is_null());
  EXPECT_EQ(out["axioms"], Json::object());
  EXPECT_EQ(out["controllers"], Json::array());
}

TEST(PlayJson, RepairsWhatIsNotUtf8) {
  Play play = example();
  play.description = "a\xff z";
  EXPECT_EQ(Json::parse(to_json(play))["description"], "a\xEF\xBF\xBD z");
}

TEST(PlayPage, KeepsHostileTextsInsideItsData) {
  if (!has_play_page()) GTEST_SKIP() << "built without the page";
  Play play = example();
  const std::string hostile = "</script><script>alert(1)</script><!-- & \" \\ \xE2\x80\xA8";
  play.scenario = hostile;
  play.axioms.front().text = hostile;
  const std::string page = to_html(play);
  const std::string start = "<script type=\"application/json\" id=\"play-data\">";
  const std::size_t from = page.find(start) + start.size(), to = page.find("</script>", from);
  const Json data = Json::parse(page.substr(from, to - from));
  EXPECT_EQ(data["scenario"], hostile);
  EXPECT_EQ(data["axioms"]["a1"]["text"], hostile);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
}

TEST(PlayPage, RefersToNothingOutside) {
  if (!has_play_page()) GTEST_SKIP() << "built without the page";
  const std::string page = to_html(example());
  for (const char* reference : {"src=", "http://", "https://", "@import", "url("})
    for (std::size_t at = page.find(reference); at != std::string::npos; at = page.find(reference, at + 1))
      EXPECT_EQ(page.substr(at, 22), "http://www.w3.org/2000");  // the name of SVG's elements
}

}  // namespace

}  // namespace heed::report
