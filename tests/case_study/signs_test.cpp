// False braking and misses for some signs of the catalogue and for the open road. What stands here about a
// sign was read off the Vienna Convention's pictures: does it have a red main colour, an octagon, and what
// must one do there.
#include "enumeration.h"
#include "workshop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace case_study {
namespace {

struct Described {
  std::string label;
  unsigned shown;  ///< Which inputs it can raise.
  bool halt = false, give_way = false;
};

const std::vector<Described>& some_signs() {
  static const std::vector<Described> signs{{"stop", Sign | Colour | Shape | Whole, true, false},
                                            {"give way", Sign | Colour, false, true},
                                            {"no entry", Sign | Colour, true, false},
                                            {"speed limit 30", Sign | Colour},
                                            {"priority road", Sign},
                                            {"parking", Sign},
                                            {"nothing there", 0}};
  return signs;
}

const std::map<std::string, Detects>& controllers() {
  static const std::map<std::string, Detects> detects{{"base", base_detects},
                                                      {"tree", tree_detects},
                                                      {"awareness", two_of(Sign | Colour | Shape)},
                                                      {"tree-or-full", tree_or_full_detects}};
  return detects;
}

void expect_encounter(const Described& sign, const report::Encounter& found) {
  const auto where = detection(traces_of(found.profile), sign.shown, controllers().at(found.controller));
  const mpq_class missed = where[0] + where[5];
  const std::string what = sign.label + " " + found.profile + " " + found.controller;
  EXPECT_EQ(found.stop.exact, mpq_class(1 - missed).get_str()) << what;
  ASSERT_EQ(found.miss.has_value(), sign.halt) << what;
  if (sign.halt) {
    EXPECT_EQ(found.miss->exact, missed.get_str()) << what;
  }
  ASSERT_EQ(found.needless.has_value(), !sign.halt && !sign.give_way) << what;
  if (found.needless) {
    EXPECT_EQ(found.needless->exact, mpq_class(1 - where[5]).get_str()) << what;
  }
}

TEST(Signs, FalseBrakingAndMissesAreThoseOfTheProse) {
  const Example example;
  const Outcome outcome = run_job(example.scenario(), example.path("out"));
  for (const Described& sign : some_signs()) {
    const auto& all = outcome.result.catalogue;
    const auto entry =
        std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.label == sign.label; });
    ASSERT_NE(entry, all.end()) << sign.label;
    EXPECT_EQ(entry->prescribes_halt, sign.halt) << sign.label;
    EXPECT_EQ(entry->encounters.size(), 12U) << sign.label;
    for (const report::Encounter& encounter : entry->encounters) expect_encounter(sign, encounter);
  }
}

TEST(Signs, EveryLeafAndTheOpenRoadAreDrivenPast) {
  const Example example;
  const Outcome outcome = run_job(example.scenario(), example.path("out"));
  EXPECT_GE(outcome.result.catalogue.size(), 31U);
  for (const report::CatalogueEntry& entry : outcome.result.catalogue) {
    EXPECT_EQ(entry.encounters.size(), 12U) << entry.label;
    for (const report::Encounter& encounter : entry.encounters)
      if (encounter.controller == "base" && entry.label != "stop") {
        EXPECT_EQ(encounter.stop.exact, "0") << entry.label << ": it only reads stop signs";
      }
  }
}

}  // namespace
}  // namespace case_study
