// The whole range of policies side by side: distributions on the stop sign, and braking for other signs,
// against the enumeration of traces. What each policy needs to see is written down here from what the
// Vienna Convention's pictures show: only the stop sign is an octagon; yield and no entry are red as well.
#include "enumeration.h"
#include "workshop.h"

#include <heed/awareness/observation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace case_study {
namespace {

constexpr unsigned reported = Sign | Colour | Shape | Whole;

bool all_parts(unsigned now, unsigned) {
  return (now & (Sign | Colour | Shape)) == (Sign | Colour | Shape);
}

bool only_a_stop_sign(unsigned now, unsigned) {
  return (now & (Shape | Whole)) != 0;
}

/// Any sign at all might be one at which to halt, as long as nothing says what it is.
bool anything(unsigned now, unsigned) {
  return now != 0;
}

const std::map<std::string, Detects>& controllers() {
  static const std::map<std::string, Detects> detects{{"full", base_detects},
                                                      {"tree", tree_detects},
                                                      {"tree-or-full", tree_or_full_detects},
                                                      {"definition", all_parts},
                                                      {"at-least-2", two_of(Sign | Colour | Shape)},
                                                      {"identifying", only_a_stop_sign},
                                                      {"common", only_a_stop_sign},
                                                      {"brave", anything}};
  return detects;
}

const Outcome& outcome() {
  static const Folder folder;
  static const Outcome done =
      run_job(std::string(HEED_SOURCE_DIR) + "/examples/stop-sign/policies.toml", folder.path("out"));
  return done;
}

TEST(Policies, DistributionsAreThoseOfTheEnumeration) {
  ASSERT_EQ(outcome().result.charts.size(), 3 * controllers().size());
  for (const report::Chart& chart : outcome().result.charts) {
    const auto expected = row(traces_of(chart.profile), reported, controllers().at(chart.controller));
    ASSERT_EQ(chart.bars.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_EQ(chart.bars[i].exact.exact, expected[i]) << chart.profile << ' ' << chart.controller;
  }
}

struct Shown {
  std::string label;
  unsigned parts;
  bool excused = false;  ///< It prescribes halting or giving way.
};

/// Only what is seen of another sign counts; it never has the octagon or the whole stop sign.
TEST(Policies, BrakingForOtherSignsIsThatOfTheEnumeration) {
  const std::vector<Shown> signs{{"stop", reported, true},
                                 {"give way", Sign | Colour, true},
                                 {"no entry", Sign | Colour, true},
                                 {"speed limit 30", Sign | Colour},
                                 {"priority road", Sign},
                                 {"parking", Sign},
                                 {"nothing there", 0}};
  for (const Shown& sign : signs) {
    const auto& all = outcome().result.catalogue;
    const auto entry =
        std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.label == sign.label; });
    ASSERT_NE(entry, all.end()) << sign.label;
    EXPECT_EQ(entry->encounters.size(), 3 * controllers().size());
    for (const report::Encounter& found : entry->encounters) {
      const auto where = detection(traces_of(found.profile), sign.parts, controllers().at(found.controller));
      const std::string what = sign.label + " " + found.profile + " " + found.controller;
      EXPECT_EQ(found.stop.exact, mpq_class(1 - where[0] - where[5]).get_str()) << what;
      ASSERT_EQ(found.needless.has_value(), !sign.excused) << what;
      if (found.needless) {
        EXPECT_EQ(found.needless->exact, mpq_class(1 - where[5]).get_str()) << what;
      }
    }
  }
}

class Seen {
 public:
  Seen() {
    util::Budget budget;
    world_ = job::load_world(outcome().scenario, {}, budget);
  }

  [[nodiscard]] std::set<std::string> behaviours(
      const std::vector<std::string>& features, std::vector<std::size_t> awareness::Judgement::*which) const {
    const auto& catalogue = world_.knowledge.catalogue;
    awareness::Observation seen;
    for (const std::string& feature : features)
      seen.seen.push_back(catalogue.feature(awareness::Name(feature)));
    const awareness::Judge judge(catalogue, {true, {}});
    const awareness::Judgement found = judge(seen);
    std::set<std::string> names;
    for (const std::size_t b : found.*which) names.insert(catalogue.behaviours[b].atom);
    return names;
  }

 private:
  job::World world_;
};

TEST(Policies, ActEarlyWithoutGuessing) {
  using awareness::Judgement;
  const Seen seen;
  const auto early = seen.behaviours({"sign", "hasMainColour Red"}, &Judgement::common);
  EXPECT_TRUE(early.contains("slow_down"));
  EXPECT_FALSE(early.contains("halt"));
  EXPECT_TRUE(seen.behaviours({"sign", "hasMainColour Red"}, &Judgement::brave).contains("halt"));
  EXPECT_TRUE(seen.behaviours({"hasShape Octagon"}, &Judgement::common).contains("halt"));
  EXPECT_FALSE(seen.behaviours({"hasShape Octagon"}, &Judgement::cautious).contains("halt"));
}

}  // namespace
}  // namespace case_study
