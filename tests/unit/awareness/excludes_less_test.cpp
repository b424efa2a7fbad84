// Symbols that exclude less than they could. What the warning claims is asked of a reasoner: with the narrow
// symbol the entity that it names cannot be, by the axioms of the warning alone; with the wide one it can.
#include "ontologies.h"

#include <heed/awareness/policy.h>
#include <heed/dl/reasoner.h>
#include <heed/owl/print.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using owl::ClassExpression;
using testing::HasSubstr;

const char* const shapes = R"(
Prefix(:=<http://example.org/s#>) Prefix(owl:=<http://www.w3.org/2002/07/owl#>)
Ontology(<http://example.org/s>
Declaration(Class(:Thing)) Declaration(Class(:Feature)) Declaration(Class(:Act))
Declaration(Class(:Tall)) Declaration(Class(:Short)) Declaration(Class(:Ball)) Declaration(Class(:Box))
Declaration(ObjectProperty(:hasFeature)) Declaration(ObjectProperty(:hasHeight))
Declaration(ObjectProperty(:hasWidth)) Declaration(ObjectProperty(:does))
SubObjectPropertyOf(:hasHeight :hasFeature)
SubObjectPropertyOf(:hasWidth :hasFeature)
SubClassOf(:Tall :Feature) SubClassOf(:Short :Feature)
SubClassOf(:Go :Act)
EquivalentClasses(:Box ObjectIntersectionOf(:Thing ObjectSomeValuesFrom(:hasHeight :Short)))
EquivalentClasses(:Tower ObjectIntersectionOf(:Thing ObjectSomeValuesFrom(:hasHeight :Tall)))
SubClassOf(:Thing ObjectSomeValuesFrom(:does :Go))
)";
const char* const functional = "FunctionalObjectProperty(:hasHeight)\n";
const char* const disjoint = "DisjointClasses(:Tall :Short)\n";

struct World {
  explicit World(const std::string& axioms) {
    util::Diagnostics diagnostics;
    util::Budget budget;
    const owl::Ontology ontology =
        owl::read(util::SourceText("s.ofn", shapes + axioms + ")"), {}, diagnostics);
    reasoner = std::make_unique<dl::Reasoner>(ontology, budget);
    CatalogueOptions options;
    options.entities = {"Thing"};
    options.features = {"Feature"};
    options.behaviours = {"Act"};
    options.feature_roles = {"hasFeature"};
    options.action_roles = {"does"};
    catalogue = build_catalogue(*reasoner, options, budget);
  }

  [[nodiscard]] Perception perception(const std::vector<std::string>& reported) const {
    PerceptionOptions options;
    for (const std::string& what : reported) options.reported.push_back({what, "", {}});
    return resolve_perception(catalogue, options);
  }
  [[nodiscard]] std::vector<Warning> warnings(const std::vector<std::string>& reported) const {
    return judge_perception(catalogue, perception(reported));
  }
  [[nodiscard]] ClassExpression some(const std::string& role, const std::string& filler) const {
    const owl::Ontology& o = catalogue.ontology;
    return ClassExpression::some({o.lookup(role).front(), false},
                                 ClassExpression::named(o.lookup(filler).front()));
  }
  [[nodiscard]] ClassExpression named(const std::string& name) const {
    return ClassExpression::named(catalogue.ontology.lookup(name).front());
  }

  std::unique_ptr<dl::Reasoner> reasoner{};
  Catalogue catalogue{};
};

TEST(ExcludesLess, ValuesOfAFunctionalSubRoleReportedByTheRoleAbove) {
  const World world(std::string(functional) + disjoint);
  const auto found = world.warnings({"Tall"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "excludes-less");
  EXPECT_THAT(found[0].message,
              testing::AllOf(HasSubstr("'tall'"), HasSubstr("'hasFeature'"), HasSubstr("'hasHeight'"),
                             HasSubstr("1 entity more, such as 'Box'")));
  EXPECT_THAT(found[0].hint, HasSubstr("what = \"hasHeight Tall\""));
  EXPECT_EQ(found[0].entities, std::vector<std::size_t>{world.catalogue.entity("Box")});
  // Nothing is claimed that does not follow, and nothing is invented for the wide symbol.
  const auto box = world.named("Box");
  EXPECT_FALSE(
      world.reasoner->satisfiable(ClassExpression::intersection({box, world.some("hasHeight", "Tall")})));
  EXPECT_TRUE(
      world.reasoner->satisfiable(ClassExpression::intersection({box, world.some("hasFeature", "Tall")})));
  EXPECT_TRUE(world.warnings({"hasHeight Tall"}).empty());
}

TEST(ExcludesLess, ItsAxiomsAloneRuleTheEntityOutAndNoneIsIdle) {
  const World world(std::string(functional) + disjoint);
  const auto found = world.warnings({"Tall"});
  ASSERT_EQ(found.size(), 1U);
  const auto holds = [&](std::vector<owl::AxiomId> axioms) {
    for (const owl::Axiom& axiom : world.catalogue.ontology.axioms())
      if (axiom.as<owl::Declaration>() != nullptr) axioms.push_back(axiom.id);
    util::Diagnostics diagnostics;
    util::Budget budget;
    const owl::Ontology part = owl::read(
        util::SourceText("part.ofn", owl::to_functional(axioms, world.catalogue.ontology)), {}, diagnostics);
    const dl::Reasoner reasoner(part, budget);
    const auto named = [&](const char* name) { return ClassExpression::named(part.lookup(name).front()); };
    const auto some = [&](const char* role, const char* filler) {
      return ClassExpression::some({part.lookup(role).front(), false}, named(filler));
    };
    return !reasoner.satisfiable(ClassExpression::intersection({named("Box"), some("hasHeight", "Tall")})) &&
           reasoner.entails_subsumption(some("hasHeight", "Tall"), some("hasFeature", "Tall"));
  };
  EXPECT_TRUE(holds(found[0].axioms));
  for (const owl::AxiomId gone : found[0].axioms) {
    auto fewer = found[0].axioms;
    std::erase(fewer, gone);
    EXPECT_FALSE(holds(fewer)) << owl::to_string(gone);
  }
}

TEST(ExcludesLess, NotWhereTheNarrowSymbolTellsNoMore) {
  EXPECT_TRUE(World(functional).warnings({"Tall"}).empty()) << "tall and short may go together";
  EXPECT_TRUE(World(disjoint).warnings({"Tall"}).empty()) << "a thing may have two heights";
  EXPECT_TRUE(World(std::string(functional) + disjoint + "FunctionalObjectProperty(:hasFeature)\n")
                  .warnings({"Tall"})
                  .empty())
      << "the wide one has one value already";
}

TEST(ExcludesLess, NotWhereSomethingHasItOtherwise) {
  const World world(std::string(functional) + disjoint +
                    "SubClassOf(:Mast :Thing) SubClassOf(:Mast ObjectSomeValuesFrom(:hasFeature :Tall))\n");
  EXPECT_TRUE(world.warnings({"Tall"}).empty()) << "the mast would no longer be seen to be tall";
}

TEST(ExcludesLess, IsSaidWhereCandidatesCountAndWhereTheScenarioReportsIt) {
  const World world(std::string(functional) + disjoint);
  PerceptionOptions options;
  util::Location here;
  here.line = 7;
  options.reported.push_back({Name("Tall", here), "", {}});
  const Perception perception = resolve_perception(world.catalogue, options);
  const auto notes_of = [&](PolicyOptions policy) {
    std::vector<util::Diagnostic> found;
    for (const util::Diagnostic& note : compile_policy(world.catalogue, perception, policy).notes)
      if (note.code == "excludes-less") found.push_back(note);
    return found;
  };
  PolicyOptions policy;
  EXPECT_TRUE(notes_of(policy).empty()) << "a definition rules nothing out";
  policy.kind = PolicyOptions::Kind::Identifying;
  const auto notes = notes_of(policy);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].severity, util::Severity::Warning);
  EXPECT_EQ(notes[0].location.line, 7U);
  EXPECT_THAT(notes[0].excerpt, HasSubstr("hasHeight Characteristics Functional"));
}

/// Values of two roles below one functional role exclude each other too, as the reasoner says.
TEST(ExcludesLess, ExclusionFollowsThroughACommonFunctionalRole) {
  const std::string wide = "SubClassOf(:Box ObjectSomeValuesFrom(:hasWidth :Short))\n";
  for (const bool one : {false, true}) {
    const World world(disjoint + wide + (one ? "FunctionalObjectProperty(:hasFeature)\n" : ""));
    const Catalogue& c = world.catalogue;
    const std::size_t height = c.feature("hasHeight Tall"), width = c.feature("hasWidth Short");
    EXPECT_EQ(c.exclusive.contains({std::min(height, width), std::max(height, width)}), one);
    EXPECT_EQ(world.reasoner->satisfiable(ClassExpression::intersection(
                  {world.some("hasHeight", "Tall"), world.some("hasWidth", "Short")})),
              !one);
  }
}

TEST(NotPerceived, SaysWhatIsReported) {
  const World world("");
  PolicyOptions policy;
  policy.kind = PolicyOptions::Kind::AtLeast;
  policy.over = {"hasHeight Short"};
  try {
    (void)compile_policy(world.catalogue, world.perception({"Thing", "Tall"}), policy);
    FAIL() << "it is not reported";
  } catch (const util::InputError& error) {
    EXPECT_EQ(error.diagnostic().code, "not-perceived");
    EXPECT_THAT(error.diagnostic().hint, HasSubstr("thing, tall"));
  }
}

}  // namespace
}  // namespace heed::awareness
