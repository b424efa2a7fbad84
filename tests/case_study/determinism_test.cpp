// Two runs and any number of threads leave the same bytes, timings apart.
#include "workshop.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>

namespace case_study {
namespace {

std::string without_timings(const std::string& html) {
  const std::size_t begin = html.find("<section id=\"timings\"");
  EXPECT_NE(begin, std::string::npos);
  const std::string close = "</section>";
  const std::size_t end = html.find(close, begin);
  EXPECT_NE(end, std::string::npos);
  return html.substr(0, begin) + html.substr(end + close.size());
}

/// The text of the document without the value of its key `timings`, byte for byte.
std::string json_without_timings(const std::string& text) {
  auto document = nlohmann::ordered_json::parse(text);
  EXPECT_EQ(document.erase("timings"), 1U);
  // Bytes, not values: what is cut away is the one key at the top, which begins a line.
  const std::size_t begin = text.find("\n \"timings\": {");
  const std::size_t wide = text.find("\n  \"timings\": {");
  const std::size_t at = std::min(begin, wide);
  EXPECT_NE(at, std::string::npos);
  const std::size_t end = text.find(wide < begin ? "\n  }" : "\n }", at);
  EXPECT_NE(end, std::string::npos);
  const std::string rest = text.substr(0, at) + text.substr(end);
  EXPECT_EQ(rest.find("_seconds\""), std::string::npos);
  return rest;
}

std::map<std::string, std::string> leavings(const Example& example, const std::vector<std::string>& more) {
  const std::string folder = example.path("out");
  std::vector<std::string> words{"run", "stop-sign.toml", "-o", folder};
  words.insert(words.end(), more.begin(), more.end());
  const Said said = heed_says(words, fs::path(example.scenario()).parent_path().string());
  EXPECT_EQ(said.exit_code, 0) << said.err;
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    std::string text = read(entry.path().string());
    if (name == "report.html") text = without_timings(text);
    if (name == "report.json") text = json_without_timings(text);
    files[name] = std::move(text);
  }
  fs::remove_all(folder);
  return files;
}

TEST(Determinism, SameBytesWhateverTheThreads) {
  const Example example;
  const auto first = leavings(example, {});
  EXPECT_EQ(first.size(), 10U);
  const std::vector<std::vector<std::string>> variants{
      {}, {"--threads", "1"}, {"--threads", "2"}, {"--threads", "4"}, {"--json"}, {"--details"}};
  for (const auto& variant : variants) {
    const auto again = leavings(example, variant);
    ASSERT_EQ(again.size(), first.size());
    for (const auto& [name, text] : first)
      EXPECT_TRUE(again.at(name) == text) << name << " with " << (variant.empty() ? "" : variant.back());
  }
}

TEST(Determinism, AnotherSeedIsSeen) {
  const Example example;
  const auto first = leavings(example, {}), other = leavings(example, {"--seed", "2"});
  EXPECT_NE(first.at("report.json"), other.at("report.json"));
  EXPECT_EQ(first.at("awareness.controller.json"), other.at("awareness.controller.json"));
}

}  // namespace
}  // namespace case_study
