// From a generated ontology to a certified symbolic controller: what it recognises and when it halts, beside
// what the document says line by line, read here with nothing of heed's; and how large it is.
#include <gtest/gtest.h>
#include <heed/certify/certify.h>
#include <heed/export/symbolic_runner.h>
#include <heed/job/controller.h>
#include <heed/util/file.h>
#include <heed/util/random.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "generators/sign_catalogue.h"
#include "temporary_folder.h"

namespace heed {
namespace {

/// The document by regular expressions: leaves with their features (role, value), and who says `Halt`.
struct Lines {
  std::map<std::string, std::map<std::string, std::string>> features;  ///< Of a leaf, by role.
  std::set<std::string> halting;

  explicit Lines(const std::string& path) {
    const std::regex defined("EquivalentClasses\\(:(\\w+) ObjectIntersectionOf\\(:Sign(.*)\\)\\)");
    const std::regex some("ObjectSomeValuesFrom\\(:(\\w+) :(\\w+)\\)");
    const std::regex halts("SubClassOf\\(:(\\w+) ObjectSomeValuesFrom\\(:hasAction :Halt\\)\\)");
    std::ifstream in(path);
    std::smatch found;
    for (std::string line; std::getline(in, line);) {
      if (std::regex_match(line, found, halts)) halting.insert(found[1]);
      if (!std::regex_match(line, found, defined)) continue;
      const std::string parts = found[2];
      for (std::sregex_iterator it(parts.begin(), parts.end(), some), end; it != end; ++it)
        features[found[1]][(*it)[1]] = (*it)[2];
    }
  }
};

class CatalogueController : public testing::Test {
 protected:
  void synthesize(std::size_t entities) {
    const auto scenario =
        job::read_scenario(util::read_file(bench::write_scenario({entities, 60, 1}, folder.path())));
    const job::World world = job::load_world(scenario, budget.limits(), budget);
    const job::Design design = job::design(scenario, world, scenario.controllers.front());
    strategy::Options options;
    options.form = strategy::Form::Symbolic;
    options.claim = true;
    const strategy::Result result = strategy::synthesize(design.composed.spec, budget, options);
    ASSERT_TRUE(result.symbolic && result.claim);
    EXPECT_EQ(certify::certify(*result.claim, design.composed.spec, budget).fault, "");
    EXPECT_EQ(certify::certify(*result.symbolic, design.composed.spec, budget).fault, "");
    controller = *result.symbolic;
  }

  /// Nodes of \p functions together.
  [[nodiscard]] std::size_t size(const std::vector<model::Function>& functions) const {
    std::set<model::Function> seen;
    std::vector<model::Function> open(functions);
    while (!open.empty()) {
      const model::Function node = open.back() / 2;  // without the complement
      open.pop_back();
      if (node == 0 || !seen.insert(node).second) continue;
      open.push_back(controller.diagrams.nodes[node - 1].low);
      open.push_back(controller.diagrams.nodes[node - 1].high);
    }
    return seen.size();
  }

  test::TemporaryFolder folder{};
  util::Budget budget{};
  model::SymbolicController controller{};
};

/// The value of the input for a role: of one of its values in lower case, such as `shape_shape_3`.
std::int32_t value_of(const model::Variable& input, const std::string& value) {
  for (std::size_t v = 0; v < input.domain.values.size(); ++v) {
    std::string name = value;
    std::size_t digit = name.find_first_of("0123456789");
    name.insert(digit, "_");
    name[0] = static_cast<char>(std::tolower(name[0]));
    if (input.domain.values[v].ends_with(name)) return static_cast<std::int32_t>(v);
  }
  return 0;
}

TEST_F(CatalogueController, RecognisesWhatTheDocumentDefinesAndHaltsWhereItSaysSo) {
  synthesize(150);
  const Lines lines(folder.path("catalogue.ofn"));
  ASSERT_GT(lines.features.size(), 100U);
  std::map<std::string, std::size_t> column;  // after outputs and memories
  for (std::size_t d = 0; d < controller.definitions.size(); ++d)
    column[controller.definitions[d].variable.name] =
        controller.outputs.size() + controller.memories.size() + d;
  const std::map<std::string, std::string> role_of{{"shape", "hasShape"},
                                                   {"ground_colour", "hasGroundColour"},
                                                   {"border_colour", "hasBorderColour"},
                                                   {"text", "hasText"},
                                                   {"symbol", "hasSymbol"}};
  util::CounterRandom random(7, 0);
  std::size_t recognised = 0, halts = 0, steps = 0;
  exporter::SymbolicRunner runner(controller);
  ASSERT_TRUE(runner.step(model::Valuation(controller.inputs.size(), 0)));
  for (const auto& [leaf, features] : lines.features) {
    // All of the leaf but, every third time, one role, and some value of each role that it lacks.
    model::Valuation seen;
    for (const model::Variable& input : controller.inputs) {
      const auto role = role_of.find(input.name);
      const auto has = role == role_of.end() ? features.end() : features.find(role->second);
      if (role == role_of.end())
        seen.push_back(1);
      else if (has == features.end() || random.below(9) == 0)
        seen.push_back(
            static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(input.domain.size()))));
      else
        seen.push_back(value_of(input, has->second));
    }
    const auto step = runner.step(seen);
    ASSERT_TRUE(step) << leaf;
    bool halt = false;
    for (const auto& [other, needed] : lines.features) {
      bool all = true;
      for (std::size_t i = 0; i < controller.inputs.size(); ++i)
        if (const auto role = role_of.find(controller.inputs[i].name); role != role_of.end())
          if (const auto need = needed.find(role->second); need != needed.end())
            all = all && seen[i] == value_of(controller.inputs[i], need->second);
      const std::string name = "recognised_sign_" + other.substr(4);
      EXPECT_EQ((*step)[column.at(name)] != 0, all) << other << " while " << leaf << " is seen";
      halt = halt || (all && lines.halting.contains(other));
      recognised += all ? 1U : 0U;
    }
    EXPECT_EQ((*step)[column.at("prescribed_halt")] != 0, halt) << leaf;
    halts += halt ? 1U : 0U;
    ++steps;
  }
  EXPECT_GT(recognised, steps / 2);
  EXPECT_GT(halts, 5U);
  EXPECT_LT(halts, steps / 2);
}

/// What is seen stands in the recognition, and once more in each bit of the answers, but never twice in one.
TEST_F(CatalogueController, ItsAnswersAreNoLargerThanWhatTheyAnswerTo) {
  synthesize(300);
  const std::size_t derived = size(controller.derived);
  EXPECT_GT(derived, 1'000U);
  for (const auto& goal : controller.goals)
    for (const model::Function answer : goal.answers) EXPECT_LT(size({answer}), derived);
  EXPECT_LT(controller.diagrams.nodes.size(), 3 * derived);
}

}  // namespace
}  // namespace heed
