#pragma once

// Compiles generated headers with the system's compilers, together with a driver that reads commands
// ("R": reset, "S 0 1 2": step on these values) and prints one line per step: status, then the reaction.

#include <heed/export/cpp.h>

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "machines.h"
#include "temporary_folder.h"

namespace heed::exporter::testing {

using heed::test::TemporaryFolder;

/// A machine, and the names that its code must have. Empty: those of its variables.
struct Sample {
  Mealy machine;
  std::string name_space;
  std::vector<std::string> inputs{}, outputs{};

  void default_names() {
    if (inputs.empty())
      for (const Variable& input : machine.inputs) inputs.push_back(input.name);
    if (outputs.empty())
      for (const model::Output& output : machine.outputs) outputs.push_back(output.variable.name);
  }
};

inline std::string driver_function(const Sample& sample, std::size_t index) {
  std::string out = fmt::format(
      "static void run_{0}() {{\n  {1}::Controller controller;\n  char command = 0;\n"
      "  while (std::scanf(\" %c\", &command) == 1) {{\n"
      "    if (command == 'R') {{ controller.reset(); continue; }}\n"
      "    {1}::Observation observation;\n",
      index, sample.name_space);
  for (const std::string& field : sample.inputs)
    out += fmt::format("    observation.{0} = static_cast<decltype(observation.{0})>(number());\n", field);
  out += fmt::format(
      "    const {}::Reaction reaction = controller.step(observation);\n    static_cast<void>(reaction);\n"
      "    std::printf(\"%d\", static_cast<int>(controller.last_status()));\n",
      sample.name_space);
  for (std::size_t i = 0; i < sample.outputs.size(); ++i) {
    const bool named = sample.machine.outputs[i].variable.domain.kind == Domain::Kind::Enumeration;
    const std::string value = named ? "name(reaction.{})" : "static_cast<long long>(reaction.{})";
    out += fmt::format(fmt::runtime("    std::printf(\" {}\", " + value + ");\n"), named ? "%s" : "%lld",
                       sample.outputs[i]);
  }
  return out + "    std::printf(\"\\n\");\n  }\n}\n";
}

inline std::string driver(const std::vector<Sample>& samples) {
  std::string out = "#include <cstdio>\n#include <cstdlib>\n";
  for (std::size_t i = 0; i < samples.size(); ++i) out += fmt::format("#include \"m{}.h\"\n", i);
  out += "static long long number() { long long n = 0; return std::scanf(\"%lld\", &n) == 1 ? n : 0; }\n";
  for (std::size_t i = 0; i < samples.size(); ++i) out += driver_function(samples[i], i);
  out += "int main(int, char** argv) {\n  switch (std::atoi(argv[1])) {\n";
  for (std::size_t i = 0; i < samples.size(); ++i) out += fmt::format("    case {0}: run_{0}(); break;\n", i);
  return out + "    default: return 1;\n  }\n  return 0;\n}\n";
}

inline int shell(const std::string& command) {
  return std::system(command.c_str());
}

}  // namespace heed::exporter::testing
