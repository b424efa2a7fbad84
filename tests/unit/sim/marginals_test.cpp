#include <gtest/gtest.h>
#include <heed/sim/marginals.h>

#include "unit/sim/case_study.h"
#include "unit/sim/paths.h"

namespace heed::sim {
namespace {

using namespace case_study;

TEST(Marginals, AreTheSumsOverAllSequences) {
  for (ProfileSpec profile : {p1(), p2(), p3()}) {
    profile.misreadings = {{"octagon", "red", q("1/5"), q("0")}, {"sign", "stop_sign", q("1/9"), {}, true}};
    util::Budget budget;
    const Chain chain = compile(profile, budget);
    std::vector<std::vector<Rational>> expected(4, std::vector<Rational>(5));
    for (const auto& [reports, probability] : sequences(chain))
      for (std::size_t cell = 0; cell < reports.size(); ++cell)
        for (std::size_t f = 0; f < 4; ++f)
          if ((reports[cell] >> f & 1) != 0) expected[f][cell] += probability;
    EXPECT_EQ(reported_in_cell(chain), expected) << profile.name;
  }
}

TEST(Marginals, OfTheFirstProfileByHand) {
  util::Budget budget;
  const auto reported = reported_in_cell(compile(p1(), budget));
  EXPECT_EQ(reported[0], (std::vector<Rational>{q("1/2"), q("5/8"), q("3/4"), q("7/8"), 1}));
  EXPECT_EQ(reported[1][1], q("1/4"));
}

}  // namespace
}  // namespace heed::sim
