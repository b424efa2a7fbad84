// The table of the case study to the digit: written down, enumerated here, and found by the program through
// the library, through `heed run` and through `heed simulate` with the controllers that were written to disk.
#include "enumeration.h"
#include "workshop.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>

namespace case_study {
namespace {

using Row = std::vector<std::string>;
using Table = std::map<std::pair<std::string, std::string>, Row>;

Table written_down() {
  return {{{"P1", "base"}, {"5/8", "3/16", "3/16", "0", "0"}},
          {{"P1", "tree"}, {"13/32", "5/32", "3/16", "1/4", "0"}},
          {{"P1", "awareness"}, {"19/64", "9/64", "3/16", "3/8", "0"}},
          {{"P2", "base"}, {"2/3", "1/3", "0", "0", "0"}},
          {{"P2", "tree"}, {"1/6", "1/3", "1/3", "1/6", "0"}},
          {{"P2", "awareness"}, {"0", "1/3", "1/3", "1/3", "0"}},
          {{"P3", "base"}, {"129691/144000", "20111/288000", "19153/864000", "671/108000", "1/864"}},
          {{"P3", "tree"}, {"631/800", "157/1200", "419/7200", "1/45", "0"}},
          {{"P3", "awareness"}, {"19/40", "19/80", "37/240", "11/120", "1/24"}}};
}

const std::map<std::string, Detects>& controllers() {
  static const std::map<std::string, Detects> detects{{"base", base_detects},
                                                      {"tree", tree_detects},
                                                      {"awareness", two_of(Sign | Colour | Shape)},
                                                      {"tree-or-full", tree_or_full_detects}};
  return detects;
}

Table enumerated() {
  Table table;
  for (const char* profile : {"P1", "P2", "P3"})
    for (const auto& [name, detects] : controllers())
      table[{profile, name}] = row(traces_of(profile), ~0U, detects);
  return table;
}

/// Every row that is written down is in \p table, and every row of \p table is what the enumeration gives.
void expect_the_table(const Table& table) {
  for (const auto& [key, expected] : written_down()) {
    ASSERT_EQ(table.count(key), 1U) << key.first << ' ' << key.second;
    EXPECT_EQ(table.at(key), expected) << key.first << ' ' << key.second;
  }
  EXPECT_EQ(table, enumerated());
}

TEST(Table, EnumerationAgreesWithWhatIsWrittenDown) {
  const Table table = enumerated();
  for (const auto& [key, expected] : written_down())
    EXPECT_EQ(table.at(key), expected) << key.first << ' ' << key.second;
}

/// A tree misses where the whole sign is read all the same: why base is not dominated by it.
TEST(Table, BaseStopsWhereTheTreeMisses) {
  const auto only_base = [](const Traces& traces) {
    mpq_class p = 0;
    for (const Trace& trace : traces) {
      const Traces one{{1, trace.seen}};
      const auto base = detection(one, ~0U, base_detects), tree = detection(one, ~0U, tree_detects);
      if (base[0] + base[5] == 0 && tree[0] + tree[5] == 1) p += trace.probability;
    }
    return p;
  };
  EXPECT_EQ(only_base(traces_of("P1")), mpq_class(5, 128));
  EXPECT_NEAR(only_base(traces_of("P3")).get_d(), .0093, .00005);
}

TEST(Table, FromTheLibrary) {
  const Example example;
  const Outcome outcome = run_job(example.scenario(), example.path("out"));
  Table table;
  for (const report::Chart& chart : outcome.result.charts) {
    Row& bars = table[{chart.profile, chart.controller}];
    for (const report::Bar& bar : chart.bars) {
      bars.push_back(bar.exact.exact);
      EXPECT_NEAR(bar.exact.value, mpq_class(bar.exact.exact).get_d(), 1e-15);
    }
  }
  expect_the_table(table);
  for (const report::Controller& controller : outcome.result.controllers)
    EXPECT_EQ(controller.verdict, report::Verdict::Verified) << controller.name;
}

TEST(Table, FromTheProgram) {
  const Example example;
  const Said said = heed_says({"run", example.scenario(), "-o", example.path("out"), "--json"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
  EXPECT_EQ(said.err, "");
  Table table;
  const auto document = nlohmann::json::parse(said.out);
  for (const auto& chart : document.at("charts"))
    for (const auto& bar : chart.at("bars"))
      table[{chart.at("profile"), chart.at("controller")}].push_back(bar.at("exact").at("exact"));
  expect_the_table(table);
  auto on_disk = nlohmann::json::parse(read(example.path("out/report.json")));
  EXPECT_EQ(on_disk, document);
}

TEST(Table, FromControllersOnDisk) {
  const Example example;
  ASSERT_EQ(heed_says({"run", example.scenario(), "-o", example.path("out"), "--traces", "0"}).exit_code, 0);
  // The folder of the run alone: what is simulated are the files, moved elsewhere.
  fs::rename(example.path("out"), example.path("elsewhere"));
  std::vector<std::string> words{"simulate", example.scenario(), "--json"};
  for (const auto& [name, detects] : controllers())
    words.push_back(example.path("elsewhere/" + name + ".controller.json"));
  const Said said = heed_says(words);
  ASSERT_EQ(said.exit_code, 0) << said.err;
  Table table;
  const auto document = nlohmann::json::parse(said.out);
  for (const auto& one : document.at("results")) {
    std::uint64_t sampled = 0;
    for (const auto& bar : one.at("outcomes")) {
      table[{one.at("profile"), one.at("controller")}].push_back(bar.at("exact"));
      sampled += bar.at("sampled").get<std::uint64_t>();
      const double p = bar.at("value").get<double>();
      const double count = bar.at("sampled").get<double>();
      EXPECT_TRUE((p > 0 || count == 0) && (p < 1 || count == 10000)) << count << " of 10000 at p = " << p;
    }
    EXPECT_EQ(sampled, 10000U);
  }
  expect_the_table(table);
}

}  // namespace
}  // namespace case_study
