#include "ontologies.h"

#include <heed/awareness/explain.h>
#include <heed/awareness/sigma.h>
#include <heed/logic/parse.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAre;

struct Knowledge {
  Catalogue catalogue;
  Perception perception;
  Recognition recognition;
  std::vector<SigmaFormula> sigma;
};

Knowledge compile(Catalogue catalogue, const PerceptionOptions& reported, const PolicyOptions& policy,
                  const SigmaOptions& options = {}) {
  Knowledge result;
  result.catalogue = std::move(catalogue);
  result.perception = resolve_perception(result.catalogue, reported);
  result.recognition = compile_policy(result.catalogue, result.perception, policy);
  result.sigma = build_sigma(result.catalogue, result.perception, result.recognition, options);
  return result;
}

std::vector<std::string> printed(const Knowledge& knowledge, bool inherited) {
  std::vector<std::string> result;
  for (const SigmaFormula& formula : knowledge.sigma)
    if (formula.inherited == inherited) result.push_back(logic::to_string(formula.formula));
  return result;
}

std::string text(const char* formula) {
  return logic::to_string(logic::parse(formula));
}

Knowledge yield() {
  PerceptionOptions reported;
  for (const char* name : {"sign", "red", "triangle"}) reported.reported.push_back({name, "", {}});
  return compile(test::yield_roles(), reported, {});
}

TEST(Sigma, OfTheYieldSignIsThePublishedOne) {
  const Knowledge k = yield();
  EXPECT_THAT(printed(k, false),
              UnorderedElementsAre(text("G(sign & red & triangle -> yield)"), text("G(yield -> X giveWay)"),
                                   text("G(sign -> X slowDown)"), text("G(yield -> sign)")));
  EXPECT_THAT(printed(k, true), UnorderedElementsAre(text("G(yield -> X slowDown)")));
  EXPECT_THAT(k.sigma.back().sentence, HasSubstr("inherited: every 'yield sign' is a 'traffic sign'"));
}

TEST(Sigma, NamesTheRoleAssertionsBehindEachFormula) {
  const Knowledge k = yield();
  for (const SigmaFormula& formula : k.sigma) {
    const auto texts = axiom_texts(k.catalogue, formula.axioms);
    ASSERT_FALSE(texts.empty());
    for (const AxiomText& axiom : texts) EXPECT_GT(axiom.location.line, 0U);
    if (formula.kind == SigmaKind::Recognition) {
      EXPECT_EQ(texts.size(), 3U);  // hasColor, hasShape, isSubClass
    }
  }
}

Knowledge stop(PolicyOptions::Kind kind) {
  PerceptionOptions reported;
  for (const char* name : {"Sign", "Red", "Octagon"}) reported.reported.push_back({name, "", {}});
  reported.reported.push_back({"StopSign", "", {}});
  PolicyOptions policy;
  policy.kind = kind;
  policy.entities = {"StopSign"};
  if (kind == PolicyOptions::Kind::AtLeast) {
    policy.over = {"Sign", "Red", "Octagon"};
    policy.direct = false;
  }
  if (kind == PolicyOptions::Kind::Tree) policy.order = {"Sign", "Red"};
  return compile(test::traffic_signs(), reported, policy);
}

TEST(Sigma, OfTheCaseStudyHasOneFormulaPerPairOfFeatures) {
  const Knowledge k = stop(PolicyOptions::Kind::AtLeast);
  EXPECT_THAT(printed(k, false),
              UnorderedElementsAre(text("G(sign & red -> stop_sign)"), text("G(sign & octagon -> stop_sign)"),
                                   text("G(red & octagon -> stop_sign)"), text("G(stop_sign -> X halt)"),
                                   text("G(stop_sign -> X give_way)"), text("G(sign -> X slow_down)"),
                                   text("G(stop_sign -> priority_sign)"), text("G(priority_sign -> sign)"),
                                   text("G(halt -> slow_down)"), text("G(give_way -> slow_down)")));
}

TEST(Sigma, DefinitionOfTheCaseStudyUsesWhatIsPerceived) {
  EXPECT_THAT(printed(stop(PolicyOptions::Kind::Definition), false),
              testing::Contains(text("G(sign & red & octagon -> stop_sign)")));
}

TEST(CaseStudy, TheWholeReadingIsNoFeature) {
  const Knowledge k = stop(PolicyOptions::Kind::Full);
  const RecognisedEntity* entity = k.recognition.find_entity(k.catalogue.entity("StopSign"));
  ASSERT_NE(entity, nullptr);
  EXPECT_EQ(entity->formula, logic::name("stop_sign"));
  EXPECT_TRUE(k.perception.perceivable[k.catalogue.feature("Red")]);
  const PrescribedBehaviour* slow = k.recognition.find_behaviour(k.catalogue.behaviour("SlowDown"));
  ASSERT_NE(slow, nullptr);
  EXPECT_EQ(slow->formula, logic::name("recognised_sign"));
}

TEST(CaseStudy, TheTreeNeedsOneBitOfMemory) {
  const Knowledge k = stop(PolicyOptions::Kind::Tree);
  ASSERT_EQ(k.recognition.memories.size(), 1U);
  EXPECT_EQ(k.recognition.memories[0].update, logic::name("sign"));
  EXPECT_EQ(k.recognition.find_entity(k.catalogue.entity("StopSign"))->formula,
            logic::name(k.recognition.memories[0].name) && logic::name("red"));
}

TEST(Catalogue, WithAllFeaturesReportedEveryDefinitionIsASigmaFormula) {
  const Knowledge k = compile(test::traffic_signs(), {}, {}, {true});
  std::size_t leaves = 0, recognitions = 0, disjoint = 0;
  for (const Entity& entity : k.catalogue.entities) leaves += entity.is_leaf() ? 1 : 0;
  for (const SigmaFormula& formula : k.sigma) {
    recognitions += formula.kind == SigmaKind::Recognition ? 1 : 0;
    disjoint += formula.kind == SigmaKind::Disjointness ? 1 : 0;
    EXPECT_FALSE(formula.sentence.empty());
    EXPECT_FALSE(formula.axioms.empty()) << formula.sentence;
  }
  EXPECT_GE(recognitions, leaves);
  EXPECT_GT(disjoint, 0U);
  EXPECT_TRUE(k.recognition.notes.empty());
}

TEST(Explain, LeadsFromAReactionToAxiomsWithLines) {
  const Knowledge k = stop(PolicyOptions::Kind::AtLeast);
  const std::size_t halt = k.catalogue.behaviour("Halt");
  const Explanation yes = explain_reaction(k.catalogue, k.recognition, halt, {"red", "octagon", "unrelated"});
  EXPECT_TRUE(yes.holds);
  const std::string shown = to_text(yes);
  EXPECT_THAT(shown, testing::AllOf(HasSubstr("'halt' is prescribed"), HasSubstr("'octagon', 'red' suffices"),
                                    HasSubstr("traffic-signs.owl:"), testing::Not(HasSubstr("unrelated"))));
  const Explanation no = explain_reaction(k.catalogue, k.recognition, halt, {"sign"});
  EXPECT_FALSE(no.holds);
}

TEST(Explain, SaysWhatIsMissing) {
  const Knowledge k = stop(PolicyOptions::Kind::AtLeast);
  const Explanation e =
      explain_recognition(k.catalogue, k.recognition, k.catalogue.entity("StopSign"), {"red"});
  EXPECT_FALSE(e.holds);
  EXPECT_THAT(to_text(e), HasSubstr("lacks 'octagon'"));
}

TEST(Explain, DescribesEntitiesBehavioursFormulasAndWarnings) {
  const Knowledge k = stop(PolicyOptions::Kind::AtLeast);
  const std::string entity = to_text(explain_entity(k.catalogue, k.catalogue.entity("StopSign")));
  EXPECT_THAT(entity, testing::AllOf(HasSubstr("It is a 'priority sign'"), HasSubstr("main_colour 'red'"),
                                     HasSubstr("It prescribes to 'give way'")));
  const std::string behaviour = to_text(explain_behaviour(k.catalogue, k.catalogue.behaviour("Halt")));
  EXPECT_THAT(behaviour,
              testing::AllOf(HasSubstr("special way to 'slow down'"), HasSubstr("'no entry' prescribes it")));
  EXPECT_THAT(to_text(explain_formula(k.catalogue, k.sigma[0])), HasSubstr("(recognition)"));
}

}  // namespace
}  // namespace heed::awareness
