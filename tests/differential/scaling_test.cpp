// The awareness controller as parts and cells grow: the sizes of its machines against a naive enumeration
// that knows the car and the rules of perception and nothing of games. Sizes, unlike times, are the same on
// every machine: a slip in state keys or in minimisation shows here first.
#include <gtest/gtest.h>
#include <heed/job/controller.h>
#include <heed/util/file.h>

#include <bit>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "generators/parts_scenario.h"
#include "temporary_folder.h"

namespace heed {
namespace {

struct Size {
  std::size_t states = 0, rows = 0;
  bool operator==(const Size&) const = default;
};
void PrintTo(const Size& size, std::ostream* out) {
  *out << size.states << " states, " << size.rows << " rows";
}

Size synthesized(const bench::PartsScenario& wanted) {
  const heed::test::TemporaryFolder folder;
  const auto scenario = job::read_scenario(util::read_file(bench::write_scenario(wanted, folder.path())));
  util::Budget budget;
  const job::World world = job::load_world(scenario, budget.limits(), budget);
  const job::Synthesized done = job::synthesize(job::design(scenario, world, scenario.controllers.front()),
                                                scenario.perception.on_violation, budget);
  EXPECT_TRUE(done.verdict && done.verdict->verified);
  EXPECT_EQ(done.assumptions_dropped, wanted.on_violation == "drop");
  if (!done.result.machine) return {};
  return {done.result.machine->state_count(), done.result.machine->transitions.size()};
}

/// Before a step: where the car stands, and what was seen on this approach and has to be seen again. An
/// observation is a set of bits: the sign, its parts, the whole.
struct Place {
  unsigned location = 0;
  bool stopping = false, first = false;
  unsigned seen = 0;
  auto operator<=>(const Place&) const = default;
};

class Enumeration {
 public:
  Enumeration(const bench::PartsScenario& wanted, bool assumed) : wanted_(wanted), assumed_(assumed) {
    const std::map<Place, std::size_t> start{{Place{0, false, true, 0}, 0}};
    number_ = start;
    places_.push_back(start.begin()->first);
    for (std::size_t i = 0; i < places_.size(); ++i) expand(i);
  }

  /// Of the smallest machine with these rows: blocks are split by their rows until none falls apart.
  [[nodiscard]] Size minimal() const {
    std::vector<std::size_t> block(places_.size(), 0);
    for (std::size_t count = 1;;) {
      std::map<std::vector<Row>, std::size_t> signatures;
      std::vector<std::size_t> refined;
      Size size;
      for (std::size_t i = 0; i < places_.size(); ++i) {
        std::vector<Row> rows = rows_[i];
        for (Row& row : rows) row.next = block[row.next];
        rows.push_back({0, 0, block[i]});
        const auto [at, fresh] = signatures.emplace(rows, signatures.size());
        if (fresh) size.rows += rows_[i].size();
        refined.push_back(at->second);
      }
      size.states = signatures.size();
      if (size.states == count) return size;
      count = size.states;
      block = refined;
    }
  }

 private:
  struct Row {
    unsigned observation, answer;
    std::size_t next;
    auto operator<=>(const Row&) const = default;
  };

  [[nodiscard]] bool legal(const Place& place, unsigned observation) const {
    if (!assumed_) return true;
    const unsigned sign = observation & 1U, whole = observation >> (wanted_.parts + 1);
    const unsigned parts = (observation >> 1) & ((1U << wanted_.parts) - 1);
    if (place.first && observation != 0) return false;
    return (place.seen & ~observation) == 0 && (parts == 0 || sign != 0) && (whole == 0 || parts != 0);
  }

  void expand(std::size_t from) {
    const Place place = places_[from];
    const unsigned features = (1U << (wanted_.parts + 1)) - 1;
    std::vector<Row> rows;
    for (unsigned observation = 0; observation < 1U << (wanted_.parts + 2); ++observation) {
      if (!legal(place, observation)) continue;
      const bool detected = std::popcount(observation & features) >= 2;
      const Place after{place.location == 0 ? wanted_.cells - 1 : place.location - 1, detected, false,
                        assumed_ && place.location != 0 ? observation : 0};
      const auto [at, fresh] = number_.emplace(after, places_.size());
      if (fresh) places_.push_back(after);
      rows.push_back({observation, (place.location * 2 + place.stopping) * 2 + detected, at->second});
    }
    rows_.push_back(std::move(rows));
  }

  bench::PartsScenario wanted_;
  bool assumed_;
  std::map<Place, std::size_t> number_;
  std::vector<Place> places_;
  std::vector<std::vector<Row>> rows_;
};

struct Case {
  bench::PartsScenario scenario;
  Size expected;
};

class Scaling : public ::testing::TestWithParam<Case> {};

TEST_P(Scaling, MachinesAreAsSmallAsAnEnumerationSays) {
  const auto& [scenario, expected] = GetParam();
  EXPECT_EQ(Enumeration(scenario, scenario.on_violation != "drop").minimal(), expected);
  EXPECT_EQ(synthesized(scenario), expected);
}

INSTANTIATE_TEST_SUITE_P(Parts, Scaling,
                         ::testing::Values(Case{{2, 5, "drop"}, {10, 160}}, Case{{3, 5, "drop"}, {10, 320}},
                                           Case{{4, 5, "drop"}, {10, 640}}, Case{{5, 5, "drop"}, {10, 1280}},
                                           Case{{2, 5, "undefined"}, {35, 137}},
                                           Case{{3, 5, "undefined"}, {67, 385}},
                                           Case{{4, 5, "undefined"}, {131, 1097}},
                                           Case{{5, 5, "undefined"}, {259, 3169}}));

INSTANTIATE_TEST_SUITE_P(Cells, Scaling,
                         ::testing::Values(Case{{2, 10, "drop"}, {20, 320}}, Case{{2, 20, "drop"}, {40, 640}},
                                           Case{{2, 10, "undefined"}, {75, 287}},
                                           Case{{2, 20, "undefined"}, {155, 587}}));

}  // namespace
}  // namespace heed
