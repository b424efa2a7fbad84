#include <heed/game/techniques.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace heed::game {
namespace {

TEST(Techniques, EachNameSetsOneMember) {
  Techniques techniques;
  set_technique(techniques, "frontier-sets", "off");
  EXPECT_FALSE(techniques.frontier_sets);
  EXPECT_TRUE(techniques.state_invariants);
  set_technique(techniques, "frontier-sets", "on");
  EXPECT_TRUE(techniques.frontier_sets);
  set_technique(techniques, "cluster-nodes", "0");
  EXPECT_EQ(techniques.cluster_nodes, 0U);
  set_technique(techniques, "cluster-nodes", "1000000000");
  EXPECT_EQ(techniques.cluster_nodes, 1'000'000'000U);
}

TEST(Techniques, EveryNameIsKnown) {
  for (const std::string& name : technique_names()) {
    Techniques techniques;
    EXPECT_NO_THROW(set_technique(techniques, name, name == "cluster-nodes" ? "7" : "off")) << name;
  }
}

TEST(Techniques, WrongNamesAndValuesAreRefused) {
  Techniques techniques;
  for (const auto& [name, value] : {std::pair{"frontier", "on"},
                                    {"frontier-sets", "yes"},
                                    {"frontier-sets", ""},
                                    {"cluster-nodes", "on"},
                                    {"cluster-nodes", "-1"},
                                    {"cluster-nodes", "7x"},
                                    {"cluster-nodes", "1000000001"},
                                    {"cluster-nodes", ""}})
    EXPECT_THROW(set_technique(techniques, name, value), std::invalid_argument) << name << "=" << value;
}

}  // namespace
}  // namespace heed::game
