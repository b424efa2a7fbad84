// Random mutations of the controllers, judged by check::verify() and by a plain enumeration of the prose:
// what the car can do, what perception keeps to, what must be answered. The two must agree on every machine.
#include "workshop.h"

#include <heed/check/verify.h>
#include <heed/util/random.h>

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

namespace case_study {
namespace {

/// Where the run stands before a step: the machine's state, the car, what was seen a step before and where.
struct Place {
  std::uint32_t state = 0;
  std::string car = "M0";
  bool begun = false, was_at_zero = true;
  int before = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};

/// The car with waiting, by the prose: nothing when the action is not possible.
std::string drive(const std::string& car, const std::string& action) {
  const int to = (car[1] - '0' + 4) % 5;
  const bool moving = car[0] == 'M';
  if (action == "go") return "M" + std::to_string(to);
  if (action == "wait") return moving ? car : "";
  if (action == "hard_stop") return car == "M1" ? "S0" : "";
  return car == "M1" ? "" : "S" + std::to_string(to);
}

class Enumeration {
 public:
  Enumeration(const model::Mealy& machine, std::string name) : machine_(machine), name_(std::move(name)) {}

  /// Does every run that perception can give keep the rules, and go round for ever?
  bool right() {
    std::vector<Place> todo{Place{}};
    std::set<Place> seen{Place{}};
    while (!todo.empty()) {
      const Place at = todo.back();
      todo.pop_back();
      for (int now = 0; now < 16; ++now) {
        if (!legal(at, now)) continue;
        Place next;
        if (!step(at, now, next)) return false;
        edges_[at].insert(next);
        if (seen.insert(next).second) todo.push_back(next);
      }
    }
    return !can_stay(true) && !can_stay(false);
  }

 private:
  /// Bits: sign, red, octagon, whole.
  static bool legal(const Place& at, int now) {
    if (!at.begun) return now == 0;
    if ((now & 6) != 0 && (now & 1) == 0) return false;
    if ((now & 8) != 0 && (now & 6) == 0) return false;
    return at.was_at_zero || (at.before & ~now) == 0;
  }

  [[nodiscard]] bool detects(const Place& at, int now) const {
    if (name_ == "base") return (now & 8) != 0;
    if (name_ == "tree") return (at.before & 1) != 0 && (now & 2) != 0;
    return (now & 1) + (now >> 1 & 1) + (now >> 2 & 1) >= 2;
  }

  bool step(const Place& at, int now, Place& next) const {
    const auto letter = machine_.input_letter({now & 1, now >> 1 & 1, now >> 2 & 1, now >> 3});
    const auto* row = letter ? machine_.find(at.state, *letter) : nullptr;
    if (row == nullptr) return false;
    const bool detected = detects(at, now), sign = (now & 1) != 0;
    std::map<std::string, bool> flags{{"reached_sign", (at.before & 1) != 0},
                                      {"recognised_sign", sign || detected},
                                      {"prescribed_slow_down", sign || detected}};
    std::string action;
    for (std::size_t c = 0; c < machine_.outputs.size(); ++c) {
      const model::Variable& variable = machine_.outputs[c].variable;
      const std::string value = variable.domain.print(machine_.output_letters[row->output][c]);
      if (variable.name == "action")
        action = value;
      else if (variable.name == "state"
                   ? value != at.car
                   : (value == "true") != flags.emplace(variable.name, detected).first->second)
        return false;
    }
    next = {row->next, drive(at.car, action), true, at.car[1] == '0', now};
    return !next.car.empty() && (next.car[0] == 'S') == detected;
  }

  /// Is there a loop that never leaves location 0, or never comes there? Places without a successor of their
  /// kind are taken away until none is left or the rest is closed.
  bool can_stay(bool at_zero) const {
    std::set<Place> left;
    for (const auto& [place, successors] : edges_)
      if ((place.car[1] == '0') == at_zero) left.insert(place);
    for (bool changed = true; changed;) {
      changed = false;
      for (auto it = left.begin(); it != left.end();) {
        bool stays = false;
        for (const Place& next : edges_.at(*it)) stays = stays || left.count(next) != 0;
        it = stays ? std::next(it) : (changed = true, left.erase(it));
      }
    }
    return !left.empty();
  }

  const model::Mealy& machine_;
  std::string name_;
  std::map<Place, std::set<Place>> edges_;
};

model::Mealy mutated(const model::Mealy& machine, util::CounterRandom& random) {
  model::Mealy out = machine;
  const auto below = [&](std::size_t n) { return random.below(static_cast<std::uint32_t>(n)); };
  const std::size_t row = below(out.transitions.size());
  switch (below(4)) {
    case 0:
      out.transitions[row].next = below(out.state_count());
      break;
    case 1:
      out.transitions[row].output = below(out.output_letters.size());
      break;
    case 2:
      out.transitions.erase(out.transitions.begin() + static_cast<std::ptrdiff_t>(row));
      for (std::uint32_t& first : out.first) first -= first > row ? 1 : 0;
      break;
    default:
      out.transitions[row].next = out.transitions[below(out.transitions.size())].next;
      out.transitions[row].output = out.transitions[below(out.transitions.size())].output;
  }
  return out;
}

TEST(Mutation, VerdictsAreThoseOfAnEnumeration) {
  Example example;
  std::string waits;
  for (const char* state : {"M4", "M3", "M2", "M1", "M0"})
    waits += std::string(state) + " -wait-> " + state + "\n";
  example.edit("car.fts", "M4 -go-> M3\n", waits + "M4 -go-> M3\n");
  (void)run_job(example.scenario(), example.path("out"));
  unsigned right = 0, wrong = 0;
  for (const std::string name : {"base", "tree", "awareness"}) {
    const model::Mealy machine = read_controller(example.path("out/" + name + ".controller.json"));
    const spec::Gr1 spec = read_specification(example.path("out/" + name + ".gr1"));
    ASSERT_TRUE(Enumeration(machine, name).right()) << name;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      util::CounterRandom random(seed, 7);
      const model::Mealy mutant = mutated(machine, random);
      const bool truth = Enumeration(mutant, name).right();
      util::Budget budget;
      EXPECT_EQ(check::verify(mutant, spec, budget).verified, truth) << name << ", seed " << seed;
      ++(truth ? right : wrong);
    }
  }
  EXPECT_GT(right, 50U) << "mutations where perception never comes do no harm";
  EXPECT_GT(wrong, 50U);
}

}  // namespace
}  // namespace case_study
