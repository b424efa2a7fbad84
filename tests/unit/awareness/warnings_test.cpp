#include "ontologies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using test::warnings_with;
using testing::HasSubstr;

const char* const prefixes = R"(
@prefix : <http://example.org/w#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
<http://example.org/w> a owl:Ontology .
:has a owl:ObjectProperty , owl:FunctionalProperty .
:does a owl:ObjectProperty .
:Thing a owl:Class . :Feature a owl:Class . :Act a owl:Class .
:Round a owl:Class ; rdfs:subClassOf :Feature .
:Square a owl:Class ; rdfs:subClassOf :Feature .
:Go a owl:Class ; rdfs:subClassOf :Act .
:Stay a owl:Class ; rdfs:subClassOf :Act .
:Round owl:disjointWith :Square .
)";

std::string has(const std::string& filler) {
  return "[ a owl:Restriction ; owl:onProperty :has ; owl:someValuesFrom :" + filler + " ]";
}
std::string does(const std::string& act) {
  return "[ a owl:Restriction ; owl:onProperty :does ; owl:someValuesFrom :" + act + " ]";
}
std::string sub(const std::string& name, const std::string& super) {
  return ":" + name + " a owl:Class ; rdfs:subClassOf " + super + " .\n";
}
std::string defined(const std::string& name, const std::string& parts) {
  return ":" + name + " a owl:Class ; owl:equivalentClass [ a owl:Class ; owl:intersectionOf ( :Thing " +
         parts + " ) ] .\n";
}

CatalogueOptions small_options() {
  CatalogueOptions options;
  options.entities = {"Thing"};
  options.features = {"Feature"};
  options.behaviours = {"Act"};
  options.feature_roles = {"has"};
  options.action_roles = {"does"};
  return options;
}

Catalogue build(const std::string& axioms, const CatalogueOptions& options = small_options()) {
  util::Diagnostics diagnostics;
  util::Budget budget;
  const owl::Ontology ontology = owl::read(util::SourceText("w.ttl", prefixes + axioms), {}, diagnostics);
  const dl::Reasoner reasoner(ontology, budget);
  return build_catalogue(reasoner, options, budget);
}

TEST(Warnings, NecessaryConditionsAloneAreNeverRecognised) {
  const std::string axioms = sub("Ball", ":Thing , " + has("Round") + " , " + does("Go"));
  const Catalogue plain = build(axioms);
  EXPECT_EQ(plain.entities[plain.entity("Ball")].sufficiency, Sufficiency::Never);
  const auto found = warnings_with(plain, "never-recognised");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0]->message, HasSubstr("'Ball' is never recognised"));

  CatalogueOptions options = small_options();
  options.sufficient_entities = {"Ball"};
  const Catalogue declared = build(axioms, options);
  EXPECT_EQ(declared.entities[declared.entity("Ball")].sufficiency, Sufficiency::Declared);
  EXPECT_TRUE(warnings_with(declared, "never-recognised").empty());
}

TEST(Warnings, ARootWithNothingBelowItIsRefusedUnlessSomethingIsSaidOfIt) {
  CatalogueOptions options = small_options();
  util::Location here;
  here.line = 3;
  options.entities = {Name("Alone", here)};
  const std::string others = defined("Ball", has("Round"));
  try {
    (void)build(others + ":Alone a owl:Class .\n", options);
    FAIL() << "there is nothing to recognise";
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "no-entities");
    EXPECT_EQ(error.diagnostic().location.line, 3U);
    EXPECT_THAT(error.diagnostic().hint, HasSubstr("Ball"));
  }
  EXPECT_EQ(build(others + sub("Alone", has("Round")), options).entities.size(), 1U);
  EXPECT_EQ(build(others + sub("Alone", does("Go")), options).entities.size(), 1U);
}

TEST(Warnings, SufficiencyIsRefusedWhereItWouldSwallowAnother) {
  CatalogueOptions options = small_options();
  options.sufficient = true;
  const Catalogue c = build(sub("Ball", ":Thing , " + has("Round") + " , " + does("Go")) +
                                sub("Coin", ":Thing , " + has("Round") + " , " + does("Stay")) +
                                sub("Box", ":Thing , " + has("Square") + " , " + does("Stay")),
                            options);
  EXPECT_EQ(warnings_with(c, "sufficient-refused").size(), 2U);
  EXPECT_FALSE(warnings_with(c, "sufficient-refused")[0]->axioms.empty());
  EXPECT_EQ(c.entities[c.entity("Ball")].sufficiency, Sufficiency::Never);
  EXPECT_EQ(c.entities[c.entity("Box")].sufficiency, Sufficiency::Declared);
  const auto alike = warnings_with(c, "indistinguishable");
  ASSERT_EQ(alike.size(), 1U);
  EXPECT_THAT(alike[0]->message,
              testing::AllOf(HasSubstr("'Ball'"), HasSubstr("'Coin'"), HasSubstr("different behaviours")));
}

TEST(Warnings, GoAndStayConflictOnlyWhereDeclaredDisjoint) {
  const std::string axioms = defined("Ball", has("Round")) + sub("Ball", does("Go") + " , " + does("Stay"));
  EXPECT_TRUE(warnings_with(build(axioms), "conflicting-prescriptions").empty());
  const Catalogue c = build(axioms + ":Go owl:disjointWith :Stay .\n");
  const auto found = warnings_with(c, "conflicting-prescriptions");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]->axioms.size(), 3U);
}

TEST(Warnings, UnassertedSubsumptionNamesWhatComesWithIt) {
  const Catalogue c = build(defined("Rolling", has("Round")) + sub("Rolling", does("Go")) +
                            sub("Ball", ":Thing , " + has("Round")) + sub("Marble", ":Ball"));
  const auto found = warnings_with(c, "unasserted-subsumption");
  ASSERT_EQ(found.size(), 1U) << "the marble follows from the ball";
  EXPECT_THAT(found[0]->message, testing::AllOf(HasSubstr("Every 'Ball' is taken for a 'Rolling'"),
                                                HasSubstr("'Ball' and 'Marble' "
                                                          "prescribe 'Go'")));
  EXPECT_EQ(found[0]->axioms.size(), 3U);
}

TEST(Warnings, FeaturesThatNobodyHasOrThatExcludeNothing) {
  const Catalogue c =
      build(defined("Ball", has("Round")) + sub("Oval", ":Feature") + sub("Star", ":Feature") +
            defined("Egg", has("Oval")) + sub("Ball", does("Go")) + sub("Egg", does("Go")));
  const auto unused = warnings_with(c, "unused-feature");
  ASSERT_EQ(unused.size(), 1U);
  EXPECT_THAT(unused[0]->message,
              testing::AllOf(HasSubstr("'Square'"), HasSubstr("'Star'"), testing::Not(HasSubstr("'Oval'"))));
  const auto idle = warnings_with(c, "excludes-nothing");
  ASSERT_EQ(idle.size(), 1U);
  EXPECT_THAT(idle[0]->message, HasSubstr("nothing is declared disjoint"));
}

TEST(Warnings, AnEntityThatPrescribesNothing) {
  const Catalogue c = build(defined("Ball", has("Round")));
  EXPECT_EQ(warnings_with(c, "no-prescription").size(), 1U);
}

TEST(Warnings, BehavioursThroughRoleChainsAreFound) {
  const Catalogue c =
      build(":entails a owl:ObjectProperty .\n:does owl:propertyChainAxiom ( :does :entails ) .\n" +
            defined("Ball", has("Round")) + sub("Ball", does("Go")) +
            sub("Go", "[ a owl:Restriction ; owl:onProperty :entails ; owl:someValuesFrom :Stay ]"));
  const Entailed* act = c.prescribes(c.entity("Ball"), c.behaviour("Stay"));
  ASSERT_NE(act, nullptr);
  EXPECT_EQ(act->axioms.size(), 3U);
}

TEST(Warnings, RootCausesOfWhatCannotExistComeFirst) {
  const Catalogue c =
      build(sub("Child", ":Broken") + sub("Broken", ":Thing , " + has("Round") + " , " + has("Square")) +
            sub("Fine", ":Thing"));
  const auto found = warnings_with(c, "unsatisfiable-entity");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0]->message, HasSubstr("'Broken'"));
  EXPECT_THAT(found[0]->message, testing::Not(HasSubstr("follows")));
  EXPECT_THAT(found[1]->message, HasSubstr("'Child'"));
  EXPECT_THAT(found[1]->message, HasSubstr("follows from what is said of 'Broken'"));
  EXPECT_EQ(found[1]->axioms.size(), found[0]->axioms.size() + 1);
}

}  // namespace
}  // namespace heed::awareness
