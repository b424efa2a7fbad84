// The controllers on disk keep the specifications on disk, says `heed verify`; broken by hand they do not,
// and random mutations are judged as an enumeration of the prose judges them.
#include "workshop.h"

#include <heed/check/verify.h>
#include <heed/util/random.h>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

namespace case_study {
namespace {

using Kind = check::Refutation::Kind;
using Row = model::Mealy::Transition;

/// A car that may also stand still where it is: only then can it forget to go on.
void may_wait(Example& example) {
  std::string waits;
  for (const char* state : {"M4", "M3", "M2", "M1", "M0"})
    waits += std::string(state) + " -wait-> " + state + "\n";
  example.edit("car.fts", "M4 -go-> M3\n", waits + "M4 -go-> M3\n");
}

struct Made {
  model::Mealy machine;
  spec::Gr1 spec;
};

std::size_t column(const model::Mealy& machine, const std::string& name) {
  for (std::size_t i = 0; i < machine.outputs.size(); ++i)
    if (machine.outputs[i].variable.name == name) return i;
  throw std::runtime_error("no column " + name);
}

std::string value(const model::Mealy& machine, const Row& row, const std::string& name) {
  const std::size_t c = column(machine, name);
  return machine.outputs[c].variable.domain.print(machine.output_letters[row.output][c]);
}

/// Changes one column of one row; the letters are interned anew.
void set(model::Mealy& machine, std::size_t row, const std::string& name, const std::string& text) {
  const std::size_t c = column(machine, name);
  model::Valuation letter = machine.output_letters[machine.transitions[row].output];
  letter[c] = *machine.outputs[c].variable.domain.read(text);
  machine.output_letters.push_back(letter);
  machine.transitions[row].output = static_cast<std::uint32_t>(machine.output_letters.size() - 1);
}

void erase(model::Mealy& machine, std::size_t row) {
  machine.transitions.erase(machine.transitions.begin() + static_cast<std::ptrdiff_t>(row));
  for (std::uint32_t& first : machine.first)
    if (first > row) --first;
}

/// The rows along a run on \p observations from the start, as indices.
std::vector<std::size_t> rows_along(const model::Mealy& machine,
                                    const std::vector<model::Valuation>& observations) {
  std::vector<std::size_t> rows;
  std::uint32_t state = 0;
  for (const model::Valuation& observation : observations) {
    const Row* row = machine.find(state, *machine.input_letter(observation));
    rows.push_back(static_cast<std::size_t>(row - machine.transitions.data()));
    state = row->next;
  }
  return rows;
}

const model::Valuation blank{0, 0, 0, 0}, sign{1, 0, 0, 0}, everything{1, 1, 1, 1};

void expect_refused(const Made& made, const model::Mealy& broken, std::set<Kind> kinds,
                    const std::string& what) {
  util::Budget budget;
  const check::Verdict verdict = check::verify(broken, made.spec, budget);
  EXPECT_FALSE(verdict.verified) << what;
  ASSERT_EQ(verdict.refutations.size(), 1U) << what;
  EXPECT_EQ(kinds.count(verdict.refutations[0].kind), 1U)
      << what << ": " << verdict.refutations[0].message << static_cast<int>(verdict.refutations[0].kind);
  if (!kinds.count(Kind::Initial)) {
    EXPECT_FALSE(verdict.refutations[0].trace.empty()) << what;
  }
}

class Verify : public testing::TestWithParam<std::string> {
 protected:
  static Made make(bool waiting) {
    Example example;
    if (waiting) may_wait(example);
    (void)run_job(example.scenario(), example.path("out"));
    const std::string name = example.path("out/" + GetParam());
    return {read_controller(name + ".controller.json"), read_specification(name + ".gr1")};
  }
};

TEST_P(Verify, WhatIsOnDisk) {
  const Example example;
  (void)run_job(example.scenario(), example.path("out"));
  const std::string name = example.path("out/" + GetParam());
  const Said said = heed_says({"verify", name + ".controller.json", name + ".gr1"});
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_TRUE(said.out.starts_with("VERIFIED\n")) << said.out;
  model::Mealy broken = read_controller(name + ".controller.json");
  const auto rows = rows_along(broken, {blank, blank});
  erase(broken, rows[1]);
  write(example.path("broken.json"), model::write_mealy(broken));
  const Said refused = heed_says({"verify", example.path("broken.json"), name + ".gr1"});
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_TRUE(refused.out.starts_with("REFUTED")) << refused.out;
}

TEST_P(Verify, BrokenSafetyIsRefused) {
  const Made made = make(false);
  const auto rows = rows_along(made.machine, {blank, blank, sign, everything, everything});
  const std::vector<std::pair<std::size_t, std::string>> faults{
      {1, "slow_down"}, {1, "hard_stop"}, {2, "hard_stop"}, {4, "go"}, {0, "slow_down"}};
  for (const auto& [at, action] : faults) {
    model::Mealy broken = made.machine;
    set(broken, rows[at], "action", action);
    expect_refused(made, broken, {Kind::Safety}, action + " at " + std::to_string(at));
  }
}

TEST_P(Verify, MissingInputsAndDeadEndsAreRefused) {
  const Made made = make(false);
  const auto rows = rows_along(made.machine, {blank, blank, sign, everything});
  for (const std::size_t row : rows) {
    model::Mealy broken = made.machine;
    erase(broken, row);
    expect_refused(made, broken, {Kind::MissingInput}, "row " + std::to_string(row));
  }
  for (const std::size_t at : {std::size_t{1}, std::size_t{3}}) {
    model::Mealy broken = made.machine;
    const std::uint32_t dead = made.machine.transitions[rows[at]].next;
    for (std::size_t count = broken.first[dead + 1] - broken.first[dead]; count > 0; --count)
      erase(broken, broken.first[dead]);
    expect_refused(made, broken, {Kind::MissingInput}, "dead end " + std::to_string(dead));
  }
}

TEST_P(Verify, WrongBeginningsAreRefused) {
  const Made made = make(false);
  for (const char* state : {"S0", "M4", "S2"}) {
    model::Mealy broken = made.machine;
    set(broken, rows_along(broken, {blank})[0], "state", state);
    expect_refused(made, broken, {Kind::Initial}, std::string("begins in ") + state);
  }
}

/// Waits for ever in \p plant: from each state there, `go` becomes `wait`, with the memory that `go` leaves.
model::Mealy waiting_in(const model::Mealy& machine, const std::string& plant, bool& changed) {
  model::Mealy broken = machine;
  const auto place = [&](std::uint32_t state, bool with_plant) {
    const Row& row = machine.transitions[machine.first[state]];
    std::string text = with_plant ? value(machine, row, "state") : "";
    for (const model::Output& output : machine.outputs)
      if (output.role == model::OutputRole::Memory) text += "/" + value(machine, row, output.variable.name);
    return text;
  };
  for (std::size_t t = 0; t < machine.transitions.size(); ++t) {
    const Row& row = machine.transitions[t];
    if (value(machine, row, "state") != plant || value(machine, row, "action") != "go") continue;
    for (std::uint32_t s = 1; s < machine.state_count(); ++s)
      if (place(s, true) == plant + place(row.next, false)) {
        set(broken, t, "action", "wait");
        broken.transitions[t].next = s;
        changed = true;
        break;
      }
  }
  return broken;
}

TEST_P(Verify, WaitingForEverIsRefused) {
  const Made made = make(true);
  util::Budget budget;
  ASSERT_TRUE(check::verify(made.machine, made.spec, budget).verified);
  for (const char* plant : {"M4", "M3", "M2", "M1"}) {
    bool changed = false;
    const model::Mealy broken = waiting_in(made.machine, plant, changed);
    ASSERT_TRUE(changed);
    expect_refused(made, broken, {Kind::Justice}, std::string("waits in ") + plant);
  }
}

INSTANTIATE_TEST_SUITE_P(Controllers, Verify, testing::Values("base", "tree", "awareness"));

}  // namespace
}  // namespace case_study
