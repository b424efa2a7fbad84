#include <heed/export/dot.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <regex>
#include <sstream>

#include "machines.h"

namespace heed::exporter {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> split(const std::string& text, const std::string& by) {
  std::vector<std::string> parts{""};
  for (std::size_t i = 0; i < text.size();)
    if (text.compare(i, by.size(), by) == 0) {
      parts.emplace_back();
      i += by.size();
    } else {
      parts.back() += text[i++];
    }
  return parts;
}

/// One edge of the text: "  s0 -> s1 [label=\"...\\n/ ...\", style=dashed];"
struct Edge {
  std::string from, to, condition, answer;
  bool dashed = false;
};

std::vector<Edge> edges(const std::string& dot) {
  const std::regex line(
      R"re(  (\w+) -> (\w+) \[label="((?:[^"\\]|\\.)*)\\n/ ((?:[^"\\]|\\.)*)"(, style=dashed)?\];)re");
  std::vector<Edge> edges;
  std::istringstream in(dot);
  for (std::string text; std::getline(in, text);) {
    std::smatch match;
    if (text.find("->") == std::string::npos || text == "  start -> s0;") continue;
    EXPECT_TRUE(std::regex_match(text, match, line)) << text;
    if (!match.empty()) edges.push_back({match[1], match[2], match[3], match[4], match[5].matched});
  }
  return edges;
}

/// Whether a literal such as "red", "!red", "gap in -1 ... 2", "c != x" or "c in {x, y}" holds.
bool holds(const std::string& literal, const std::map<std::string, std::string>& values) {
  const std::vector<std::string> words = split(literal, " ");
  if (literal == "true") return true;
  if (words.size() == 1 && literal[0] == '!') return values.at(literal.substr(1)) == "false";
  if (words.size() == 1) return values.at(literal) == "true";
  const std::string& value = values.at(words[0]);
  if (words[1] == "=") return value == words[2];
  if (words[1] == "!=") return value != words[2];
  EXPECT_EQ(words[1], "in") << literal;
  if (words.size() == 5 && words[3] == "...")
    return std::stoi(words[2]) <= std::stoi(value) && std::stoi(value) <= std::stoi(words[4]);
  const std::string list = literal.substr(literal.find('{') + 1, literal.find('}') - literal.find('{') - 1);
  const std::vector<std::string> names = split(list, ", ");
  return std::find(names.begin(), names.end(), value) != names.end();
}

bool satisfied(const std::string& condition, const std::map<std::string, std::string>& values) {
  for (const std::string& cube : split(condition, "\\n| ")) {
    bool all = true;
    for (const std::string& literal : split(cube, " & ")) all = all && holds(literal, values);
    if (all) return true;
  }
  return false;
}

/// What the machine says, as the graph shows it: next state, visible outputs, fallback.
std::optional<Edge> expected(const Mealy& machine, const Reference& reference, std::uint32_t state,
                             const Valuation& observation) {
  const Reference::Row* row = reference.find(state, observation);
  if (row == nullptr) return std::nullopt;
  std::string answer;
  for (std::size_t i = 0; i < row->output.size(); ++i) {
    const auto& [variable, role] = machine.outputs[i];
    if (role == OutputRole::Plant || role == OutputRole::Memory) continue;
    const std::string value = variable.domain.print(row->output[i]);
    if (value == "false") continue;
    const std::string shown = role == OutputRole::Action ? value
                              : value == "true"          ? variable.name
                                                         : variable.name + " = " + value;
    answer += (answer.empty() ? "" : ", ") + shown;
  }
  return Edge{"s" + std::to_string(state), "s" + std::to_string(row->next), "", answer.empty() ? "-" : answer,
              row->fallback};
}

/// On every observation of every state exactly the right edge holds, or none where there is no row.
void check(const Mealy& machine) {
  const std::vector<Edge> drawn = edges(to_dot(machine, {1000, 100000}));
  const Reference reference(machine);
  for (std::uint32_t state = 0; state < machine.state_count(); ++state)
    for (const Valuation& observation : all_letters(machine.inputs)) {
      std::map<std::string, std::string> values;
      for (std::size_t i = 0; i < observation.size(); ++i)
        values[machine.inputs[i].name] = machine.inputs[i].domain.print(observation[i]);
      const std::optional<Edge> wanted = expected(machine, reference, state, observation);
      std::size_t taken = 0;
      for (const Edge& edge : drawn) {
        if (edge.from != "s" + std::to_string(state) || !satisfied(edge.condition, values)) continue;
        ++taken;
        ASSERT_TRUE(wanted.has_value());
        ASSERT_EQ(edge.to, wanted->to);
        ASSERT_EQ(edge.answer, wanted->answer);
        ASSERT_EQ(edge.dashed, wanted->dashed);
      }
      ASSERT_EQ(taken, wanted.has_value() ? 1U : 0U);
    }
}

TEST(Dot, ConditionsHoldForExactlyTheObservationsOfTheirEdge) {
  const std::vector<model::Output> outputs{{enumeration("action", {"go", "halt"}), OutputRole::Action},
                                           {boolean("recognised_stop"), OutputRole::Recognised},
                                           {enumeration("car", {"M1", "M0"}), OutputRole::Plant},
                                           {boolean("level"), OutputRole::Memory}};
  const std::vector<Variable> inputs{boolean("a"), enumeration("c", {"x", "y", "z", "w"}),
                                     integer("n", -2, 2), boolean("b")};
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    check(random_machine({"random", inputs, outputs, 1 + static_cast<std::uint32_t>(seed % 4), 0,
                          static_cast<std::uint32_t>(seed % 5), static_cast<std::uint32_t>(seed % 3)},
                         seed));
    if (HasFatalFailure()) return;
  }
}

TEST(Dot, TwoOfThreeIsWrittenAsThreeCubes) {
  const std::vector<Variable> inputs{boolean("sign"), boolean("red"), boolean("octagon")};
  model::MealyBuilder builder("awareness", inputs, {{boolean("detected"), OutputRole::Recognised}});
  builder.add_state();
  for (const Valuation& seen : all_letters(inputs))
    builder.add(0, seen, {seen[0] + seen[1] + seen[2] >= 2 ? 1 : 0}, 0);
  const std::string dot = to_dot(builder.finish());
  const std::vector<Edge> drawn = edges(dot);
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_EQ(drawn[0].answer, "-");
  EXPECT_EQ(split(drawn[1].condition, "\\n| ").size(), 3U) << dot;
  for (const char* cube : {"sign & red", "sign & octagon", "red & octagon"})
    EXPECT_THAT(split(drawn[1].condition, "\\n| "), ::testing::Contains(cube));
}

TEST(Dot, EscapesWhatGraphvizWouldRead) {
  model::MealyBuilder builder("a\"b\\N", {boolean("x\"]; evil [label=\"")},
                              {{enumeration("action", {"&lt;\n", "b"}), OutputRole::Action}});
  builder.add_state();
  builder.add(0, {1}, {0}, 0);
  const std::string dot = to_dot(builder.finish());
  EXPECT_THAT(dot, HasSubstr("digraph \"a\\\"b\\\\N\" {"));
  EXPECT_THAT(dot, HasSubstr("label=\"x\\\"]; evil [label=\\\"\\n/ &amp;lt; \"];"));
  EXPECT_EQ(edges(dot).size(), 1U);
}

TEST(Dot, ALargeMachineIsCutAndSaysSo) {
  const Mealy machine = random_machine({"large", {boolean("a")}, {}, 500, 0, 0, 0}, 4);
  const std::string dot = to_dot(machine, {20, 8});
  EXPECT_THAT(dot, HasSubstr("note: only the first 20 of 500 states are drawn"));
  EXPECT_THAT(dot, HasSubstr("more [shape=box, style=dashed, label=\"480 more states\"]"));
  EXPECT_THAT(dot, HasSubstr("s19 ["));
  EXPECT_THAT(dot, Not(HasSubstr("s20")));
  EXPECT_LE(edges(dot).size(), 40U);
}

TEST(Dot, LongConditionsAreCounted) {
  const std::vector<Variable> inputs{boolean("a"), boolean("b"), boolean("c"), boolean("d"), boolean("e")};
  model::MealyBuilder parity("parity", inputs, {{boolean("odd"), OutputRole::Output}});
  parity.add_state();
  for (const Valuation& seen : all_letters(inputs))
    parity.add(0, seen, {(seen[0] + seen[1] + seen[2] + seen[3] + seen[4]) % 2}, 0);
  EXPECT_THAT(to_dot(parity.finish(), {10, 6}), HasSubstr("\\n| 10 more\\n/ odd"));
}

TEST(Dot, ManyObservationsStayCheap) {
  const Mealy machine = random_machine({"many",
                                        {integer("a", 0, 99), integer("b", 0, 99)},
                                        {{integer("y", 0, 9), OutputRole::Output}},
                                        2,
                                        0,
                                        0,
                                        0},
                                       3);
  EXPECT_THAT(to_dot(machine), HasSubstr(" more\\n/ y = "));
  const Mealy uniform =
      random_machine({"uniform", {integer("a", 0, 99), integer("b", 0, 99)}, {}, 1, 0, 0, 0}, 3);
  EXPECT_THAT(to_dot(uniform), HasSubstr("10000 observations"));
}

}  // namespace
}  // namespace heed::exporter
