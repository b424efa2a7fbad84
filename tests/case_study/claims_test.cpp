// The two claims of the paper: refinement by a tree is a special case of awareness, and no assumption on the
// dynamics of what is perceived is needed.
#include "workshop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace case_study {
namespace {

constexpr unsigned never = 99;

/// One machine from disk, stepped by hand.
class Driver {
 public:
  explicit Driver(model::Mealy machine) : machine_(std::move(machine)) {
    for (std::size_t i = 0; i < machine_.outputs.size(); ++i) {
      if (machine_.outputs[i].variable.name == "state") state_ = i;
      if (machine_.outputs[i].variable.name == "action") action_ = i;
    }
  }
  [[nodiscard]] const model::Mealy& machine() const { return machine_; }

  [[nodiscard]] const model::Mealy::Transition* step(std::uint32_t at,
                                                     const model::Valuation& observation) const {
    const auto letter = machine_.input_letter(observation);
    return letter ? machine_.find(at, *letter) : nullptr;
  }
  /// Does the chosen action lead to a stopping state? Only `go` leads to a moving one.
  [[nodiscard]] bool stops(const model::Mealy::Transition& row) const {
    const model::Valuation& answer = machine_.output_letters[row.output];
    return machine_.outputs[action_].variable.domain.print(answer[action_]) != "go";
  }

 private:
  model::Mealy machine_;
  std::size_t state_ = 0, action_ = 0;
};

/// All observations with `red | octagon -> sign`, over (sign, red, octagon, stop_sign).
std::vector<model::Valuation> legal_observations() {
  std::vector<model::Valuation> all;
  for (int bits = 0; bits < 16; ++bits) {
    const int sign = bits & 1, red = bits >> 1 & 1, octagon = bits >> 2 & 1, whole = bits >> 3;
    if (sign == 1 || (red == 0 && octagon == 0)) all.push_back({sign, red, octagon, whole});
  }
  return all;
}

/// Several machines on the same observations, and when each first stops.
class Race {
 public:
  Race(const Driver& favourite, std::vector<const Driver*> others)
      : favourite_(favourite), others_(std::move(others)) {}

  /// Every sequence of \p length observations after the blank one.
  void run(unsigned length) {
    const model::Valuation blank(4, 0);
    Position start{0, std::vector<std::uint32_t>(others_.size(), 0), never,
                   std::vector<unsigned>(others_.size(), never)};
    go_on(advance(start, blank, 0), 1, length);
  }
  [[nodiscard]] std::uint64_t sequences() const { return sequences_; }
  [[nodiscard]] std::uint64_t strictly_earlier(std::size_t other) const { return earlier_[other]; }

 private:
  struct Position {
    std::uint32_t favourite;
    std::vector<std::uint32_t> others;
    unsigned favourite_stops;
    std::vector<unsigned> others_stop;
  };

  Position advance(const Position& at, const model::Valuation& observation, unsigned now) {
    Position next = at;
    const auto one = [&](const Driver& driver, std::uint32_t& state, unsigned& when) {
      const auto* row = driver.step(state, observation);
      if (row == nullptr) {
        ADD_FAILURE() << driver.machine().name << " has no answer";
        return;
      }
      state = row->next;
      if (when == never && driver.stops(*row)) when = now;
    };
    one(favourite_, next.favourite, next.favourite_stops);
    for (std::size_t i = 0; i < others_.size(); ++i) one(*others_[i], next.others[i], next.others_stop[i]);
    return next;
  }

  void go_on(const Position& at, unsigned now, unsigned length) {
    if (testing::Test::HasFailure()) return;
    if (now > length) return judge(at);
    for (const model::Valuation& observation : observations_)
      go_on(advance(at, observation, now), now + 1, length);
  }

  void judge(const Position& at) {
    ++sequences_;
    for (std::size_t i = 0; i < others_.size(); ++i) {
      EXPECT_LE(at.favourite_stops, at.others_stop[i]) << "later than " << others_[i]->machine().name;
      if (at.favourite_stops < at.others_stop[i]) ++earlier_[i];
    }
  }

  const Driver& favourite_;
  std::vector<const Driver*> others_;
  std::vector<model::Valuation> observations_ = legal_observations();
  std::uint64_t sequences_ = 0;
  std::vector<std::uint64_t> earlier_ = std::vector<std::uint64_t>(others_.size(), 0);
};

const char* const definition_controller =
    "[[controller]]\nname = \"definition\"\npolicy = \"definition\"\nentities = [\"StopSign\"]\n"
    "beside = true\n\n[[controller]]\nname = \"tree-or-full\"";

TEST(Claims, RefinementIsASpecialCase) {
  Example example;
  example.edit("stop-sign.toml", "[[controller]]\nname = \"tree-or-full\"", definition_controller);
  (void)run_job(example.scenario(), example.path("out"));
  const auto driver = [&](const std::string& name) {
    return Driver(read_controller(example.path("out/" + name + ".controller.json")));
  };
  const Driver awareness = driver("awareness"), tree = driver("tree"), definition = driver("definition");
  for (unsigned length = 1; length <= 5; ++length) {
    Race race(awareness, {&tree, &definition});
    race.run(length);
    EXPECT_EQ(race.sequences(), static_cast<std::uint64_t>(std::pow(10, length)));
    EXPECT_GT(race.strictly_earlier(0), 0U);
    EXPECT_GT(race.strictly_earlier(1), 0U);
  }
  // The race can be lost: base reads whole signs where awareness sees too little.
  const Driver base = driver("base");
  bool lost = false;
  const model::Valuation only_whole{0, 0, 0, 1};
  for (const Driver* each : {&base, &awareness}) {
    const auto* row = each->step(each->step(0, {0, 0, 0, 0})->next, only_whole);
    lost = lost || each->stops(*row);
  }
  EXPECT_TRUE(lost);
}

TEST(Claims, NoAssumptionOnDynamicsIsNeeded) {
  Example example;
  example.edit("stop-sign.toml", "persistent = \"location != 0\"", "# nothing persists: ");
  example.edit("stop-sign.toml", "\"G(red | octagon -> sign)\"", "# ");
  example.edit("stop-sign.toml", "\"G(stop_sign -> red | octagon)\"", "# ");
  example.edit("stop-sign.toml", "  # ,", "  #");
  const Outcome free = run_job(example.scenario(), example.path("out"));
  ASSERT_EQ(free.result.controllers.size(), 4U);
  for (const report::Controller& controller : free.result.controllers) {
    EXPECT_EQ(controller.verdict, report::Verdict::Verified) << controller.name;
    EXPECT_TRUE(controller.assumptions.empty()) << controller.assumptions.front();
    EXPECT_FALSE(controller.relies_on_broken_justice);
  }
  const spec::Gr1 spec = read_specification(example.path("out/awareness.gr1"));
  EXPECT_TRUE(spec.env_safety.empty());
  EXPECT_TRUE(spec.env_justice.empty());
  // It is the same controller that comes out when the assumptions are there: none of them is used.
  const Example plain;
  (void)run_job(plain.scenario(), plain.path("out"));
  const model::Mealy with = read_controller(plain.path("out/awareness.controller.json"));
  const model::Mealy without = read_controller(example.path("out/awareness.controller.json"));
  EXPECT_TRUE(with == without);
}

}  // namespace
}  // namespace case_study
