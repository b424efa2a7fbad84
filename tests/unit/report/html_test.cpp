#include <gtest/gtest.h>
#include <heed/report/write.h>

#include <nlohmann/json.hpp>

#include <string>

#include "unit/report/sample.h"
#include "unit/report/xml.h"

namespace heed::report {

namespace {

const std::string hostile = "<script>alert('x')</script>&\"]]> \x01\xff\xE2\x80\xAE";

/// The sample with every text that a user can choose replaced.
RunResult spoilt() {
  RunResult result = sample::result();
  for (std::string* text :
       {&result.scenario, &result.description, &result.command, &result.thing, &result.ontology.iri})
    *text = hostile;
  result.headline = {hostile, hostile};
  for (Axiom& axiom : result.ontology.excerpt) axiom.text = axiom.id = hostile;
  for (KnowledgeFormula& formula : result.knowledge) formula.text = formula.kind = formula.sentence = hostile;
  for (Controller& controller : result.controllers) {
    controller.title = controller.policy = hostile;
    controller.notes = controller.assumptions = {hostile};
    controller.evidence = {{{hostile}, hostile, {hostile}}};
  }
  for (Profile& profile : result.profiles) profile.title = hostile;
  for (Chart& chart : result.charts)
    for (Bar& bar : chart.bars) bar.label += hostile;
  for (CatalogueEntry& entry : result.catalogue) {
    entry.label = entry.group = hostile;
    entry.features = entry.behaviours = {hostile};
  }
  for (TunedPolicy& one : result.tuning.figures) one.policy = one.noise = hostile;
  for (SpeedCurve& curve : result.speed.curves) curve.label = hostile;
  result.warnings[0].message = result.warnings[0].hint = hostile;
  result.versions = {{hostile, hostile}};
  return result;
}

TEST(Html, IsWellFormed) {
  EXPECT_EQ(test::flaw(to_html(sample::result())), "");
  EXPECT_EQ(test::flaw(to_html(RunResult{})), "");
}

TEST(Html, TheReaderOfThisTestFindsFlaws) {
  for (const char* text : {"<a><b></a></b>", "<a>&nbsp;</a>", "<a b=c/>", "<a b='1' b='2'/>", "<a>", "</a>",
                           "<a>x & y</a>", "<a>\x01</a>"})
    EXPECT_NE(test::flaw(text), "") << text;
  EXPECT_EQ(test::flaw("<!DOCTYPE html><a b=\"1\">x &amp; &#39; <c/></a>\n"), "");
}

TEST(Html, HostileTextStaysText) {
  const std::string page = to_html(spoilt());
  EXPECT_EQ(test::flaw(page), "");
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find('\xff'), std::string::npos);
  EXPECT_EQ(page.find("\xE2\x80\xAE"), std::string::npos) << "text that runs backwards";
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&amp;&quot;]]&gt;"), std::string::npos);
}

TEST(Html, NeedsNoNetworkAndNoScript) {
  const std::string page = to_html(sample::result());
  for (const char* word : {"src=", "@import", "url(", "<script", "<iframe", "onload", "onclick"})
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  // The only addresses are names of namespaces and the ontology's own.
  EXPECT_EQ(page.find("href=\"http"), std::string::npos);
}

TEST(Html, PoliciesStandWhereTheirErrorsAre) {
  const std::string page = to_html(sample::result());
  // Misses 47/128 without needless reactions: on the axis, 19/64 at 22/43: the controller's colour.
  EXPECT_NE(page.find("<circle class=\"policy best\" cx=\"46\" cy=\"165.22\""), std::string::npos);
  EXPECT_NE(page.find("<circle class=\"policy own\" cx=\"199.49\" cy=\"180.69\""), std::string::npos);
  EXPECT_EQ(test::flaw(to_svg(sample::tuning())), "");
  EXPECT_EQ(test::flaw(to_svg(Tuning{})), "");
  EXPECT_NE(to_svg(sample::tuning()).find("tree-or-full: misses 36.7 %, needless 0 %"), std::string::npos);
}

DriveResult driving(const std::string& word) {
  DriveResult driving;
  driving.command = "heed drive x.toml";
  driving.thing = word;
  driving.roads = 2;
  driving.outcomes = {"infeasible", "stop in 2"};
  driving.controllers = {{"base", word}, {"awareness", word}};
  driving.profiles = {{"P1", word}};
  driving.setting = {{"cell_metres", 10}};
  for (const char* name : {"base", "awareness"}) {
    DriveRoad halt, miss;
    halt.road = 1;
    halt.outcome = 1;
    halt.cells_left = 2;
    halt.overshoot = 0;
    halt.peak_deceleration = 4.82;
    driving.runs.push_back({"P1", name, {miss, halt}});
    driving.traces.push_back({"P1", name, 1, 1, 2, {{-50, 50}, {-20, 50}, {0, 0}}});
  }
  return driving;
}

/// What base64 says, by a table of what each digit stands for.
std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned held = 0, bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    held = held << 6U | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 255U);
  }
  return bytes;
}

TEST(Html, DrivingStandsWithItsPictures) {
  RunResult result = sample::result();
  EXPECT_EQ(to_html(result).find("id=\"driving\""), std::string::npos);
  result.driving = driving("the stop sign");
  const std::string page = to_html(result);
  EXPECT_EQ(test::flaw(page), "");
  EXPECT_NE(page.find("id=\"driving\""), std::string::npos);
  EXPECT_NE(page.find("heed drive x.toml"), std::string::npos);
  const std::string mark = "data:image/svg+xml;base64,";
  std::vector<std::string> pictures;
  for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + 1)) {
    const std::size_t begin = at + mark.size();
    pictures.push_back(decoded(page.substr(begin, page.find('"', begin) - begin)));
  }
  EXPECT_EQ(pictures, (std::vector<std::string>{metres_svg(*result.driving), braking_svg(*result.driving),
                                                speed_svg(*result.driving)}));
}

TEST(Html, DrivingSurvivesHostileText) {
  RunResult result = spoilt();
  result.driving = driving(hostile);
  const std::string page = to_html(result);
  EXPECT_EQ(test::flaw(page), "");
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST(Html, SameResultSameBytes) {
  EXPECT_EQ(to_html(sample::result()), to_html(sample::result()));
}

TEST(Html, OnlyTheTimingsDependOnTheMachine) {
  RunResult slow = sample::result();
  slow.timings.cpu_seconds = 99;
  slow.timings.stages[0].seconds = 42;
  const auto cut = [](const std::string& page) {
    const auto at = page.find("<section id=\"timings\"");
    EXPECT_NE(at, std::string::npos);
    return page.substr(0, at) + page.substr(page.find("</section>", at));
  };
  EXPECT_NE(to_html(slow), to_html(sample::result()));
  EXPECT_EQ(cut(to_html(slow)), cut(to_html(sample::result())));
}

TEST(Html, NumbersAreThoseOfTheDocument) {
  using Json = nlohmann::json;
  const RunResult result = sample::result();
  const Json document = Json::parse(to_json(result));
  const std::string page = to_html(result);
  const std::string key = "data-path=\"", next = "\" data-value=\"";
  std::size_t found = 0;
  for (auto at = page.find(key); at != std::string::npos; at = page.find(key, at + 1)) {
    const auto begin = at + key.size(), end = page.find('"', begin);
    ASSERT_EQ(page.substr(end, next.size()), next);
    const auto value = end + next.size();
    const std::string path = page.substr(begin, end - begin);
    EXPECT_EQ(std::stod(page.substr(value)), document.at(Json::json_pointer(path)).get<double>()) << path;
    ++found;
  }
  EXPECT_GT(found, 300u);
}

TEST(Html, SpeaksToScreenReaders) {
  const std::string page = to_html(sample::result());
  std::size_t pictures = 0, titles = 0;
  for (auto at = page.find("role=\"img\""); at != std::string::npos; at = page.find("role=\"img\"", at + 1)) {
    ++pictures;
    const auto end = page.find("<g", at);
    const auto title = page.find("<title>", at), desc = page.find("<desc>", at);
    titles += title < end && desc < page.find("</svg>", at) ? 1 : 0;
  }
  EXPECT_EQ(pictures, 6u);
  EXPECT_EQ(titles, pictures);
  EXPECT_NE(page.find("Awareness: infeasible 0 %, stop in 1 33.3 %"), std::string::npos);
}

TEST(Html, LongListsBeginFolded) {
  RunResult result = sample::result();
  const std::string open = "<details open=\"open\">";
  const auto count = [&](const std::string& page) {
    std::size_t found = 0;
    for (auto at = page.find(open); at != std::string::npos; at = page.find(open, at + 1)) ++found;
    return found;
  };
  const std::size_t before = count(to_html(result));
  result.ontology.excerpt.resize(40, result.ontology.excerpt[0]);
  EXPECT_EQ(count(to_html(result)), before - 1);
}

TEST(Html, UnrealizableIsSaid) {
  RunResult result = sample::result();
  result.controllers[1].verdict = Verdict::Unrealizable;
  result.controllers[1].reasons = {"from M1 no action stops the car"};
  const std::string page = to_html(result);
  EXPECT_NE(page.find("Unrealizable"), std::string::npos);
  EXPECT_NE(page.find("from M1 no action stops the car"), std::string::npos);
}

}  // namespace

}  // namespace heed::report
