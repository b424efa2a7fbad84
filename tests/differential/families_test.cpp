// The benchmarks' families of games against every member of the corpus: generated from the parameters in a
// file's name, initial conditions, steps and goals are the same diagrams as the file's, wherever the numbers
// are in their ranges.
#include <gtest/gtest.h>
#include <heed/game/game.h>
#include <heed/spec/slugsin.h>
#include <heed/spec/structured_slugs.h>
#include <heed/util/file.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "generators/game_families.h"

namespace heed {
namespace {

using bdd::Bdd;

std::filesystem::path corpus() {
  const char* given = std::getenv("HEED_CORPUS");
  return given != nullptr ? given : HEED_SOURCE_DIR "/../shared/corpus";
}

/// "arbiter_10" -> {"arbiter", "10"}; nothing where the name is of no family.
std::vector<std::string> words_of(const std::string& stem) {
  static const std::map<std::string, std::string> patterns = {
      {"arbiter", R"(arbiter_(\d+))"},
      {"lift", R"(lift_(\d+))"},
      {"moving_obstacle", R"(moving_obstacle_(\d+)x\d+_(\d+)glitches)"},
      {"factory", R"(factory_assembly_(\d+)x(\d+)_(\d+)_(\d+)errors)"},
      {"cinderella", R"(cinderella_stepmother_n(\d+)c(\d+)_(\d+)_by_(\d+))"}};
  for (const auto& [family, pattern] : patterns) {
    std::smatch match;
    if (!std::regex_match(stem, match, std::regex(pattern))) continue;
    std::vector<std::string> words{family};
    words.insert(words.end(), match.begin() + 1, match.end());
    return words;
  }
  return {};
}

game::Game built(const spec::Gr1& spec) {
  util::Budget budget;
  game::Game game = game::build_game(spec, budget);
  game.manager->set_budget(nullptr);
  return game;
}

/// The parts of a game, put into one manager under the names of its variables.
class Parts {
 public:
  Parts(const game::Game& game, const game::Game& home)
      : manager_(*home.manager), map_(game.manager->variable_count()) {
    for (const game::Encoded& variable : game.variables) {
      const auto there =
          std::find_if(home.variables.begin(), home.variables.end(), [&](const game::Encoded& other) {
            return other.variable.name == variable.variable.name && other.owner == variable.owner;
          });
      if (there == home.variables.end()) {
        missing = variable.variable.name;
        return;
      }
      map_[variable.bits.front().current] = there->bits.front().current;
      map_[variable.bits.front().next] = there->bits.front().next;
    }
    env_initial = moved(game.env_initial);
    initial = moved(game.initial_answer());
    env_steps = moved(game.manager->conjunction(game.env_safety));
    steps = env_steps;
    for (const game::Part& part : game.sys_safety) steps &= moved(part.relation);
    for (const game::Justice& justice : game.env_justice) env_goals.push_back(moved(justice.relation));
    for (const game::Justice& justice : game.sys_justice) goals.push_back(moved(justice.relation));
  }

  std::string missing;
  Bdd env_initial, initial, env_steps, steps;
  std::vector<Bdd> env_goals, goals;

 private:
  [[nodiscard]] Bdd moved(const Bdd& function) const { return manager_.transfer(function, map_); }

  bdd::Manager& manager_;
  std::vector<bdd::Var> map_;
};

/// Current values of numbers, whose lowest bit is called `name@0.low.high`, are in their ranges.
Bdd in_range(const game::Game& game) {
  std::map<std::string, std::vector<bdd::Var>> bits;
  std::map<std::string, unsigned long> high;
  static const std::regex bit(R"((.*)@(\d+)(?:\.\d+\.(\d+))?)");
  for (const game::Encoded& variable : game.variables) {
    std::smatch match;
    if (!std::regex_match(variable.variable.name, match, bit)) continue;
    auto& list = bits[match[1]];
    list.resize(std::max<std::size_t>(list.size(), std::stoul(match[2]) + 1));
    list[std::stoul(match[2])] = variable.bits.front().current;
    if (match[3].matched) high[match[1]] = std::stoul(match[3]);
  }
  Bdd all = game.manager->constant(true);
  for (const auto& [name, list] : bits) {
    Bdd below = game.manager->constant(true);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Bdd one = game.manager->variable(list[i]);
      below = ((high.at(name) >> i) & 1) != 0 ? one.implies(below) : below.minus(one);
    }
    all &= below;
  }
  return all;
}

void expect_same_goals(std::vector<Bdd> a, std::vector<Bdd> b, const Bdd& where, const std::string& what) {
  const auto by_id = [](const Bdd& x, const Bdd& y) { return x.id() < y.id(); };
  for (auto* list : {&a, &b}) {
    for (Bdd& goal : *list) goal &= where;
    std::sort(list->begin(), list->end(), by_id);
  }
  EXPECT_TRUE(a == b) << what;
}

void compare(const std::filesystem::path& file, const std::vector<std::string>& words) {
  const std::string name = file.stem().string();
  const game::Game given = built(spec::read_slugsin(util::read_file(file.string())));
  const util::SourceText text("generated.structuredslugs", bench::game_text(words));
  const std::string bits = spec::write_slugsin(spec::read_structured_slugs(text));
  const game::Game made = built(spec::read_slugsin(util::SourceText("generated.slugsin", bits)));
  ASSERT_EQ(made.variables.size(), given.variables.size()) << name;
  const Parts expected(given, given);
  const Parts found(made, given);
  ASSERT_EQ(found.missing, "") << name;
  const Bdd valid = in_range(given);
  EXPECT_TRUE((found.env_initial & valid) == (expected.env_initial & valid)) << name << ": env_init";
  EXPECT_TRUE((found.initial & valid) == (expected.initial & valid)) << name << ": sys_init";
  EXPECT_TRUE((found.env_steps & valid) == (expected.env_steps & valid)) << name << ": env_trans";
  EXPECT_TRUE((found.steps & valid) == (expected.steps & valid)) << name << ": sys_trans";
  expect_same_goals(found.env_goals, expected.env_goals, valid, name + ": env_liveness");
  expect_same_goals(found.goals, expected.goals, valid, name + ": sys_liveness");
}

TEST(Families, ReproduceEveryMemberOfTheCorpus) {
  const std::filesystem::path folder = corpus() / "slugs";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no corpus at " << folder;
  const char* slow = std::getenv("HEED_SLOW");
  const bool all = slow != nullptr && std::string(slow) == "1";
  std::map<std::string, int> members;
  int left = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".slugsin") continue;
    const std::vector<std::string> words = words_of(entry.path().stem().string());
    if (words.empty()) continue;
    // Whole relations of the largest members take seconds each.
    if (!all && entry.file_size() > 8'500) {
      ++left;
      continue;
    }
    ++members[words.front()];
    compare(entry.path(), words);
  }
  for (const auto& [family, count] : members) std::cout << family << ": " << count << " members\n";
  std::cout << left << " large ones left for the slow set (HEED_SLOW=1)\n";
  EXPECT_EQ(members.size(), 5U);
}

TEST(Families, RefuseWhatIsNoGame) {
  EXPECT_THROW((void)bench::game_text({}), std::invalid_argument);
  EXPECT_THROW((void)bench::game_text({"arbiter"}), std::invalid_argument);
  EXPECT_THROW((void)bench::game_text({"arbiter", "1"}), std::invalid_argument);
  EXPECT_THROW((void)bench::game_text({"lift", "4x"}), std::invalid_argument);
  EXPECT_THROW((void)bench::game_text({"escalator", "4"}), std::invalid_argument);
}

}  // namespace
}  // namespace heed
