#include <gtest/gtest.h>
#include <heed/report/write.h>
#include <heed/util/file.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>

#include "unit/report/sample.h"
#include "unit/report/schema.h"

namespace heed::report {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

const std::string& documentation() {
  static const std::string text = util::read_file(HEED_SOURCE_DIR "/docs/formats/result.md").text();
  return text;
}

Json schema() {
  return Json::parse(test::fenced(documentation(), "## Schema"));
}

/// Every pointer at which two documents differ.
std::set<std::string> differences(const Json& a, const Json& b) {
  std::set<std::string> found;
  for (const Json& step : Json::diff(a, b)) {
    const std::string path = step["path"];
    found.insert(path.substr(0, path.find('/', 1)));
  }
  return found;
}

TEST(Json, KeepsTheSchemaOfTheDocumentation) {
  EXPECT_EQ(test::violations(Json::parse(to_json(sample::result())), schema()), std::vector<std::string>{});
}

TEST(Json, AnEmptyResultKeepsTheSchemaAsWell) {
  EXPECT_EQ(test::violations(Json::parse(to_json(RunResult{})), schema()), std::vector<std::string>{});
}

TEST(Json, TheSchemaRefusesWhatIsWrong) {
  Json document = Json::parse(to_json(sample::result()));
  document["charts"][0]["bars"][0]["exact"]["value"] = "5/8";
  document["controllers"][0]["verdict"] = "fine";
  document["surprise"] = 1;
  document.erase("seed");
  EXPECT_EQ(test::violations(document, schema()).size(), 4u);
}

TEST(Json, KeysStandInTheOrderOfTheSchema) {
  const Json document = Json::parse(to_json(sample::result()));
  const Json definitions = schema()["$defs"];
  EXPECT_EQ(keys(document), definitions["run"]["required"].get<std::vector<std::string>>());
  EXPECT_EQ(keys(document["controllers"][0]),
            definitions["controller"]["required"].get<std::vector<std::string>>());
  EXPECT_EQ(keys(document["catalogue"][0]), definitions["entry"]["required"].get<std::vector<std::string>>());
}

TEST(Json, TheExampleOfTheDocumentationIsWhatIsWritten) {
  EXPECT_EQ(to_json(sample::small()), test::fenced(documentation(), "## Example"));
}

TEST(Json, FiguresReadBackExactly) {
  const RunResult result = sample::result();
  const Json document = Json::parse(to_json(result));
  for (std::size_t c = 0; c < result.charts.size(); ++c)
    for (std::size_t b = 0; b < result.charts[c].bars.size(); ++b) {
      const Bar& bar = result.charts[c].bars[b];
      const Json& written = document["charts"][c]["bars"][b];
      EXPECT_EQ(written["exact"]["value"].get<double>(), bar.exact.value);
      EXPECT_EQ(written["exact"]["exact"].get<std::string>(), bar.exact.exact);
      EXPECT_EQ(written["sampled"].get<std::uint64_t>(), bar.sampled);
      EXPECT_EQ(written["low"].get<double>(), bar.low);
    }
}

TEST(Json, OnlyTheTimingsDependOnTheMachine) {
  RunResult slow = sample::result();
  slow.timings.cpu_seconds = 99;
  slow.timings.stages[0].seconds = 42;
  slow.timings.peak_bytes = 1;
  const Json a = Json::parse(to_json(sample::result())), b = Json::parse(to_json(slow));
  EXPECT_EQ(differences(a, b), std::set<std::string>{"/timings"});
}

TEST(Json, SameResultSameBytes) {
  EXPECT_EQ(to_json(sample::result()), to_json(sample::result()));
}

TEST(Json, UnsampledChartsHaveNoSamples) {
  RunResult result = sample::result();
  for (Chart& chart : result.charts) chart.traces = 0;
  const Json document = Json::parse(to_json(result));
  EXPECT_FALSE(document["charts"][0].contains("chi_square"));
  EXPECT_FALSE(document["charts"][0]["bars"][0].contains("frequency"));
  EXPECT_EQ(test::violations(document, schema()), std::vector<std::string>{});
}

TEST(Json, HostileTextStaysText) {
  RunResult result = sample::result();
  result.scenario = "\"}], \\ \n\x01 \xff\xc0 </script>";
  const Json document = Json::parse(to_json(result));
  EXPECT_EQ(document["scenario"], "\"}], \\ \n\x01 \xEF\xBF\xBD\xEF\xBF\xBD </script>");
}

}  // namespace

}  // namespace heed::report
