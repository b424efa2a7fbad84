#include <heed/export/exec.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <sstream>

#include "machines.h"

namespace heed::exporter {
namespace {

using namespace testing;
using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

/// The code blocks of the format's page after its heading "Example": controller, lines in, lines out.
std::vector<std::string> example_blocks() {
  const std::string page = util::read_file(std::string(HEED_SOURCE_DIR) + "/docs/formats/exec.md").text();
  std::vector<std::string> blocks;
  const std::string open = "\n```json\n";
  for (std::size_t at = page.find("## Example"); (at = page.find(open, at)) != std::string::npos;) {
    at += open.size();
    const std::size_t end = page.find("```", at);
    blocks.push_back(page.substr(at, end - at));
    at = end;
  }
  return blocks;
}

Mealy example_machine() {
  return model::read_mealy({"example", example_blocks().at(0)});
}

/// One answer, checked for what holds for every answer.
Json ask(LineExecutor& executor, const std::string& line) {
  const std::string answer = executor.line(line);
  EXPECT_EQ(answer.find('\n'), std::string::npos);
  EXPECT_TRUE(Json::accept(answer)) << answer;
  const Json json = Json::parse(answer);
  if (json.contains("reset")) {
    EXPECT_EQ(json, Json({{"reset", true}}));
    return json;
  }
  std::vector<std::string> keys, expected{"step"};
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  if (json.contains("error")) expected.insert(expected.end(), {"error", "hint"});
  expected.insert(expected.end(),
                  {"recognised", "prescribed", "action", "state", "outputs", "why", "fallback"});
  if (json["fallback"] == true) expected.emplace_back("note");
  EXPECT_EQ(keys, expected) << answer;
  if (json.contains("error")) {
    EXPECT_TRUE(json["fallback"]);
    EXPECT_FALSE(json["error"].get<std::string>().empty());
    EXPECT_FALSE(json["hint"].get<std::string>().empty()) << answer;
    EXPECT_LT(answer.size(), 2000U);
  }
  return json;
}

TEST(Exec, AnswersTheExampleOfItsPage) {
  const std::vector<std::string> blocks = example_blocks();
  ASSERT_EQ(blocks.size(), 3U);
  std::istringstream in(blocks[1]);
  std::ostringstream out;
  LineExecutor(example_machine()).run(in, out);
  EXPECT_EQ(out.str(), blocks[2]);
}

struct Wrong {
  std::string line, error, hint;
};

TEST(Exec, SaysWhatIsWrongWithALine) {
  const std::string deep(60000, '[');
  const std::vector<Wrong> wrong{
      {"", "the line is empty", "one JSON object"},
      {" \t\r", "the line is empty", ""},
      {"{\"red\": tru}", "not JSON: unexpected text at byte", ""},
      {"{\"red\": true} x", "not JSON: unexpected text at byte 15", ""},
      {"{\"red\": true}{}", "not JSON: unexpected text", ""},
      {std::string("{}\0x", 4), "a NUL byte at byte 3", ""},
      {"{\"red\": \"\xff\"}", "invalid UTF-8", ""},
      {"{\"\xc3\x28\": true}", "invalid UTF-8", ""},
      {"{\"red\": NaN}", "not JSON", ""},
      {"{\"gap\": 1e999}", "a number too large", ""},
      {"[1]", "expected an object, found an array", ""},
      {"17", "expected an object, found 17", ""},
      {"null", "expected an object, found null", ""},
      {"\"reset\"", "expected an object", ""},
      {deep, "expected an object, found an array", ""},
      {"{\"red\": " + deep, "input 'red' cannot be an array", "true or false"},
      {"{\"red\": {\"red\": true}}", "input 'red' cannot be an object", ""},
      {"{\"reed\": true}", "unknown input 'reed'", "did you mean 'red'?"},
      {"{\"" + std::string(60000, 'x') + "\": 1}", "unknown input 'xxx", "known: red, shape"},
      {"{\"red\": true, \"red\": true}", "input 'red' is given twice", ""},
      {"{\"red\": 1}", "input 'red' cannot be 1", "true or false"},
      {"{\"red\": null}", "input 'red' cannot be null", ""},
      {"{\"shape\": \"octogon\"}", "input 'shape' has no value 'octogon'", "did you mean 'octagon'?"},
      {"{\"shape\": 1}", "input 'shape' cannot be 1", "names"},
      {"{\"shape\": true}", "input 'shape' cannot be true", ""},
      {"{\"gap\": 5}", "input 'gap' cannot be 5", "an integer in -3 ... 4"},
      {"{\"gap\": -4}", "input 'gap' cannot be -4", ""},
      {"{\"gap\": 3.0}", "input 'gap' cannot be 3.0", ""},
      {"{\"gap\": 99999999999999999999}", "input 'gap' cannot be 99999999999999999999", ""},
      {"{\"gap\": 18446744073709551615}", "input 'gap' cannot be 18446744073709551615", ""},
      {"{\"gap\": \"3\"}", "input 'gap' cannot be \"3\"", ""},
      {"{\"reset\": false}", "'reset' takes nothing but true", ""},
      {"{\"reset\": 1}", "'reset' takes nothing but true", ""},
      {"{\"reset\": {}}", "'reset'", ""},
      {"{\"reset\": true, \"red\": true}", "'reset' stands beside other keys", ""},
      {"{\"red\": true, \"$reset\": true}", "'reset' stands beside other keys", ""},
      {"{\"reset\": true, \"reset\": true}", "given twice", ""},
      {"{" + std::string(LineExecutor::max_line, ' ') + "}", "longer than 65536 bytes", ""},
      {std::string(10'000'000, 'x'), "longer than 65536 bytes", ""}};
  const std::vector<Variable> inputs{boolean("red"), enumeration("shape", {"none", "triangle", "octagon"}),
                                     integer("gap", -3, 4)};
  LineExecutor executor(random_machine({"all", inputs, {}, 3, 0, 0, 0}, 1));
  for (const Wrong& w : wrong) {
    SCOPED_TRACE(w.line.substr(0, 80));
    const Json answer = ask(executor, w.line);
    ASSERT_TRUE(answer.contains("error"));
    EXPECT_THAT(answer["error"].get<std::string>(), HasSubstr(w.error));
    EXPECT_THAT(answer["hint"].get<std::string>(), HasSubstr(w.hint));
  }
  EXPECT_EQ(ask(executor, "{\"gap\": -3, \"red\": true}")["step"], wrong.size());
  EXPECT_FALSE(ask(executor, "{}").contains("error"));
  EXPECT_FALSE(ask(executor, "{" + std::string(LineExecutor::max_line - 2, ' ') + "}").contains("error"));
}

TEST(Exec, AnInputCalledResetIsAnInput) {
  LineExecutor executor(random_machine({"r", {boolean("reset")}, {}, 1, 0, 0, 0}, 1));
  EXPECT_EQ(ask(executor, "{\"reset\": true}")["step"], 0);
  EXPECT_EQ(ask(executor, "{\"reset\": false}")["step"], 1);
  EXPECT_EQ(ask(executor, "{\"$reset\": true}"), Json({{"reset", true}}));
  EXPECT_EQ(ask(executor, "{}")["step"], 0);
}

TEST(Exec, RefusesMachinesItCannotServe) {
  EXPECT_THROW(LineExecutor(Mealy{}), util::InputError);
  const auto machine = [](std::vector<Variable> inputs) {
    return random_machine({"m", std::move(inputs), {}, 1, 0, 0, 0}, 1);
  };
  EXPECT_THROW(LineExecutor(machine({boolean("a"), boolean("a")})), util::InputError);
  EXPECT_THROW(LineExecutor(machine({boolean("$reset")})), util::InputError);
}

/// The protocol by its page, for machines whose columns are: an action, a plant state, a recognised one.
class Protocol {
 public:
  explicit Protocol(const Mealy& machine) : machine_(machine), reference_(machine) {}
  void reset() { *this = Protocol(machine_); }
  /// \param observation  Nothing: the line is no observation.
  Json answer(const std::optional<Valuation>& observation) {
    Json json{{"step", step_++}, {"fallback", true}};
    const Reference::Row* row = observation ? reference_.find(state_, *observation) : nullptr;
    if (row != nullptr) {
      if (row->fallback) json["note"] = "the observation breaks an assumption";
      json["fallback"] = row->fallback;
      if (!row->fallback) legal_ = observation;
    } else {
      json["error"] = true;
      row = legal_ ? reference_.find(state_, *legal_) : nullptr;
      json["note"] = row != nullptr ? "answered as the last legal observation would be"
                     : last_        ? "the last reaction is repeated"
                                    : "there is no reaction yet";
    }
    if (row != nullptr) {
      state_ = row->next;
      last_ = row->output;
    }
    json["action"] = last_ ? Json(machine_.outputs[0].variable.domain.print((*last_)[0])) : Json();
    json["state"] = last_ ? Json((*last_)[1]) : Json();
    json["recognised"] = last_ && (*last_)[2] != 0 ? Json{"recognised_stop"} : Json::array();
    json["why"] = last_ && (*last_)[2] != 0 ? Json{"Stop: red"} : Json::array();
    return json;
  }

 private:
  Mealy machine_;
  Reference reference_;
  std::uint32_t state_ = 0;
  std::uint64_t step_ = 0;
  std::optional<Valuation> legal_, last_;
};

void compare(const Json& answer, const Json& expected) {
  for (const auto& [key, value] : expected.items()) {
    if (key == "error") continue;
    ASSERT_TRUE(answer.contains(key)) << answer;
    ASSERT_EQ(answer[key], value) << key;
  }
  ASSERT_EQ(answer.contains("error"), expected.contains("error")) << answer;
}

TEST(Exec, FollowsTheFallbacksOfItsPageOnRandomMachines) {
  const std::vector<Variable> inputs{boolean("a"), boolean("b")};
  const std::vector<model::Output> outputs{{enumeration("action", {"go", "halt"}), OutputRole::Action},
                                           {integer("place", 0, 3), OutputRole::Plant},
                                           {boolean("recognised_stop", "Stop: red"), OutputRole::Recognised}};
  std::set<std::string> notes;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Mealy machine = random_machine({"m", inputs, outputs, 4, 0, 6, 4}, seed);
    LineExecutor executor(machine);
    Protocol protocol(machine);
    util::CounterRandom random(seed, 9);
    for (int i = 0; i < 100; ++i) {
      if (random.below(20) == 0) {
        ask(executor, "{\"reset\": true}");
        protocol.reset();
        continue;
      }
      std::optional<Valuation> observation;
      std::string line = "{\"a\": maybe}";
      if (random.below(4) != 0) {
        observation = random_letter(inputs, random);
        line = "{\"b\": " + inputs[1].domain.print((*observation)[1]) + "}";
        if ((*observation)[0] != 0) line.insert(1, "\"a\": true, ");
      }
      const Json expected = protocol.answer(observation);
      compare(ask(executor, line), expected);
      if (HasFatalFailure()) return;
      if (expected.contains("note")) notes.insert(expected["note"]);
    }
  }
  EXPECT_EQ(notes.size(), 4U);
}

TEST(Exec, ShowsColumnsByTheirRoles) {
  const std::vector<model::Output> outputs{{boolean("free"), OutputRole::Output},
                                           {enumeration("go", {"a", "b"}), OutputRole::Action},
                                           {integer("two", -5, -4), OutputRole::Action},
                                           {integer("sure", 0, 9), OutputRole::Recognised},
                                           {boolean("rec", "\"why\"\n"), OutputRole::Recognised},
                                           {boolean("pre"), OutputRole::Prescribed},
                                           {boolean("level"), OutputRole::Memory}};
  model::MealyBuilder builder("m", {}, outputs);
  builder.add_state();
  builder.add(0, {}, {1, 1, -5, 7, 1, 1, 0}, 0);
  LineExecutor executor(builder.finish());
  EXPECT_EQ(executor.line("{}"),
            "{\"step\": 0, \"recognised\": [\"rec\"], \"prescribed\": [\"pre\"], \"action\": \"b\", "
            "\"state\": null, \"outputs\": {\"free\": true, \"two\": -5, \"sure\": 7, \"level\": false}, "
            "\"why\": [\"\\\"why\\\"\\n\"], \"fallback\": false}");
}

/// Whether a text that is JSON is an observation or a reset for the example, but for keys given twice.
bool is_observation(const Json& json) {
  if (!json.is_object()) return false;
  for (const auto& [key, value] : json.items()) {
    if (key == "red" && value.is_boolean()) continue;
    if (key == "shape" && (value == "none" || value == "triangle" || value == "octagon")) continue;
    if ((key == "reset" || key == "$reset") && value == true && json.size() == 1) continue;
    return false;
  }
  return true;
}

TEST(Exec, EveryHostileLineIsAnsweredAndNoBadOneIsTaken) {
  const std::vector<std::string> seeds{"{\"red\": true, \"shape\": \"octagon\"}", "{\"shape\": \"triangle\"}",
                                       "{\"red\": false}", "{\"reset\": true}", "{\"red\": [{\"x\": 1e5}]}"};
  const std::string bytes =
      std::string("{}[]\":,\\truefalsn0-+.eE/ \t\n\r") + std::string("\0\xff\xc3\x80", 4);
  LineExecutor executor(example_machine());
  std::size_t taken = 0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    util::CounterRandom random(seed, 5);
    std::string line = seeds[random.below(static_cast<std::uint32_t>(seeds.size()))];
    for (std::uint32_t n = random.below(4); n > 0; --n) {
      const char byte = bytes[random.below(static_cast<std::uint32_t>(bytes.size()))];
      const std::uint32_t at = random.below(static_cast<std::uint32_t>(line.size()));
      if (random.below(2) == 0)
        line[at] = byte;
      else
        line.insert(at, 1, byte);
    }
    const Json answer = ask(executor, line);
    if (HasFailure()) FAIL() << line;
    const bool error = answer.contains("error");
    const bool right =
        line.find('\0') == std::string::npos && Json::accept(line) && is_observation(Json::parse(line));
    const std::string what = error ? answer["error"].get<std::string>() : "";
    ASSERT_EQ(error && what.find("no row") == std::string::npos && what.find("twice") == std::string::npos,
              !right)
        << line << "\n"
        << answer;
    taken += right ? 1 : 0;
  }
  EXPECT_GT(taken, 1000U);
}

TEST(Exec, OneLineOutPerLineIn) {
  const std::string text =
      "{}\r\n\n" + std::string(200'000, 'y') + "\n{}" + std::string(65'535, ' ') + "\n{\"red\": true}\n{}";
  std::istringstream in(text);
  std::ostringstream out;
  LineExecutor(example_machine()).run(in, out);
  std::vector<std::string> kinds;
  std::istringstream lines(out.str());
  for (std::string line; std::getline(lines, line);) {
    const Json json = Json::parse(line);
    EXPECT_EQ(json["step"], kinds.size());
    kinds.push_back(json.contains("error") ? json["error"].get<std::string>() : "");
  }
  ASSERT_EQ(kinds.size(), 6U);
  EXPECT_THAT(kinds, ::testing::ElementsAre("", HasSubstr("empty"), HasSubstr("longer"), HasSubstr("longer"),
                                            "", ""));
  std::istringstream nothing("");
  std::ostringstream silence;
  LineExecutor(example_machine()).run(nothing, silence);
  EXPECT_EQ(silence.str(), "");
}

}  // namespace
}  // namespace heed::exporter
