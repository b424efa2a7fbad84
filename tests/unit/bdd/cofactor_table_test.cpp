#include <gtest/gtest.h>
#include <heed/bdd/cofactor_table.h>

#include <random>

#include "truth.h"

/// Vectors of functions of four variables and what is left of them, against bit arithmetic; with collections
/// and new orders between the steps, since the table holds its functions without handles.
namespace heed::bdd {
namespace {

using truth::Space;
using truth::Table;

constexpr unsigned variables = 4;
constexpr std::size_t width = 3;

class Vectors : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  Vectors() {
    for (unsigned i = 0; i < variables; ++i) map_.push_back(manager_.new_variable());
  }

  std::vector<Table> some_tables() {
    std::vector<Table> tables;
    for (std::size_t i = 0; i < width; ++i) tables.push_back(random_() & space_.all());
    return tables;
  }
  CofactorTable::Id root(CofactorTable& table, const std::vector<Table>& tables) {
    std::vector<Bdd> functions;
    for (const Table f : tables) functions.push_back(truth::build(manager_, space_, f, map_));
    return table.root(functions);
  }
  void disturb() {
    if (random_() % 3 == 0) manager_.collect_garbage();
    if (random_() % 5 == 0) manager_.sift();
  }
  void expect_equal(const CofactorTable& table, CofactorTable::Id id, const std::vector<Table>& tables) {
    for (std::size_t i = 0; i < width; ++i) {
      ASSERT_EQ(truth::read(table.function(id, i), space_, map_), tables[i]);
      ASSERT_EQ(table.is_true(id, i), tables[i] == space_.all());
      ASSERT_EQ(table.is_false(id, i), tables[i] == 0);
      for (unsigned row = 0; row < space_.rows(); ++row) {
        std::vector<bool> assignment;
        for (unsigned v = 0; v < variables; ++v) assignment.push_back(((row >> v) & 1U) != 0);
        ASSERT_EQ(table.evaluate(id, i, assignment), ((tables[i] >> row) & 1U) != 0);
      }
    }
  }

  std::mt19937_64 random_{GetParam()};
  Space space_{variables};
  Manager manager_;
  std::vector<Var> map_;
};

TEST_P(Vectors, StepsAreCofactors) {
  const std::vector<Var> order{map_[2], map_[0], map_[3]};
  CofactorTable table(manager_, order, width);
  for (int round = 0; round < 40; ++round) {
    std::vector<Table> tables = some_tables();
    CofactorTable::Id id = root(table, tables);
    for (const Var variable : order) {
      const bool value = (random_() & 1U) != 0;
      for (Table& f : tables) f = space_.cofactor(f, variable, value);
      id = table.step(id, value);
      disturb();
      expect_equal(table, id, tables);
    }
  }
  EXPECT_TRUE(manager_.consistent());
}

TEST_P(Vectors, EqualRestsAreOneNumber) {
  const std::vector<Var> order{map_[0]};
  CofactorTable table(manager_, order, width);
  std::vector<Table> tables = some_tables();
  for (Table& f : tables) f = space_.cofactor(f, 0, true);
  const CofactorTable::Id id = root(table, tables);
  EXPECT_EQ(root(table, tables), id);
  EXPECT_EQ(table.step(id, false), table.step(id, true));
  // The same functions at another depth have other steps to make, so that they are another vector.
  EXPECT_NE(table.step(id, true), id);
}

TEST_P(Vectors, RootsFromAnotherTableHaveACubePutIn) {
  CofactorTable from(manager_, std::vector<Var>{}, width), to(manager_, std::vector<Var>{map_[1]}, width);
  const std::vector<std::uint32_t> places{2, 0, 2};
  for (int round = 0; round < 20; ++round) {
    const std::vector<Table> tables = some_tables();
    const CofactorTable::Id before = root(from, tables);
    disturb();
    const std::vector<Literal> literals{{map_[3], (random_() & 1U) != 0}, {map_[0], (random_() & 1U) != 0}};
    const CofactorTable::Id id = to.root(from, before, places, manager_.cube(literals));
    std::vector<Table> expected;
    for (const std::uint32_t place : places) {
      expected.push_back(tables[place]);
      for (const auto& [variable, value] : literals)
        expected.back() = space_.cofactor(expected.back(), variable, value);
    }
    expect_equal(to, id, expected);
  }
}

TEST_P(Vectors, KnowConjunctionsOfLiterals) {
  CofactorTable table(manager_, std::vector<Var>{}, width);
  std::vector<Literal> literals;
  for (int round = 0; round < 200; ++round) {
    std::vector<Table> tables = some_tables();
    Table cube = space_.all();
    for (unsigned v = 0; v < variables; ++v)
      if (const auto choice = random_() % 3; choice != 2)
        cube &= choice == 1 ? space_.variable(v) : space_.complement(space_.variable(v));
    tables[1] = cube;
    const CofactorTable::Id id = root(table, tables);
    for (std::size_t i = 0; i < width; ++i) {
      const bool found = table.literals(id, i, literals);
      Table product = space_.all();
      for (const auto& [variable, value] : literals)
        product &= value ? space_.variable(variable) : space_.complement(space_.variable(variable));
      ASSERT_TRUE(found || i != 1);
      if (found) {
        ASSERT_EQ(product, tables[i]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Vectors, ::testing::Range<std::uint64_t>(0, 8));

}  // namespace
}  // namespace heed::bdd
