// The controllers come from the knowledge: edit a file and the figures follow.
#include "enumeration.h"
#include "workshop.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace case_study {
namespace {

using Row = std::vector<std::string>;

Row row_of(const report::RunResult& result, const std::string& profile, const std::string& controller) {
  Row bars;
  for (const report::Chart& chart : result.charts)
    if (chart.profile == profile && chart.controller == controller)
      for (const report::Bar& bar : chart.bars) bars.push_back(bar.exact.exact);
  return bars;
}

/// Takes `hasMainColour some Red` out of the stop sign's definition, and nothing else.
void take_red_away(const Example& example) {
  const std::string ns = "http://example.org/heed/traffic-signs#";
  std::string text = read(example.path("traffic-signs.owl"));
  const std::size_t sign = text.find("<owl:Class rdf:about=\"" + ns + "StopSign\">");
  ASSERT_NE(sign, std::string::npos);
  const std::size_t role = text.find("\"" + ns + "hasMainColour\"/>", sign);
  ASSERT_LT(role, text.find("<!--", sign));
  const std::size_t begin = text.rfind("<owl:Restriction>", role);
  const std::string close = "</owl:Restriction>";
  const std::size_t end = text.find(close, role) + close.size();
  ASSERT_NE(text.substr(begin, end - begin).find("#Red\""), std::string::npos);
  write(example.path("traffic-signs.owl"), text.erase(begin, end - begin));
}

TEST(Knowledge, WithoutRedTheStopSignCountsTwoFeatures) {
  const Example example;
  take_red_away(example);
  const Outcome outcome = run_job(example.scenario(), example.path("out"));
  // What falls out of the description does not count, and such a sign shows no red either.
  const unsigned has = Sign | Shape | Whole;
  const Detects awareness = two_of(Sign | Shape);
  const Row p1 = row(linear_growth({Colour, Shape}, has), has, awareness);
  EXPECT_EQ(row_of(outcome.result, "P1", "awareness"), p1);
  EXPECT_EQ(p1, (Row{"13/32", "5/32", "3/16", "1/4", "0"}));
  EXPECT_EQ(row_of(outcome.result, "P2", "awareness"), row(traces_of("P2"), has, awareness));
  EXPECT_EQ(row_of(outcome.result, "P2", "awareness"), (Row{"1/6", "1/3", "1/3", "1/6", "0"}));
  EXPECT_EQ(row_of(outcome.result, "P3", "awareness"), row(traces_of("P3"), has, awareness));
  for (const char* profile : {"P1", "P2", "P3"})
    EXPECT_EQ(row_of(outcome.result, profile, "tree").front(), "1") << "the tree leads through red";
  // Even where red is reported, it is no evidence.
  const std::string formula = read(example.path("out/awareness.gr1"));
  EXPECT_NE(formula.find("recognised_stop_sign := sign & octagon\n"), std::string::npos) << formula;
}

TEST(Knowledge, NamesDoNotMatter) {
  Example plain, renamed;
  renamed.edit("traffic-signs.owl", "#StopSign\"", "#Zeichen206\"");
  renamed.edit("stop-sign.toml", "\"StopSign\"", "\"Zeichen206\"");
  const Outcome before = run_job(plain.scenario(), plain.path("out"));
  const Outcome after = run_job(renamed.scenario(), renamed.path("out"));
  ASSERT_EQ(before.result.charts.size(), 12U);
  for (const report::Chart& chart : before.result.charts)
    EXPECT_EQ(row_of(after.result, chart.profile, chart.controller),
              row_of(before.result, chart.profile, chart.controller))
        << chart.profile << ' ' << chart.controller;
  const model::Mealy machine = read_controller(renamed.path("out/awareness.controller.json"));
  for (const model::Output& output : machine.outputs)
    EXPECT_EQ(output.variable.name.find("stop"), std::string::npos) << output.variable.name;
}

TEST(Knowledge, OldNameIsUnknownAfterRenaming) {
  Example example;
  example.edit("traffic-signs.owl", "#StopSign\"", "#Zeichen206\"");
  const Said said = heed_says({"run", example.scenario(), "-o", example.path("out")});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_NE(said.err.find("StopSign"), std::string::npos) << said.err;
  EXPECT_FALSE(fs::exists(example.path("out")));
}

/// The car, written down once more: where each action leads from each state.
std::map<std::string, std::set<std::string>> car(bool hard_stop) {
  std::map<std::string, std::set<std::string>> next;
  for (int i = 4; i >= 0; --i) {
    const std::string to = std::to_string((i + 4) % 5);
    next["M" + std::to_string(i)] = {"M" + to};
    next["S" + std::to_string(i)] = {"M" + to, "S" + to};
    if (i != 1 || hard_stop) next["M" + std::to_string(i)].insert("S" + to);
  }
  return next;
}

/// Does some trace leave the car no successor with the right label? It starts in M0 with nothing in view.
bool some_trace_has_no_answer(const Traces& traces, const Detects& detects, bool hard_stop) {
  const auto next = car(hard_stop);
  for (const Trace& trace : traces) {
    std::string state = "M4";  // after the blank first step
    unsigned before = 0;
    for (const unsigned now : trace.seen) {
      const char wanted = detects(now, before) ? 'S' : 'M';
      std::string found;
      for (const std::string& to : next.at(state))
        if (to[0] == wanted) found = to;
      if (found.empty()) return true;
      state = found;
      before = now;
    }
  }
  return false;
}

TEST(Knowledge, WithoutTheHardStopNothingCanPromiseToStop) {
  const std::map<std::string, Detects> controllers{{"base", base_detects},
                                                   {"tree", tree_detects},
                                                   {"awareness", two_of(Sign | Colour | Shape)},
                                                   {"tree-or-full", tree_or_full_detects}};
  for (const auto& [name, detects] : controllers) {
    EXPECT_TRUE(some_trace_has_no_answer(traces_of("P1"), detects, false)) << name;
    EXPECT_FALSE(some_trace_has_no_answer(traces_of("P1"), detects, true)) << name;
  }
  Example example;
  example.edit("car.fts", "M1 -hard_stop-> S0\n", "");
  const Outcome outcome = run_job(example.scenario(), example.path("out"));
  EXPECT_TRUE(outcome.result.charts.empty());
  for (const report::Controller& controller : outcome.result.controllers) {
    EXPECT_EQ(controller.verdict, report::Verdict::Unrealizable) << controller.name;
    std::string reasons;
    for (const std::string& reason : controller.reasons) reasons += reason + '\n';
    EXPECT_NE(reasons.find("X (stopping) <-> prescribed_halt"), std::string::npos) << reasons;
    EXPECT_NE(reasons.find("slow_down only where the plant can"), std::string::npos) << reasons;
    EXPECT_NE(reasons.find("M2 sees "), std::string::npos) << "the last state with an answer: " << reasons;
    EXPECT_FALSE(fs::exists(example.path("out/" + controller.name + ".controller.json")));
  }
  const Said said = heed_says({"run", example.scenario(), "-o", example.path("again")});
  EXPECT_EQ(said.exit_code, 1) << said.err;
  EXPECT_NE(said.out.find("UNREALIZABLE"), std::string::npos);
  EXPECT_NE(said.out.find("In M1 there is no way out"), std::string::npos) << said.out;
  const Said json = heed_says({"run", example.scenario(), "-o", example.path("third"), "--json"});
  EXPECT_EQ(json.exit_code, 1);
}

void add_text(Example& example) {
  const std::string scenario = "stop-sign.toml";
  example.edit(scenario, "  { name = \"stop_sign\", what",
               "  { name = \"text\", what = \"hasText StopText\" },\n  { name = \"stop_sign\", what");
  example.edit(scenario, "over = [\"sign\", \"red\", \"octagon\"]",
               "over = [\"sign\", \"red\", \"octagon\", \"text\"]");
  example.edit(scenario, "  { feature = \"octagon\", geometric = \"1/2\", from = \"sign + 1\" },\n",
               "  { feature = \"octagon\", geometric = \"1/2\", from = \"sign + 1\" },\n"
               "  { feature = \"text\", geometric = \"1/2\", from = \"sign + 1\" },\n");
  example.edit(scenario, "shuffle = [\"red\", \"octagon\"], at = [\"sign + 1\", \"sign + 2\"]",
               "shuffle = [\"red\", \"octagon\", \"text\"], at = [\"sign + 1\", \"sign + 2\", \"sign + 3\"]");
  example.edit(scenario, "fixed = \"sign + 3\"", "fixed = \"sign + 4\"");
  example.edit(scenario, "  { feature = \"stop_sign\", uniform = [\"red\", \"never\"] },\n",
               "  { feature = \"text\", uniform = [\"red\", \"never\"] },\n"
               "  { feature = \"stop_sign\", uniform = [\"red\", \"never\"] },\n");
}

TEST(Knowledge, AFourthFeatureCounts) {
  Example example;
  add_text(example);
  const Outcome outcome = run_job(example.scenario(), example.path("out"));
  const std::map<std::string, Traces> traces{
      {"P1", linear_growth({Colour, Shape, Text}, Sign | Colour | Shape | Text | Whole)},
      {"P2", closely_consecutive({Colour, Shape, Text})},
      {"P3", loosely_consecutive({Text, Whole})}};
  const Detects awareness = two_of(Sign | Colour | Shape | Text);
  for (const auto& [profile, list] : traces) {
    mpq_class sum = 0;
    for (const Trace& trace : list) sum += trace.probability;
    EXPECT_EQ(sum, 1) << profile;
    EXPECT_EQ(row_of(outcome.result, profile, "awareness"), row(list, ~0U, awareness)) << profile;
    EXPECT_EQ(row_of(outcome.result, profile, "base"), row(list, ~0U, base_detects)) << profile;
    EXPECT_EQ(row_of(outcome.result, profile, "tree"), row(list, ~0U, tree_detects)) << profile;
  }
  EXPECT_NE(row_of(outcome.result, "P1", "awareness").front(), "19/64") << "a fourth feature helps";
}

}  // namespace
}  // namespace case_study
