#include <heed/check/verify.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>

#include "unit/check/replay.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <functional>

namespace heed::check {
namespace {

using Kind = Refutation::Kind;

/// A door that opens for whoever waits, one after the other; `turn` remembers the last step.
constexpr const char* door_text = R"(
[options]
name = door
[input]
left : boolean
right : boolean
[output]
@action open : {none, l, r}
[memory]
was_open : boolean = false
was_open' = open != none
[define]
both := left & right
[env init]
!left & !right
[env safety]
left & open != l -> left'
right & open != r -> right'
[env justice]
!left | !right
[sys init]
open = none
[sys safety]
open = l -> left
open = r -> right
was_open -> open = none
[sys justice]
!left | open = l
!right | open = r
)";

spec::Gr1 read(const std::string& text) {
  return spec::read_gr1(util::SourceText("door.gr1", text));
}

struct Row {
  std::uint32_t state;
  model::Valuation input, output;
  std::uint32_t next;
};
using Rows = std::vector<Row>;

model::Mealy build(const spec::Gr1& spec, std::uint32_t states, const Rows& rows) {
  model::MealyBuilder builder("hand", spec.inputs, spec::controller_outputs(spec));
  for (std::uint32_t i = 0; i < states; ++i) builder.add_state();
  for (const Row& row : rows) builder.add(row.state, row.input, row.output, row.next);
  return builder.finish();
}

/// States: 0 start, 1 was closed and left's turn, 2 was closed and right's turn, 3/4 was open (then
/// left's/right's turn). Columns: open, was_open, both.
Rows door_rows() {
  Rows rows{{0, {0, 0}, {0, 0, 0}, 1}};
  for (std::int32_t left = 0; left < 2; ++left)
    for (std::int32_t right = 0; right < 2; ++right) {
      const std::int32_t both = left & right;
      const auto decide = [&](bool left_first) {
        const std::int32_t open = left_first ? (left ? 1 : right ? 2 : 0) : (right ? 2 : left ? 1 : 0);
        const std::uint32_t next = open == 1 ? 4U : open == 2 ? 3U : (left_first ? 1U : 2U);
        rows.push_back({left_first ? 1U : 2U, {left, right}, {open, 0, both}, next});
      };
      decide(true);
      decide(false);
      rows.push_back({3, {left, right}, {0, 1, both}, 1});
      rows.push_back({4, {left, right}, {0, 1, both}, 2});
    }
  return rows;
}

Verdict check(const Rows& rows, const std::string& text = door_text, std::uint32_t states = 5) {
  const spec::Gr1 spec = read(text);
  util::Budget budget;
  return verify(build(spec, states, rows), spec, budget);
}

Row& row_of(Rows& rows, std::uint32_t state, const model::Valuation& input) {
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const Row& r) { return r.state == state && r.input == input; });
}

void erase(Rows& rows, std::uint32_t state, const model::Valuation& input) {
  std::erase_if(rows, [&](const Row& r) { return r.state == state && r.input == input; });
}

struct Break {
  const char* what;
  std::function<void(Rows&)> change;
  Kind kind;
  const char* clause = nullptr;
};

void expect_refused(const Break& b) {
  SCOPED_TRACE(b.what);
  Rows rows = door_rows();
  b.change(rows);
  const spec::Gr1 spec = read(door_text);
  const model::Mealy machine = build(spec, 6, rows);
  util::Budget budget;
  const Verdict verdict = verify(machine, spec, budget);
  EXPECT_FALSE(verdict.verified);
  ASSERT_EQ(verdict.refutations.size(), 1U);
  EXPECT_EQ(verdict.refutations[0].kind, b.kind) << verdict.refutations[0].message;
  if (b.clause) {
    EXPECT_EQ(verdict.refutations[0].clause, b.clause);
  }
  naive::replay(machine, spec, verdict.refutations[0]);
}

TEST(Verify, accepts_the_door) {
  const Verdict verdict = check(door_rows());
  EXPECT_TRUE(verdict.verified) << (verdict.refutations.empty()
                                        ? ""
                                        : verdict.refutations[0].message + verdict.refutations[0].clause);
  EXPECT_FALSE(verdict.relies_on_broken_justice);
  EXPECT_GT(verdict.product_states, 5U);
}

TEST(Verify, refuses_five_broken_safeties) {
  const std::vector<Break> breaks{{"opens left for nobody",
                                   [](Rows& r) {
                                     row_of(r, 1, {0, 0}).output[0] = 1;
                                     row_of(r, 1, {0, 0}).next = 4;
                                   },
                                   Kind::Safety, "open = l -> left"},
                                  {"opens right for nobody",
                                   [](Rows& r) {
                                     row_of(r, 2, {1, 0}).output[0] = 2;
                                     row_of(r, 2, {1, 0}).next = 3;
                                   },
                                   Kind::Safety, "open = r -> right"},
                                  {"opens twice in a row",
                                   [](Rows& r) {
                                     row_of(r, 3, {1, 0}).output[0] = 1;
                                     row_of(r, 3, {1, 0}).next = 4;
                                   },
                                   Kind::Safety, "was_open -> open = none"},
                                  {"opens twice the other way",
                                   [](Rows& r) {
                                     row_of(r, 4, {1, 1}).output[0] = 2;
                                     row_of(r, 4, {1, 1}).next = 3;
                                   },
                                   Kind::Safety, "was_open -> open = none"},
                                  {"the wrong one",
                                   [](Rows& r) {
                                     row_of(r, 1, {1, 0}).output[0] = 2;
                                     row_of(r, 1, {1, 0}).next = 3;
                                   },
                                   Kind::Safety, "open = r -> right"}};
  for (const Break& b : breaks) expect_refused(b);
}

TEST(Verify, refuses_four_missing_inputs) {
  const std::vector<Break> breaks{{"first",
                                   [](Rows& r) {
                                     erase(r, 0, {0, 0});
                                   },
                                   Kind::MissingInput},
                                  {"second",
                                   [](Rows& r) {
                                     erase(r, 1, {1, 1});
                                   },
                                   Kind::MissingInput},
                                  {"deep",
                                   [](Rows& r) {
                                     erase(r, 4, {0, 1});
                                   },
                                   Kind::MissingInput},
                                  {"right first",
                                   [](Rows& r) {
                                     erase(r, 2, {1, 1});
                                   },
                                   Kind::MissingInput}};
  for (const Break& b : breaks) expect_refused(b);
}

TEST(Verify, refuses_six_broken_justices) {
  const auto stay_shut = [](std::uint32_t state, const model::Valuation& input) {
    return [=](Rows& r) {
      row_of(r, state, input).output[0] = 0;
      row_of(r, state, input).next = state;
    };
  };
  const auto back_to_left = [](Rows& r) {
    for (Row& row : r)
      if (row.state == 4) row.next = 1;
  };
  const auto back_to_right = [](Rows& r) {
    for (Row& row : r)
      if (row.state == 3) row.next = 2;
  };
  const std::vector<Break> breaks{
      {"never left alone", stay_shut(1, {1, 0}), Kind::Justice, "!left | open = l"},
      {"never right alone", stay_shut(2, {0, 1}), Kind::Justice, "!right | open = r"},
      {"never right on left's turn", stay_shut(1, {0, 1}), Kind::Justice, "!right | open = r"},
      {"never left on right's turn", stay_shut(2, {1, 0}), Kind::Justice, "!left | open = l"},
      {"left comes again and again", [&](Rows& r) { back_to_left(r); }, Kind::Justice, "!right | open = r"},
      {"right comes again and again",
       [&](Rows& r) {
         back_to_right(r);
         row_of(r, 0, {0, 0}).next = 2;
       },
       Kind::Justice, "!left | open = l"}};
  for (const Break& b : breaks) expect_refused(b);
}

TEST(Verify, refuses_three_broken_starts) {
  const std::vector<Break> breaks{{"starts open",
                                   [](Rows& r) {
                                     r[0].output = {1, 0, 0};
                                     r[0].next = 4;
                                   },
                                   Kind::Initial, "open = none"},
                                  {"memory starts high",
                                   [](Rows& r) {
                                     r[0].output = {0, 1, 0};
                                   },
                                   Kind::WrongColumn, "was_open"},
                                  {"definition starts high",
                                   [](Rows& r) {
                                     r[0].output = {0, 0, 1};
                                   },
                                   Kind::WrongColumn, "both"}};
  for (const Break& b : breaks) expect_refused(b);
}

TEST(Verify, refuses_a_start_against_sys_init) {
  // An output without other rules than the start's; `start` also stands for a plant with two initial states.
  const std::string text =
      "[input]\na : boolean\n[output]\ny : 0..3\n[memory]\n@plant p : {u, v, w} = u, v\np' = w when p = "
      "u\n[sys init]\ny = 2\n";
  const auto verdict = [&](std::int32_t y, std::int32_t p, std::int32_t then) {
    return check({{0, {0}, {y, p}, 1}, {0, {1}, {y, p}, 1}, {1, {0}, {0, then}, 1}, {1, {1}, {0, then}, 1}},
                 text, 2);
  };
  EXPECT_TRUE(verdict(2, 0, 2).verified);
  EXPECT_TRUE(verdict(2, 1, 1).verified);
  EXPECT_EQ(verdict(1, 0, 2).refutations.at(0).kind, Kind::Initial);
  EXPECT_EQ(verdict(2, 2, 2).refutations.at(0).kind, Kind::Initial);
  EXPECT_EQ(verdict(2, 0, 1).refutations.at(0).kind, Kind::WrongColumn);
}

TEST(Verify, asks_for_a_guarantee_with_next_from_the_second_step_on) {
  // One that speaks of the reached step alone, one of both; the same letters are right at the start.
  const auto verdict = [](const char* guarantee, std::int32_t first, std::int32_t then) {
    const std::string text =
        std::string("[input]\na : boolean\n[output]\ny : 0..3\n[sys safety]\n") + guarantee;
    return check({{0, {0}, {first}, 1}, {0, {1}, {first}, 1}, {1, {0}, {then}, 1}, {1, {1}, {then}, 1}}, text,
                 2);
  };
  EXPECT_TRUE(verdict("X (y > 1)\n", 0, 2).verified);
  EXPECT_TRUE(verdict("y' >= y\n", 2, 2).verified);
  for (const auto& wrong : {verdict("X (y > 1)\n", 2, 0), verdict("y' >= y\n", 2, 1)}) {
    ASSERT_EQ(wrong.refutations.size(), 1U);
    EXPECT_EQ(wrong.refutations[0].kind, Kind::Safety);
    EXPECT_EQ(wrong.refutations[0].trace.size(), 2U);
  }
}

TEST(Verify, refuses_two_dead_ends) {
  const std::vector<Break> breaks{{"state 5 has no rows",
                                   [](Rows& r) {
                                     row_of(r, 3, {0, 0}).next = 5;
                                   },
                                   Kind::MissingInput},
                                  {"the start leads nowhere",
                                   [](Rows& r) {
                                     row_of(r, 0, {0, 0}).next = 5;
                                   },
                                   Kind::MissingInput}};
  for (const Break& b : breaks) expect_refused(b);
}

TEST(Verify, refuses_wrong_columns_later_on) {
  expect_refused({"memory",
                  [](Rows& r) {
                    row_of(r, 3, {0, 1}).output[1] = 0;
                  },
                  Kind::WrongColumn, "was_open"});
  expect_refused({"definition",
                  [](Rows& r) {
                    row_of(r, 2, {1, 1}).output[2] = 0;
                  },
                  Kind::WrongColumn, "both"});
}

TEST(Verify, ignores_rows_for_illegal_inputs) {
  Rows rows = door_rows();
  rows.push_back({0, {1, 1}, {1, 1, 0}, 5});
  EXPECT_TRUE(check(rows, door_text, 6).verified);
}

TEST(Verify, reports_as_many_refutations_as_asked_for) {
  Rows rows = door_rows();
  row_of(rows, 3, {0, 1}).output[1] = 0;
  row_of(rows, 2, {1, 1}).output[2] = 0;
  erase(rows, 1, {1, 1});
  const spec::Gr1 spec = read(door_text);
  util::Budget budget;
  EXPECT_GE(verify(build(spec, 5, rows), spec, budget, {10}).refutations.size(), 3U);
  EXPECT_EQ(verify(build(spec, 5, rows), spec, budget, {2}).refutations.size(), 2U);
}

TEST(Verify, refuses_columns_that_do_not_fit) {
  const spec::Gr1 spec = read(door_text);
  spec::Gr1 other = spec;
  other.definitions.clear();
  util::Budget budget;
  EXPECT_THROW(static_cast<void>(verify(build(spec, 5, door_rows()), other, budget)), util::InputError);
  other = spec;
  other.inputs.push_back({"third", model::Domain::boolean(), ""});
  EXPECT_THROW(static_cast<void>(verify(build(spec, 5, door_rows()), other, budget)), util::InputError);
}

TEST(Verify, knows_a_win_by_a_broken_assumption) {
  const std::string text =
      "[input]\na : boolean\n[output]\ny : boolean\n[env justice]\na\n[sys safety]\n!a -> !y\n[sys "
      "justice]\ny\n";
  const Verdict waits = check({{0, {0}, {0}, 0}, {0, {1}, {1}, 0}}, text, 1);
  EXPECT_TRUE(waits.verified);
  EXPECT_TRUE(waits.relies_on_broken_justice);
  const Verdict lazy = check({{0, {0}, {0}, 0}, {0, {1}, {0}, 0}}, text, 1);
  EXPECT_EQ(lazy.refutations.at(0).kind, Kind::Justice);
}

TEST(Verify, ends_obligations_where_the_machine_itself_makes_an_assumption_fail) {
  const std::string text =
      "[input]\na : boolean\n[output]\ny : boolean\n[env safety]\n!y\n[sys justice]\nfalse\n";
  EXPECT_TRUE(check({{0, {0}, {1}, 0}, {0, {1}, {1}, 0}}, text, 1).verified);
  EXPECT_FALSE(check({{0, {0}, {0}, 0}, {0, {1}, {1}, 0}}, text, 1).verified);
  EXPECT_EQ(
      check({{0, {0}, {1}, 0}, {0, {1}, {1}, 0}}, text + "[sys safety]\n!y\n", 1).refutations.at(0).kind,
      Kind::Safety);
}

TEST(Verify, takes_justice_over_steps) {
  const std::string text = "[input]\na : boolean\n[output]\ny : boolean\n[sys justice]\ny != y'\n";
  EXPECT_TRUE(
      check({{0, {0}, {0}, 1}, {0, {1}, {0}, 1}, {1, {0}, {1}, 0}, {1, {1}, {1}, 0}}, text, 2).verified);
  EXPECT_FALSE(
      check({{0, {0}, {0}, 1}, {0, {1}, {0}, 1}, {1, {0}, {1}, 1}, {1, {1}, {1}, 1}}, text, 2).verified);
}

TEST(Verify, distinguishes_the_initial_quantifiers) {
  const std::string body = "[input]\na : boolean\n[output]\ny : boolean\n[sys init]\na | !y\n";
  const auto with = [&](const char* quantifiers) {
    return std::string("[options]\ninitial = ") + quantifiers + "\n" + body;
  };
  const Rows copies{{0, {0}, {0}, 0}, {0, {1}, {1}, 0}}, constant{{0, {0}, {0}, 0}, {0, {1}, {0}, 0}};
  EXPECT_TRUE(check(copies, with("forall-exists"), 1).verified);
  EXPECT_EQ(check(copies, with("exists-forall"), 1).refutations.at(0).kind, Kind::Initial);
  EXPECT_TRUE(check(constant, with("exists-forall"), 1).verified);
  const Rows partial{{0, {1}, {0}, 1}, {1, {0}, {0}, 1}, {1, {1}, {0}, 1}};
  EXPECT_EQ(check(partial, with("forall-exists"), 2).refutations.at(0).kind, Kind::MissingInput);
  EXPECT_TRUE(check(partial, with("exists-exists"), 2).verified);
  EXPECT_EQ(check({}, with("exists-exists"), 1).refutations.at(0).kind, Kind::Initial);
}

TEST(Verify, a_moore_machine_may_not_look_at_the_input_of_its_step) {
  const std::string text =
      "[options]\ntiming = moore\n[input]\na : boolean\n[output]\ny : boolean\n[define]\nd := a & y\n";
  EXPECT_TRUE(check({{0, {0}, {1, 0}, 0}, {0, {1}, {1, 1}, 0}}, text, 1).verified);
  EXPECT_FALSE(check({{0, {0}, {0, 0}, 0}, {0, {1}, {1, 1}, 0}}, text, 1).verified);
}

/// `y` says now whether an odd number of inputs is true, and `z` one step later: of states 0 (start), 1 (it
/// was even) and 2 (odd).
Rows parity_rows(std::uint32_t inputs) {
  Rows rows;
  for (std::uint32_t state = 0; state < 3; ++state)
    for (std::uint32_t bits = 0; bits < 1U << inputs; ++bits) {
      model::Valuation input(inputs);
      for (std::uint32_t i = 0; i < inputs; ++i) input[i] = static_cast<std::int32_t>(bits >> i & 1U);
      const std::int32_t odd = std::popcount(bits) % 2, was_odd = state == 2 ? 1 : 0;
      rows.push_back({state, input, {odd, was_odd}, odd == 1 ? 2U : 1U});
    }
  return rows;
}

TEST(Verify, rules_of_any_width_are_looked_up_or_run) {
  for (std::uint32_t inputs = 1; inputs <= 8; ++inputs) {
    std::string text = "[input]\n", odd = "false";
    for (std::uint32_t i = 0; i < inputs; ++i) {
      text += fmt::format("a{} : boolean\n", i);
      odd = fmt::format("!({} <-> a{})", odd, i);
    }
    const std::string both = fmt::format("[sys safety]\ny <-> {0}\n{0} <-> z'\n", odd);
    SCOPED_TRACE(text += "[output]\ny : boolean\nz : boolean\n[sys init]\n!z\n" + both);
    Rows rows = parity_rows(inputs);
    EXPECT_TRUE(check(rows, text, 3).verified);
    for (Row& row : rows)
      for (std::int32_t& value : row.output) {
        value = 1 - value;
        EXPECT_FALSE(check(rows, text, 3).verified);
        value = 1 - value;
      }
  }
}

}  // namespace
}  // namespace heed::check
