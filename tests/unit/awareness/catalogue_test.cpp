#include "ontologies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using test::described_atoms;
using test::prescribed_atoms;
using test::traffic_signs;
using test::warnings_with;
using Atoms = std::set<std::string>;

TEST(TrafficSigns, DescribeWhatTheyLookLike) {
  const Catalogue c = traffic_signs();
  EXPECT_EQ(described_atoms(c, "StopSign"),
            (Atoms{"sign", "red", "octagon", "stop_text", "ground_colour_red", "border_colour_white"}));
  EXPECT_EQ(described_atoms(c, "YieldSign"),
            (Atoms{"sign", "red", "inverted_triangle", "ground_colour_white", "border_colour_red"}));
  EXPECT_EQ(described_atoms(c, "SpeedLimit50Sign"),
            (Atoms{"sign", "red", "disc", "number_50", "ground_colour_white", "border_colour_red"}));
  EXPECT_EQ(described_atoms(c, "DangerousBendSign"),
            (Atoms{"sign", "red", "upright_triangle", "bending_arrow", "ground_colour_white",
                   "border_colour_red"}));
}

TEST(TrafficSigns, PrescribeWhatIsInheritedAndImplied) {
  const Catalogue c = traffic_signs();
  EXPECT_EQ(prescribed_atoms(c, "StopSign"), (Atoms{"halt", "give_way", "slow_down"}));
  EXPECT_EQ(prescribed_atoms(c, "NoEntrySign"), (Atoms{"do_not_enter", "halt", "slow_down"}));
  EXPECT_EQ(prescribed_atoms(c, "PedestrianCrossingSign"),
            (Atoms{"give_way_to_pedestrians", "give_way", "slow_down"}));
  EXPECT_EQ(prescribed_atoms(c, "ParkingSign"), (Atoms{"slow_down"}));
  EXPECT_EQ(prescribed_atoms(c, "ChildrenSign"), (Atoms{"be_alert", "slow_down"}));
  for (std::size_t e = 0; e < c.entities.size(); ++e)
    EXPECT_NE(c.prescribes(e, c.behaviour("SlowDown")), nullptr) << c.entities[e].label;
}

TEST(TrafficSigns, AreManyAndInTheirGroups) {
  const Catalogue c = traffic_signs();
  std::size_t leaves = 0;
  for (const Entity& entity : c.entities) leaves += entity.is_leaf() ? 1 : 0;
  EXPECT_GE(leaves, 45U);
  for (const char* group : {"DangerWarningSign", "PrioritySign", "ProhibitorySign", "MandatorySign",
                            "SpecialRegulationSign", "InformationSign"})
    EXPECT_GE(c.entities[c.entity(group)].children.size(), 4U) << group;
  EXPECT_NE(c.is_below(c.entity("StopSign"), c.entity("PrioritySign")), nullptr);
}

TEST(TrafficSigns, HoldNoAccidents) {
  const Catalogue c = traffic_signs();
  for (const Warning& warning : c.warnings) ADD_FAILURE() << warning.code << ": " << warning.message;
  EXPECT_TRUE(c.notes.empty());
}

TEST(TrafficSigns, AreRecognisableByDefinitionOrThroughMembers) {
  const Catalogue c = traffic_signs();
  for (const Entity& entity : c.entities) {
    const bool defined = entity.sufficiency == Sufficiency::Defined;
    EXPECT_TRUE(defined || (!entity.is_leaf() && entity.sufficiency == Sufficiency::MembersOnly))
        << entity.label;
  }
  EXPECT_EQ(c.entities[c.entity("DangerWarningSign")].sufficiency, Sufficiency::Defined);
  EXPECT_EQ(c.entities[c.entity("ProhibitorySign")].sufficiency, Sufficiency::MembersOnly);
}

TEST(TrafficSigns, ExcludeWhatTheyExclude) {
  const Catalogue c = traffic_signs();
  const auto exclusive = [&](const Name& a, const Name& b) {
    const auto i = c.feature(a), j = c.feature(b);
    return c.exclusive.contains({std::min(i, j), std::max(i, j)});
  };
  EXPECT_TRUE(exclusive("Red", "Blue"));
  EXPECT_TRUE(exclusive("Octagon", "InvertedTriangle"));
  EXPECT_TRUE(exclusive("UprightTriangle", "InvertedTriangle"));
  EXPECT_TRUE(exclusive("Number30", "StopText"));
  EXPECT_FALSE(exclusive("hasMainColour Red", "hasGroundColour White"));
  EXPECT_FALSE(exclusive("Number30", "SpeedNumber"));
}

TEST(TrafficSigns, HaveDistinctAtomsAndNamesThatLeadBack) {
  const Catalogue c = traffic_signs();
  Atoms atoms;
  for (std::size_t e = 0; e < c.entities.size(); ++e) {
    EXPECT_TRUE(atoms.insert(c.entities[e].atom).second);
    EXPECT_EQ(c.entity(Name(c.entities[e].atom)), e);
    EXPECT_EQ(c.entity(Name(std::string(c.ontology.text(c.entities[e].iri)))), e);
  }
  for (std::size_t f = 0; f < c.features.size(); ++f) {
    if (!c.features[f].entity) {
      EXPECT_TRUE(atoms.insert(c.features[f].atom).second) << c.features[f].atom;
    }
    EXPECT_EQ(c.feature(Name(c.features[f].atom)), f);
  }
  EXPECT_EQ(c.entity("stop"), c.entity("StopSign"));
  EXPECT_EQ(c.features[c.feature("Red")].role_atom, "main_colour");
  EXPECT_EQ(c.features[c.feature("hasGroundColour.Red")].atom, "ground_colour_red");
}

/// What follows from a few axioms alone, by saturating naively: names and bindings of one class.
class Closure {
 public:
  Closure(const Catalogue& c, const std::vector<owl::AxiomId>& axioms, owl::Iri start) : names_{{start}} {
    for (std::size_t before = 0; before != size();) {
      before = size();
      for (const owl::AxiomId id : axioms) apply(c.ontology.axiom(id));
    }
  }
  [[nodiscard]] bool has(owl::Iri role, owl::Iri filler) const { return bound_.contains({role, filler}); }

 private:
  [[nodiscard]] std::size_t size() const { return names_.size() + bound_.size(); }

  void include(const owl::ClassExpression& sub, const owl::ClassExpression& super) {
    if (!sub.is_named()) return;
    if (names_.contains(sub.iri())) add(super);
    if (!super.is_named()) return;
    const auto bound = bound_;
    for (const auto& [role, filler] : bound)
      if (filler == sub.iri()) bound_.insert({role, super.iri()});
  }

  void add(const owl::ClassExpression& expression) {
    if (expression.is_named()) names_.insert(expression.iri());
    if (expression.kind() == owl::ClassExpression::Kind::Some)
      bound_.insert({expression.property().iri, expression.filler().iri()});
    if (expression.kind() == owl::ClassExpression::Kind::Intersection)
      for (const auto& part : expression.operands()) add(part);
  }

  void apply(const owl::Axiom& axiom) {
    if (const auto* inclusion = axiom.as<owl::SubClassOf>()) include(inclusion->sub, inclusion->super);
    if (const auto* same = axiom.as<owl::EquivalentClasses>()) {
      include(same->classes[0], same->classes[1]);
      include(same->classes[1], same->classes[0]);
    }
    if (const auto* role = axiom.as<owl::SubObjectPropertyOf>()) {
      const auto bound = bound_;
      for (const auto& [sub, filler] : bound)
        if (sub == role->chain[0].iri) bound_.insert({role->super.iri, filler});
    }
  }

  std::set<owl::Iri> names_;
  std::set<std::pair<owl::Iri, owl::Iri>> bound_;
};

/// Each entry follows from the axioms that it names, and from no fewer of them.
void expect_minimal(const Catalogue& c, const std::vector<owl::AxiomId>& axioms, owl::Iri sub, owl::Iri role,
                    owl::Iri filler) {
  EXPECT_TRUE(Closure(c, axioms, sub).has(role, filler))
      << c.ontology.local_name(sub) << " " << c.ontology.local_name(filler);
  for (std::size_t drop = 0; drop < axioms.size(); ++drop) {
    std::vector<owl::AxiomId> fewer = axioms;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(drop));
    EXPECT_FALSE(Closure(c, fewer, sub).has(role, filler))
        << c.ontology.local_name(sub) << " " << c.ontology.local_name(filler);
  }
}

TEST(TrafficSigns, FollowFromTheAxiomsTheyNameAndFromNoFewer) {
  const Catalogue c = traffic_signs();
  const owl::Iri action = *c.ontology.find("http://example.org/heed/traffic-signs#hasAction");
  for (const Entity& entity : c.entities) {
    for (const Entailed& has : entity.features)
      if (const Feature& feature = c.features[has.index]; feature.kind == Feature::Kind::Some)
        expect_minimal(c, has.axioms, entity.iri, feature.role, feature.filler);
    for (const Entailed& act : entity.behaviours)
      expect_minimal(c, act.axioms, entity.iri, action, c.behaviours[act.index].iri);
  }
}

/// What single axioms tell must be all that the reasoner finds.
TEST(TrafficSigns, MissNothingThatTheReasonerKnows) {
  const Catalogue c = traffic_signs();
  util::Budget budget;
  const dl::Reasoner reasoner(c.ontology, budget);
  for (std::size_t e = 0; e < c.entities.size(); e += 3)
    for (std::size_t f = 0; f < c.features.size(); ++f) {
      const Feature& feature = c.features[f];
      if (feature.kind != Feature::Kind::Some) continue;
      const bool entailed = reasoner.entails_subsumption(
          owl::ClassExpression::named(c.entities[e].iri),
          owl::ClassExpression::some({feature.role, false}, owl::ClassExpression::named(feature.filler)));
      EXPECT_EQ(entailed, c.has_feature(e, f) != nullptr) << c.entities[e].atom << " " << feature.atom;
    }
}

const std::string red_of_stop =
    "                        <owl:onProperty "
    "rdf:resource=\"http://example.org/heed/traffic-signs#hasMainColour\"/>\n"
    "                        <owl:someValuesFrom "
    "rdf:resource=\"http://example.org/heed/traffic-signs#Red\"/>\n"
    "                    </owl:Restriction>\n"
    "                    <owl:Restriction>\n"
    "                        <owl:onProperty "
    "rdf:resource=\"http://example.org/heed/traffic-signs#hasShape\"/>\n"
    "                        <owl:someValuesFrom "
    "rdf:resource=\"http://example.org/heed/traffic-signs#Octagon\"/>\n";
const std::string without_red =
    "                        <owl:onProperty "
    "rdf:resource=\"http://example.org/heed/traffic-signs#hasShape\"/>\n"
    "                        <owl:someValuesFrom "
    "rdf:resource=\"http://example.org/heed/traffic-signs#Octagon\"/>\n";

TEST(TrafficSigns, WhatTheOntologyNoLongerSaysFallsOut) {
  const Catalogue c = traffic_signs({{red_of_stop, without_red}});
  EXPECT_EQ(described_atoms(c, "StopSign"),
            (Atoms{"sign", "octagon", "stop_text", "ground_colour_red", "border_colour_white"}));
}

TEST(YieldRoles, GiveTheSameNormalForm) {
  const Catalogue c = test::yield_roles();
  EXPECT_EQ(described_atoms(c, "yield"), (Atoms{"sign", "red", "triangle"}));
  EXPECT_EQ(prescribed_atoms(c, "yield"), (Atoms{"giveWay", "slowDown"}));
  EXPECT_EQ(prescribed_atoms(c, "sign"), (Atoms{"slowDown"}));
  EXPECT_EQ(c.entities[c.entity("yield")].sufficiency, Sufficiency::Declared);
  ASSERT_EQ(c.notes.size(), 1U);
  EXPECT_EQ(c.notes[0].code, "role-assertions-normalised");
  EXPECT_TRUE(c.warnings.empty());
}

std::string code_of(CatalogueOptions options) {
  try {
    (void)test::catalogue_of(test::source_path("examples/stop-sign/traffic-signs.owl"), options);
  } catch (const util::InputError& error) {
    return error.diagnostic().code + ": " + error.diagnostic().hint;
  }
  return "accepted";
}

TEST(CatalogueOptions, RefusesUnknownRootsAndRolesWithTheNearestName) {
  CatalogueOptions options = test::traffic_options();
  options.entities = {"Sing"};
  EXPECT_THAT(code_of(options),
              testing::AllOf(testing::StartsWith("unknown-root"), testing::HasSubstr("Sign")));
  options = test::traffic_options();
  options.action_roles = {"hasActoin"};
  EXPECT_THAT(code_of(options),
              testing::AllOf(testing::StartsWith("unknown-role"), testing::HasSubstr("hasAction")));
  options = test::traffic_options();
  options.entities = {};
  EXPECT_THAT(code_of(options), testing::StartsWith("no-entities"));
}

class CorpusSigns : public testing::Test {
 protected:
  void SetUp() override {
    path_ = test::corpus_path("owl/signs/signs.owl");
    if (path_.empty()) GTEST_SKIP() << "no corpus";
  }
  [[nodiscard]] Catalogue build(bool sufficient = false) const {
    CatalogueOptions options;
    options.entities = {"Sign"};
    options.features = {"Feature"};
    options.behaviours = {"Action"};
    options.feature_roles = {"hasColor", "hasShape", "hasBorderColor"};
    options.action_roles = {"hasAction"};
    options.sufficient = sufficient;
    return test::catalogue_of(path_, options);
  }
  std::string path_;
};

TEST_F(CorpusSigns, ImpossibleSignIsUnsatisfiable) {
  const Catalogue c = build();
  const auto found = warnings_with(c, "unsatisfiable-entity");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0]->message, testing::HasSubstr("deliberately unsatisfiable"));
  // Being a stop sign and round, the definition of the stop sign, one shape only, disjoint shapes.
  EXPECT_GE(found[0]->axioms.size(), 5U);
}

TEST_F(CorpusSigns, NoEntryIsProhibitorySignSoASpeedLimitPrescribesHalting) {
  const Catalogue c = build();
  const auto found = warnings_with(c, "unasserted-equivalence");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0]->message,
              testing::AllOf(testing::HasSubstr("ProhibitorySign"), testing::HasSubstr("NoEntry"),
                             testing::HasSubstr("SpeedLimit"), testing::HasSubstr("Halt")));
  EXPECT_FALSE(found[0]->axioms.empty());
  EXPECT_EQ(prescribed_atoms(c, "SpeedLimit"), (Atoms{"halt", "slow_down"}));
}

TEST_F(CorpusSigns, ReadsValuesOfIndividualsAndFollowsChains) {
  const Catalogue c = build();
  EXPECT_EQ(described_atoms(c, "StopSign"), (Atoms{"sign", "red", "octagon"}));
  EXPECT_EQ(described_atoms(c, "YieldSign"), (Atoms{"sign", "yellow", "triangle"}));
  EXPECT_EQ(prescribed_atoms(c, "StopSign"), (Atoms{"halt", "give_way", "slow_down"}));
  EXPECT_EQ(c.features[c.feature("red")].kind, Feature::Kind::Value);
}

TEST_F(CorpusSigns, WarnsOfRolesThatExcludeNothing) {
  const Catalogue c = build();
  const auto found = warnings_with(c, "excludes-nothing");
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found[0]->message, testing::HasSubstr("hasColor"));
}

}  // namespace
}  // namespace heed::awareness
