// All justifications of what is explained, against every subset of the axioms of small ontologies.
#include "ontologies.h"

#include <heed/awareness/explain.h>
#include <heed/dl/justifier.h>
#include <heed/dl/reasoner.h>
#include <heed/owl/print.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using Axioms = std::vector<owl::AxiomId>;
using testing::HasSubstr;

class Explained {
 public:
  explicit Explained(const std::string& axioms) {
    util::Diagnostics diagnostics;
    std::string declared;
    for (const char* name :
         {"Ball", "Toy", "Round", "Rolling", "Broken", "Child", "Red", "Blue", "Green", "Go"})
      declared += std::string("Declaration(Class(:") + name + "))\n";
    const owl::Ontology ontology = owl::read(
        util::SourceText(
            "j.ofn",
            "Prefix(:=<http://example.org/j#>)\nOntology(<http://example.org/j>\n"
            "Declaration(Class(:Thing)) Declaration(Class(:Feature)) Declaration(Class(:Act))\n"
            "Declaration(ObjectProperty(:has)) Declaration(ObjectProperty(:does))\n"
            "Declaration(ObjectProperty(:must)) SubClassOf(:Go :Act) SubClassOf(:Round :Feature)\n" +
                declared + axioms + ")"),
        {}, diagnostics);
    const dl::Reasoner reasoner(ontology, budget_);
    CatalogueOptions options;
    options.entities = {"Thing"};
    options.features = {"Feature"};
    options.behaviours = {"Act"};
    options.feature_roles = {"has"};
    options.action_roles = {"does", "must"};
    catalogue = build_catalogue(reasoner, options, budget_);
  }

  [[nodiscard]] Explanation entity(const std::string& name, std::size_t most = 100) {
    return all(explain_entity(catalogue, catalogue.entity(Name(name))), most);
  }
  [[nodiscard]] Explanation all(Explanation explanation, std::size_t most) {
    dl::Justifier justifier(catalogue.ontology, budget_);
    justify_all(catalogue, justifier, most, explanation);
    return explanation;
  }

  /// Every minimal set of logical axioms that entails one of \p asked, by trying all sets.
  [[nodiscard]] std::set<Axioms> by_trying(const std::vector<Inclusion>& asked) {
    Axioms logical;
    for (const owl::Axiom& axiom : catalogue.ontology.axioms())
      if (axiom.as<owl::Declaration>() == nullptr) logical.push_back(axiom.id);
    std::vector<std::uint32_t> minimal;
    std::vector<std::uint32_t> order(std::size_t{1} << logical.size());
    for (std::uint32_t bits = 0; bits < order.size(); ++bits) order[bits] = bits;
    std::stable_sort(order.begin(), order.end(),
                     [](std::uint32_t a, std::uint32_t b) { return std::popcount(a) < std::popcount(b); });
    std::set<Axioms> result;
    for (const std::uint32_t bits : order) {
      const bool more =
          std::any_of(minimal.begin(), minimal.end(), [&](std::uint32_t m) { return (bits & m) == m; });
      Axioms some;
      for (std::size_t i = 0; i < logical.size(); ++i)
        if (((bits >> i) & 1U) != 0) some.push_back(logical[i]);
      if (more || !entails(some, asked)) continue;
      minimal.push_back(bits);
      result.insert(some);
    }
    return result;
  }

  /// Reads the axioms alone, as a document of their own.
  [[nodiscard]] bool entails(Axioms axioms, const std::vector<Inclusion>& asked) {
    for (const owl::Axiom& axiom : catalogue.ontology.axioms())
      if (axiom.as<owl::Declaration>() != nullptr) axioms.push_back(axiom.id);
    util::Diagnostics diagnostics;
    const owl::Ontology part = owl::read(
        util::SourceText("part.ofn", owl::to_functional(axioms, catalogue.ontology)), {}, diagnostics);
    const dl::Reasoner reasoner(part, budget_);
    return std::any_of(asked.begin(), asked.end(), [&](const Inclusion& inclusion) {
      return reasoner.entails_subsumption(moved(inclusion.sub, part), moved(inclusion.super, part));
    });
  }

  Catalogue catalogue{};

 private:
  /// The same expression over the names of another ontology.
  [[nodiscard]] owl::ClassExpression moved(const owl::ClassExpression& e, const owl::Ontology& to) const {
    using Kind = owl::ClassExpression::Kind;
    const auto name = [&](owl::Iri iri) {
      return to.find(catalogue.ontology.text(iri)).value_or(owl::Iri{0});
    };
    if (e.is_nothing() || e.is_thing()) return e;
    if (e.is_named()) return owl::ClassExpression::named(name(e.iri()));
    if (e.kind() == Kind::Some)
      return owl::ClassExpression::some({name(e.property().iri), false}, moved(e.filler(), to));
    if (e.kind() != Kind::Intersection) throw std::logic_error("not used here");
    std::vector<owl::ClassExpression> parts;
    for (const auto& part : e.operands()) parts.push_back(moved(part, to));
    return owl::ClassExpression::intersection(parts);
  }

  util::Budget budget_{};
};

std::set<Axioms> sets_of(const ExplanationStep& step) {
  std::set<Axioms> result;
  for (const Justification& justification : step.all) {
    Axioms ids;
    for (const AxiomText& axiom : justification.axioms) ids.push_back(axiom.id);
    result.insert(ids);
  }
  return result;
}

const char* const many = R"(
SubClassOf(:Ball :Toy) SubClassOf(:Toy :Thing) SubClassOf(:Ball :Thing)
SubClassOf(:Ball ObjectSomeValuesFrom(:has :Round)) SubClassOf(:Toy ObjectSomeValuesFrom(:has :Round))
SubClassOf(:Ball ObjectSomeValuesFrom(:must :Go)) SubClassOf(:Toy ObjectSomeValuesFrom(:does :Go))
SubObjectPropertyOf(:must :does)
)";

TEST(JustifyAll, AreThoseThatTryingAllSetsFinds) {
  Explained world(many);
  const Explanation ball = world.entity("Ball");
  std::size_t judged = 0, several = 0;
  for (const ExplanationStep& step : ball.steps) {
    ASSERT_FALSE(step.entailed.empty()) << step.sentence;
    EXPECT_TRUE(step.all_listed);
    EXPECT_EQ(sets_of(step), world.by_trying(step.entailed)) << step.sentence;
    ++judged;
    several += step.all.size() > 1 ? 1U : 0U;
    for (std::size_t i = 1; i < step.all.size(); ++i)
      EXPECT_LE(step.all[i - 1].axioms.size(), step.all[i].axioms.size()) << "short ones first";
  }
  EXPECT_GE(judged, 3U);
  EXPECT_GE(several, 2U);
}

TEST(JustifyAll, ACapIsKeptAndSaid) {
  Explained world(many);
  const Explanation ball = world.entity("Ball", 1);
  bool cut = false;
  for (const ExplanationStep& step : ball.steps) {
    EXPECT_LE(step.all.size(), 1U);
    cut = cut || !step.all_listed;
  }
  EXPECT_TRUE(cut);
  EXPECT_THAT(to_text(ball), HasSubstr("there are more"));
}

/// The child is broken in its own way, by three axioms, and because of its parent, by fewer.
TEST(JustifyAll, RootCausesComeBeforeWhatFollows) {
  Explained world(R"(
SubClassOf(:Broken :Thing) SubClassOf(:Broken :Round) DisjointClasses(:Broken :Round)
SubClassOf(:Child :Broken) SubClassOf(:Child :Red) SubClassOf(:Red :Blue) SubClassOf(:Blue :Green)
DisjointClasses(:Red :Green)
)");
  const Explanation child = world.entity("Child");
  const ExplanationStep& step = child.steps.front();
  ASSERT_THAT(step.sentence, HasSubstr("Nothing can be one"));
  EXPECT_EQ(sets_of(step), world.by_trying(step.entailed));
  ASSERT_EQ(step.all.size(), 2U);
  EXPECT_EQ(step.all[0].axioms.size(), 4U);
  EXPECT_EQ(step.all[0].derived_from, "");
  EXPECT_EQ(step.all[1].axioms.size(), 3U) << "shorter, and yet behind";
  EXPECT_THAT(step.all[1].derived_from, HasSubstr("nothing can be a 'Broken'"));
  const ExplanationStep broken = world.entity("Broken").steps.front();
  ASSERT_EQ(broken.all.size(), 1U);
  EXPECT_EQ(broken.all[0].derived_from, "");
}

/// What is prescribed by an accident says which one.
TEST(JustifyAll, WhatFollowsFromAnUnassertedSubsumptionSaysSo) {
  Explained world(R"(
SubClassOf(:Rolling :Thing) EquivalentClasses(:Rolling ObjectSomeValuesFrom(:has :Round))
SubClassOf(:Rolling ObjectSomeValuesFrom(:does :Go))
SubClassOf(:Ball :Thing) SubClassOf(:Ball ObjectSomeValuesFrom(:has :Round))
)");
  const Explanation ball = world.entity("Ball");
  const auto prescribes = std::find_if(ball.steps.begin(), ball.steps.end(), [](const ExplanationStep& step) {
    return step.sentence.find("prescribes") != std::string::npos;
  });
  ASSERT_NE(prescribes, ball.steps.end());
  ASSERT_EQ(prescribes->all.size(), 1U);
  EXPECT_EQ(prescribes->all[0].derived_from, "every 'Ball' is taken for a 'Rolling'");
}

/// Each formula of the example's knowledge base: its axioms alone entail it, and without any one no longer.
TEST(Sigma, EveryFormulaOfTheStopSignExampleIsMinimallyJustified) {
  const Catalogue catalogue = test::traffic_signs();
  const Perception perception = resolve_perception(catalogue, {});
  const Recognition recognition = compile_policy(catalogue, perception, {});
  SigmaOptions options;
  options.disjointness = true;
  util::Budget budget;
  dl::Justifier justifier(catalogue.ontology, budget);
  std::size_t judged = 0;
  for (const SigmaFormula& formula : build_sigma(catalogue, perception, recognition, options)) {
    ASSERT_FALSE(formula.entailed.empty()) << formula.sentence;
    const auto holds = [&](const Axioms& axioms) {
      return std::any_of(formula.entailed.begin(), formula.entailed.end(), [&](const Inclusion& asked) {
        return justifier.subsumption_within(axioms, asked.sub, asked.super).has_value();
      });
    };
    EXPECT_TRUE(holds(formula.axioms)) << formula.sentence;
    for (const owl::AxiomId gone : formula.axioms) {
      auto fewer = formula.axioms;
      std::erase(fewer, gone);
      EXPECT_FALSE(holds(fewer)) << formula.sentence << " without " << owl::to_string(gone);
    }
    ++judged;
  }
  EXPECT_GT(judged, 200U);
}

}  // namespace
}  // namespace heed::awareness
