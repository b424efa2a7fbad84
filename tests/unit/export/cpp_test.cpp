#include <heed/export/cpp.h>
#include <heed/util/diagnostic.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cpp_driver.h"

namespace heed::exporter {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<model::Output> go_or_halt{{enumeration("action", {"go", "halt"}), OutputRole::Action},
                                            {boolean("recognised_stop"), OutputRole::Recognised}};

/// Inputs and outputs whose names and texts do their worst.
Sample nasty() {
  Mealy machine;
  model::MealyBuilder builder(
      "new",
      {{"class",
        Domain::enumeration({"true", "a b", "a_b", "a-b", "", "segnale à", "9", "a\"\\?\?/\n"}),
        "ends with \\",
        {}},
       {"Class", Domain::boolean(), "*/ \?\?/", {}},
       {"status", Domain::enumeration({"Status", "INT8_MAX"}), "two\nlines\x01\xff \u202e", {}},
       {"__x", Domain::boolean(), "", {}}},
      {{enumeration("状態", {"状", "態"}), OutputRole::Plant},
       {enumeration("observation", {"linux", "and", "EOF"}), OutputRole::Action},
       {boolean("Observation"), OutputRole::Output},
       {boolean("reaction_"), OutputRole::Output},
       {integer("int", -129, 5), OutputRole::Memory}});
  builder.add_state();
  for (std::int32_t value = 0; value < 8; ++value)
    builder.add(0, {value, 1, value % 2, 0}, {value % 2, value % 3, 1, 0, value - 129}, 0);
  builder.add_assumption("G !(a & \\");
  builder.add_note("\xc3(\\\n#error");
  machine = builder.finish();
  return {std::move(machine),
          "new_controller",
          {"class_", "Class_2", "status", "x"},
          {"value", "observation", "Observation_3", "reaction", "int_"}};
}

std::vector<Sample> samples() {
  const auto random = [](const Shape& shape, std::uint64_t seed) {
    Sample sample{random_machine(shape, seed), shape.name + "_controller"};
    sample.default_names();
    return sample;
  };
  const std::vector<Variable> small{boolean("a"), integer("gap", -3, 4),
                                    enumeration("sort", {"x", "y", "z"})};
  const std::vector<model::Output> numbers{{integer("small", -5, 5), OutputRole::Output},
                                           {integer("medium", -40000, 300), OutputRole::Output},
                                           {integer("big", 0, 70000), OutputRole::Output}};
  std::vector<Variable> many;
  for (const std::string& name : numbered("b", 70)) many.push_back(boolean(name));
  std::vector<Sample> samples{nasty()};
  samples.push_back(random({"complete", small, go_or_halt, 5, 0, 0, 0}, 1));
  samples.push_back(random({"partial", small, go_or_halt, 6, 0, 5, 0}, 2));
  samples.push_back(random({"fallback", small, go_or_halt, 6, 0, 3, 4}, 3));
  samples.push_back(random({"sparse_rows", small, numbers, 70, 0, 14, 1}, 4));
  samples.push_back(random({"many_states", {boolean("a"), boolean("b")}, numbers, 300, 0, 1, 0}, 5));
  samples.push_back(random({"many_inputs", many, go_or_halt, 3, 12, 2, 1}, 6));
  samples.push_back(random({"wide", {integer("far", -2000000, 5), boolean("a")}, go_or_halt, 3, 9, 2, 1}, 7));
  samples.push_back(random({"values256",
                            {enumeration("sort", numbered("v", 256))},
                            {{enumeration("shown", numbered("w", 300)), OutputRole::Output}},
                            2,
                            0,
                            1,
                            0},
                           8));
  samples.push_back(random({"bytes", {integer("a", 0, 255), boolean("b")}, go_or_halt, 2, 200, 1, 0}, 9));
  samples.push_back(random({"no_inputs", {}, go_or_halt, 3, 0, 0, 0}, 10));
  samples.push_back(random({"no_outputs", small, {}, 3, 0, 3, 0}, 11));
  samples.push_back(random({"no_rows", small, go_or_halt, 1, 0, 16, 0}, 12));
  return samples;
}

/// Values that stand just outside the domain of one input, where its field can hold them.
void add_outsiders(const std::vector<Variable>& inputs, util::CounterRandom& random,
                   std::vector<Valuation>& probes) {
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const Domain& domain = inputs[k].domain;
    if (domain.kind == Domain::Kind::Boolean) continue;
    if (domain.high < 255 && (domain.low >= 0 || domain.high < 127)) {
      probes.push_back(random_letter(inputs, random));
      probes.back()[k] = domain.high + 1;
      probes.push_back(probes.back());
      probes.back()[k] = domain.low >= 0 ? 255 : 127;
    }
    if (domain.low < 0 && domain.low > -128) {
      probes.push_back(random_letter(inputs, random));
      probes.back()[k] = -128;
    }
  }
}

/// Commands for the driver, and the lines that the machine's definition wants.
class Script {
 public:
  explicit Script(const Mealy& machine) : machine_(machine), reference_(machine) {
    util::CounterRandom random(17, 3);
    std::vector<Valuation> probes = machine.input_letters;
    for (int i = 0; i < 12; ++i) probes.push_back(random_letter(machine.inputs, random));
    add_outsiders(machine.inputs, random, probes);
    for (const auto& [state, word] : reference_.words())
      for (const Valuation& probe : probes) {
        reset();
        for (const Valuation& observation : word) step(observation);
        step(probe);
        step(probes[random.below(static_cast<std::uint32_t>(probes.size()))]);
      }
  }
  std::string commands, expected;

 private:
  void reset() {
    commands += "R\n";
    state_ = 0;
    reaction_.clear();
    for (const model::Output& output : machine_.outputs) reaction_.push_back(output.variable.domain.low);
  }
  void step(const Valuation& observation) {
    commands += "S";
    for (const std::int32_t value : observation) commands += " " + std::to_string(value);
    commands += "\n";
    const Reference::Row* row = reference_.find(state_, observation);
    if (row != nullptr) {
      state_ = row->next;
      reaction_ = row->output;
    }
    expected += row == nullptr ? "2" : row->fallback ? "1" : "0";
    for (std::size_t i = 0; i < reaction_.size(); ++i) {
      const Domain& domain = machine_.outputs[i].variable.domain;
      const bool named = domain.kind == Domain::Kind::Enumeration;
      expected += " " + (named ? domain.print(reaction_[i]) : std::to_string(reaction_[i]));
    }
    expected += "\n";
  }

  const Mealy& machine_;
  Reference reference_;
  std::uint32_t state_ = 0;
  Valuation reaction_;
};

TEST(Cpp, CompiledControllersDoWhatTheMachineSaysOnAllReachableTransitions) {
  const std::string flags = " -std=c++17 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror ";
  const std::vector<Sample> machines = samples();
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < machines.size(); ++i)
    folder.write(fmt::format("m{}.h", i), to_cpp(machines[i].machine));
  folder.write("main.cpp", driver(machines));
  const std::string source = folder.path("main.cpp");
  ASSERT_EQ(shell("g++ -fsyntax-only" + flags + source), 0);
  ASSERT_EQ(shell("g++ -fno-exceptions -fno-rtti -fsanitize=undefined -fno-sanitize-recover=all" + flags +
                  source + " -o " + folder.path("run")),
            0);
  if (shell("command -v clang++-16 > /dev/null") == 0) {
    EXPECT_EQ(shell("clang++-16 -fsyntax-only" + flags + source), 0);
    EXPECT_EQ(shell("clang++-16 -fsyntax-only -fno-exceptions -fno-rtti" + flags + source), 0);
  } else {
    std::cout << "clang++-16 is not there: compiled by g++ alone\n";
  }
  for (std::size_t i = 0; i < machines.size(); ++i) {
    SCOPED_TRACE(machines[i].name_space);
    const Script script(machines[i].machine);
    folder.write("in", script.commands);
    ASSERT_EQ(
        shell(fmt::format("{} {} < {} > {}", folder.path("run"), i, folder.path("in"), folder.path("out"))),
        0);
    EXPECT_TRUE(folder.read("out") == script.expected);
    EXPECT_GT(script.expected.size(), 20U);
  }
}

TEST(Cpp, NeedsNothingButIntegers) {
  for (const Sample& sample : samples()) {
    const std::string code = to_cpp(sample.machine);
    EXPECT_THAT(code, HasSubstr("#include <cstdint>\n"));
    EXPECT_EQ(code.find("#include", code.find("#include") + 1), std::string::npos);
    EXPECT_THAT(code, Not(HasSubstr("std::string")));
    EXPECT_EQ(code, to_cpp(sample.machine));
  }
}

TEST(Cpp, SaysWhatItIsAndWhatItReliesOn) {
  Mealy machine = samples()[3].machine;
  machine.assumptions = {"G (red -> sign)"};
  machine.notes = {"wins with its assumptions"};
  machine.inputs[1].comment = "metres to the thing ahead";
  const std::string code = to_cpp(machine, {"acme::car"});
  EXPECT_THAT(code, HasSubstr("// The controller \"fallback\", written by heed: 6 states"));
  EXPECT_THAT(code, HasSubstr("//   G (red -> sign)\n"));
  EXPECT_THAT(code, HasSubstr("//   wins with its assumptions\n"));
  EXPECT_THAT(code, HasSubstr("std::int8_t gap = -3;  // -3 ... 4; metres to the thing ahead\n"));
  EXPECT_THAT(code, HasSubstr("namespace acme::car {"));
  EXPECT_THAT(code, HasSubstr("#ifndef ACME_CAR_H"));
}

TEST(Cpp, RefusesANamespaceThatIsNone) {
  const Mealy machine = samples()[1].machine;
  for (const char* wrong : {"1", "a b", "a::", "::a", "a:b", "new", "std", "a__b", "a;}", "std::x", "_A"})
    EXPECT_THROW((void)to_cpp(machine, {wrong}), util::InputError) << wrong;
  for (const char* right : {"a", "a::b", "heed::car_2"}) EXPECT_NO_THROW((void)to_cpp(machine, {right}));
}

}  // namespace
}  // namespace heed::exporter
