#include "fixture.h"

#include <heed/util/diagnostic.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace heed::awareness {
namespace {

using test::all_assignments;
using test::react;
using test::small_world_symbols;
using test::SmallWorld;
using Values = std::map<std::string, bool>;
using Kind = PolicyOptions::Kind;

PolicyOptions policy(Kind kind) {
  PolicyOptions options;
  options.kind = kind;
  return options;
}

/// Compares what \p options recognises with \p expected, given as functions of the symbols, on every
/// observation.
void expect_same(const SmallWorld& world, const PolicyOptions& options,
                 const std::map<std::string, std::function<bool(Values)>>& expected) {
  const Recognition recognition = compile_policy(world.catalogue, world.perception(), options);
  for (const Values& seen : all_assignments(small_world_symbols())) {
    const Values result = react(recognition, seen);
    for (const auto& [name, rule] : expected) {
      const auto found = result.find(name);
      ASSERT_EQ(found != result.end() && found->second, rule(seen)) << name;
    }
  }
}

int count(Values v, std::initializer_list<const char*> names) {
  return static_cast<int>(std::count_if(names.begin(), names.end(), [&](const char* n) { return v[n]; }));
}

TEST(Policy, FullRecognisesWhatIsReadWholeAndItsGroups) {
  expect_same(SmallWorld(), policy(Kind::Full),
              {{"recognised_stop", [](Values v) { return v["stop_seen"]; }},
               {"recognised_priority", [](Values v) { return v["stop_seen"]; }},
               {"recognised_sign", [](Values v) { return v["stop_seen"] || v["sign"]; }},
               {"recognised_yield", [](Values) { return false; }},
               {"prescribed_halt", [](Values v) { return v["stop_seen"]; }},
               {"prescribed_slow_down", [](Values v) { return v["stop_seen"] || v["sign"]; }}});
}

TEST(Policy, DefinitionNeedsAllDescribedFeatures) {
  const auto all = [](std::initializer_list<const char*> names) {
    const std::vector<std::string> kept(names.begin(), names.end());
    return [kept](Values v) {
      return std::all_of(kept.begin(), kept.end(), [&](const auto& n) { return v[n]; });
    };
  };
  const auto stop = all({"sign", "red", "octagon"});
  const auto yield = all({"sign", "red", "triangle"});
  const auto limit = all({"sign", "red", "disc"});
  expect_same(SmallWorld(), policy(Kind::Definition),
              {{"recognised_stop", stop},
               {"recognised_yield", yield},
               {"recognised_limit", limit},
               {"recognised_mandatory", all({"sign", "blue", "disc"})},
               {"recognised_prohibitory", limit},
               {"recognised_priority", [=](Values v) { return stop(v) || yield(v); }},
               {"prescribed_give_way", [=](Values v) { return stop(v) || yield(v); }},
               {"prescribed_halt", stop},
               {"prescribed_observe", limit},
               {"prescribed_slow_down", [](Values v) { return v["sign"]; }}});
}

TEST(Policy, AtLeastCountsTheFeaturesOfEachDescription) {
  for (std::size_t k = 1; k <= 3; ++k) {
    PolicyOptions options = policy(Kind::AtLeast);
    options.k = k;
    options.direct = false;
    const auto least = static_cast<int>(k);
    expect_same(SmallWorld(), options,
                {{"recognised_stop",
                  [=](Values v) {
                    return count(v, {"sign", "red", "octagon"}) >= least;
                  }},
                 {"recognised_mandatory", [=](Values v) {
                    return count(v, {"sign", "blue", "disc"}) >= least;
                  }}});
  }
}

TEST(Policy, OverNarrowsADescriptionAndNeverAddsToIt) {
  PolicyOptions options = policy(Kind::AtLeast);
  options.entities = {"stop", "mandatory"};
  options.over = {"sign", "red", "disc"};
  options.direct = false;
  expect_same(SmallWorld(), options,
              {{"recognised_stop", [](Values v) { return v["sign"] && v["red"]; }},
               {"recognised_mandatory", [](Values v) { return v["sign"] && v["disc"]; }},
               {"recognised_yield", [](Values) { return false; }}});
  options.over = {"sign", "shape"};
  expect_same(SmallWorld(), options,
              {{"recognised_stop", [](Values v) { return v["sign"] && v["octagon"]; }}});
}

TEST(Policy, AtLeastUsesTheWholeReadingUnlessTold) {
  PolicyOptions options = policy(Kind::AtLeast);
  options.entities = {"stop"};
  const auto parts = [](Values v) { return count(v, {"sign", "red", "octagon"}) >= 2; };
  expect_same(SmallWorld(), options,
              {{"recognised_stop", [=](Values v) { return parts(v) || v["stop_seen"]; }}});
  options.direct = false;
  expect_same(SmallWorld(), options, {{"recognised_stop", parts}});
}

TEST(Policy, TooFewFeaturesNeverSuffice) {
  SmallWorld world;
  auto& features = world.catalogue.entities[SmallWorld::Stop].features;
  std::erase_if(features, [](const Entailed& f) { return f.index != SmallWorld::IsSign; });
  PolicyOptions options = policy(Kind::AtLeast);
  options.entities = {"stop"};
  options.direct = false;
  const Recognition recognition = compile_policy(world.catalogue, world.perception(), options);
  EXPECT_EQ(recognition.find_entity(SmallWorld::Stop), nullptr);
  ASSERT_FALSE(recognition.notes.empty());
  EXPECT_EQ(recognition.notes.front().code, "too-few-features");
}

/// Subset-minimal sets of symbols for which a rule holds, by looking at all of them.
std::set<std::vector<std::string>> prime_implicants(const Recognition& recognition, const std::string& name) {
  std::set<std::vector<std::string>> result;
  for (const Values& seen : all_assignments(small_world_symbols())) {
    if (!react(recognition, seen).at(name)) continue;
    bool minimal = true;
    std::vector<std::string> atoms;
    for (const auto& [atom, value] : seen) {
      if (!value) continue;
      atoms.push_back(atom);
      Values less = seen;
      less[atom] = false;
      if (react(recognition, less).at(name)) minimal = false;
    }
    if (minimal) result.insert(atoms);
  }
  return result;
}

TEST(Policy, EvidenceIsExactlyThePrimeImplicants) {
  const SmallWorld world;
  PolicyOptions at_least = policy(Kind::AtLeast);
  for (const PolicyOptions& options : {policy(Kind::Full), policy(Kind::Definition), at_least}) {
    const Recognition recognition = compile_policy(world.catalogue, world.perception(), options);
    for (const RecognisedEntity& entity : recognition.entities) {
      std::set<std::vector<std::string>> listed;
      for (const Evidence& evidence : entity.evidence) listed.insert(evidence.atoms);
      EXPECT_TRUE(entity.evidence_complete);
      EXPECT_EQ(listed, prime_implicants(recognition, entity.name)) << entity.name;
    }
  }
}

TEST(Policy, EvidenceCarriesTheAxiomsOfItsFeatures) {
  const SmallWorld world;
  const Recognition recognition =
      compile_policy(world.catalogue, world.perception(), policy(Kind::Definition));
  const auto number = [](owl::AxiomId id) { return id.number; };
  const auto ids = [&](const std::vector<owl::AxiomId>& axioms) {
    std::vector<std::uint32_t> result;
    for (const auto id : axioms) result.push_back(number(id));
    return result;
  };
  EXPECT_THAT(ids(recognition.find_entity(SmallWorld::Stop)->evidence.front().axioms),
              testing::ElementsAre(51, 52, 54));
  EXPECT_THAT(ids(recognition.find_entity(SmallWorld::Priority)->evidence.front().axioms),
              testing::ElementsAre(50, 51, 52, 54));
}

TEST(Policy, ThresholdsOverManyFeaturesStayExactWhenTheListIsCut) {
  SmallWorld world;
  PerceptionOptions reported;
  std::vector<std::string> names;
  auto& stop = world.catalogue.entities[SmallWorld::Stop];
  stop.features.clear();
  for (std::size_t i = 0; i < 12; ++i) {
    Feature feature;
    feature.kind = Feature::Kind::Some;
    feature.atom = feature.label = "part_" + std::to_string(i);
    feature.role_atom = feature.atom + "_role";
    stop.features.push_back({world.catalogue.features.size(), SmallWorld::axiom(1)});
    world.catalogue.features.push_back(feature);
    names.push_back(feature.atom);
    reported.reported.push_back({Name(feature.atom), "", {}});
  }
  PolicyOptions options = policy(Kind::AtLeast);
  options.k = 5;
  options.entities = {"stop"};
  const Perception perception = resolve_perception(world.catalogue, reported);
  const Recognition recognition = compile_policy(world.catalogue, perception, options);
  const RecognisedEntity* rule = recognition.find_entity(SmallWorld::Stop);
  EXPECT_FALSE(rule->evidence_complete);
  EXPECT_EQ(rule->evidence.size(), evidence_cap);
  for (const Values& seen : all_assignments(names)) {
    const auto n = std::count_if(seen.begin(), seen.end(), [](const auto& entry) { return entry.second; });
    ASSERT_EQ(test::truth_of(rule->formula, seen), n >= 5);
  }
}

std::string code_of(const PolicyOptions& options, bool whole = true) {
  const SmallWorld world;
  try {
    (void)compile_policy(world.catalogue, world.perception(whole), options);
  } catch (const util::InputError& error) {
    return error.diagnostic().code;
  }
  return "accepted";
}

TEST(Policy, RefusesWhatMakesNoSense) {
  PolicyOptions zero = policy(Kind::AtLeast);
  zero.k = 0;
  EXPECT_EQ(code_of(zero), "k-out-of-range");
  EXPECT_EQ(code_of(policy(Kind::Tree)), "tree-without-order");
  EXPECT_EQ(code_of(policy(Kind::Full), false), "nothing-read-whole");
  PolicyOptions unknown = policy(Kind::AtLeast);
  unknown.over = {"octagn"};
  EXPECT_EQ(code_of(unknown), "unknown-feature");
  PolicyOptions tree = policy(Kind::Tree);
  tree.order = {"sign", "rde"};
  EXPECT_EQ(code_of(tree), "unknown-feature");
  PolicyOptions entity = policy(Kind::Definition);
  entity.entities = {"stp"};
  EXPECT_EQ(code_of(entity), "unknown-entity");
  tree.order = {"sign"};
  tree.direct = true;
  EXPECT_EQ(code_of(tree), "direct-tree");
}

TEST(Policy, NamesOfPoliciesRoundTrip) {
  for (const Kind kind : {Kind::Full, Kind::Tree, Kind::TreeOrFull, Kind::Definition, Kind::AtLeast})
    EXPECT_EQ(read_policy(to_string(kind)), kind);
  EXPECT_EQ(read_policy("guess"), std::nullopt);
}

}  // namespace
}  // namespace heed::awareness
