#include "support.h"

#include <heed/owl/vocabulary.h>
#include <heed/util/random.h>

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace heed::dl::test {
namespace {

using owl::ClassExpression;

/// The textbook completion for EL with role inclusions and composition, on sets of names, until nothing
/// changes: slow, and sharing nothing with the code under test. \cite baader.05.ijcai
struct NaiveEl {
  struct Axiom {
    enum Kind { Sub, And, Some, Left, RoleSub, Chain } kind;
    int a, b, c;  ///< Sub a<b; And a&b<c; Some a < some b.c; Left some a.b < c; RoleSub a<b; Chain a o b < c.
  };
  NaiveEl(int names, int roles, const std::vector<Axiom>& axioms) : below(names), links(roles) {
    for (int i = 0; i < names; ++i) below[i].insert(i);
    for (bool changed = true; changed;) {
      changed = false;
      for (const Axiom& x : axioms) changed |= apply(x, names);
    }
  }
  bool apply(const Axiom& x, int names) {
    bool changed = false;
    if (x.kind == Axiom::RoleSub)
      for (const auto& edge : std::set(links[x.a])) changed |= links[x.b].insert(edge).second;
    if (x.kind == Axiom::Chain)
      for (const auto& [p, q] : std::set(links[x.a]))
        for (const auto& [r, s] : std::set(links[x.b]))
          if (q == r) changed |= links[x.c].insert({p, s}).second;
    if (x.kind == Axiom::Left)
      for (const auto& [p, q] : links[x.a])
        if (below[q].contains(x.b)) changed |= below[p].insert(x.c).second;
    for (int i = 0; i < names; ++i) {
      if (x.kind == Axiom::Sub && below[i].contains(x.a)) changed |= below[i].insert(x.b).second;
      if (x.kind == Axiom::And && below[i].contains(x.a) && below[i].contains(x.b))
        changed |= below[i].insert(x.c).second;
      if (x.kind == Axiom::Some && below[i].contains(x.a)) changed |= links[x.b].insert({i, x.c}).second;
    }
    return changed;
  }
  std::vector<std::set<int>> below;
  std::vector<std::set<std::pair<int, int>>> links;
};

std::string turtle_of(const NaiveEl::Axiom& x) {
  const auto c = [](int i) { return ":C" + std::to_string(i); };
  const auto r = [](int i) { return ":r" + std::to_string(i); };
  using Kind = NaiveEl::Axiom;
  switch (x.kind) {
    case Kind::Sub:
      return c(x.a) + " rdfs:subClassOf " + c(x.b) + " .\n";
    case Kind::And:
      return "[owl:intersectionOf (" + c(x.a) + " " + c(x.b) + ")] rdfs:subClassOf " + c(x.c) + " .\n";
    case Kind::Some:
      return c(x.a) + " rdfs:subClassOf [owl:onProperty " + r(x.b) + "; owl:someValuesFrom " + c(x.c) +
             "] .\n";
    case Kind::Left:
      return "[owl:onProperty " + r(x.a) + "; owl:someValuesFrom " + c(x.b) + "] rdfs:subClassOf " + c(x.c) +
             " .\n";
    case Kind::RoleSub:
      return r(x.a) + " rdfs:subPropertyOf " + r(x.b) + " .\n";
    case Kind::Chain:
      return r(x.c) + " owl:propertyChainAxiom (" + r(x.a) + " " + r(x.b) + ") .\n";
  }
  return {};
}

TEST(Reasoner, AgreesWithTheTextbookOnRandomOntologies) {
  constexpr int names = 8, roles = 3;
  std::size_t entailed = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    util::CounterRandom random(seed, 0);
    std::vector<NaiveEl::Axiom> axioms;
    std::string text;
    for (int r = 0; r < roles; ++r) text += ":r" + std::to_string(r) + " a owl:ObjectProperty .\n";
    for (int c = 0; c < names; ++c) text += ":C" + std::to_string(c) + " a owl:Class .\n";
    for (int i = 0; i < 14; ++i) {
      const auto kind = static_cast<NaiveEl::Axiom::Kind>(random.below(i % 3 == 0 ? 6 : 4));
      const auto pick = [&](bool role) { return static_cast<int>(random.below(role ? roles : names)); };
      const bool on_roles = kind >= NaiveEl::Axiom::RoleSub;
      axioms.push_back({kind, pick(on_roles || kind == NaiveEl::Axiom::Left),
                        pick(on_roles || kind == NaiveEl::Axiom::Some), pick(kind == NaiveEl::Axiom::Chain)});
      text += turtle_of(axioms.back());
    }
    const NaiveEl naive(names, roles, axioms);
    const Asked asked(text);
    for (int a = 0; a < names; ++a)
      for (int b = 0; b < names; ++b) {
        const bool expected = naive.below[a].contains(b);
        entailed += expected && a != b;
        ASSERT_EQ(asked.below("C" + std::to_string(a), "C" + std::to_string(b)), expected)
            << text << a << " " << b;
      }
  }
  EXPECT_GT(entailed, 1000U);
}

TEST(Reasoner, TaxonomyHasDirectEdgesAndGroups) {
  const Asked a(
      ":A rdfs:subClassOf :B, :C. :B rdfs:subClassOf :C. :D owl:equivalentClass :B. :U rdfs:subClassOf "
      "owl:Nothing. :E a owl:Class.");
  const Taxonomy& t = a.reasoner.taxonomy();
  const auto node = [&](const std::string& name) { return t.node_of(a.iri(name)); };
  EXPECT_EQ(node("B"), node("D"));
  EXPECT_EQ(node("U"), 1U);
  EXPECT_THAT(t.nodes[node("A")].parents, testing::ElementsAre(node("B")));
  EXPECT_THAT(t.nodes[node("B")].parents, testing::ElementsAre(node("C")));
  EXPECT_THAT(t.nodes[0].children, testing::UnorderedElementsAre(node("C"), node("E")));
  EXPECT_THAT(t.nodes[1].parents, testing::UnorderedElementsAre(node("A"), node("E")));
  EXPECT_THAT(t.nodes[node("B")].classes, testing::SizeIs(2));
}

TEST(Reasoner, AnswersQuestionsOverComplexExpressions) {
  const Asked a(
      ":f a owl:ObjectProperty, owl:FunctionalProperty; rdfs:range :R. :s rdfs:subPropertyOf :f. :Stop "
      "owl:equivalentClass "
      "[owl:intersectionOf (:Sign [owl:onProperty :f; owl:someValuesFrom :Red])]. :Red owl:disjointWith "
      ":Blue. :x a :Stop.");
  const owl::ObjectProperty f{a.iri("f")}, s{a.iri("s")};
  const auto seen = ClassExpression::intersection({a.cls("Sign"), ClassExpression::some(s, a.cls("Red"))});
  EXPECT_TRUE(a.reasoner.entails_subsumption(seen, a.cls("Stop")));
  EXPECT_FALSE(a.reasoner.entails_subsumption(ClassExpression::some(s, a.cls("Red")), a.cls("Stop")));
  EXPECT_TRUE(a.reasoner.entails_subsumption(
      a.cls("Stop"), ClassExpression::some(f, ClassExpression::intersection({a.cls("Red"), a.cls("R")}))));
  EXPECT_FALSE(a.reasoner.satisfiable(
      ClassExpression::intersection({a.cls("Stop"), ClassExpression::some(s, a.cls("Blue"))})));
  EXPECT_TRUE(a.reasoner.entails_subsumption(
      a.cls("Stop"), ClassExpression::complement(ClassExpression::some(f, a.cls("Blue")))));
  EXPECT_TRUE(a.reasoner.entails_subsumption(ClassExpression::thing(), ClassExpression::only(s, a.cls("R"))));
  EXPECT_TRUE(a.reasoner.entails_subsumption(a.cls("Stop"), ClassExpression::only(f, a.cls("Red"))));
  EXPECT_FALSE(a.reasoner.entails_subsumption(a.cls("Sign"), ClassExpression::only(f, a.cls("Red"))));
  const auto supers = a.reasoner.superclasses(seen);
  ASSERT_TRUE(supers);
  EXPECT_THAT(*supers, testing::UnorderedElementsAre(a.iri("Sign"), a.iri("Stop")));
  EXPECT_TRUE(a.reasoner.entails(owl::ClassAssertion{ClassExpression::some(f, a.cls("Red")), a.iri("x")}));
  EXPECT_TRUE(a.reasoner.entails(owl::SubObjectPropertyOf{{s}, f}));
  EXPECT_FALSE(a.reasoner.entails(owl::SubObjectPropertyOf{{f}, s}));
  EXPECT_TRUE(a.reasoner.entails(owl::ObjectPropertyCharacteristic{owl::Characteristic::Functional, s}));
}

/// Every question about C is the question about a class that is defined as C.
TEST(Reasoner, QuestionsAgreeWithDefinedClasses) {
  const std::string base =
      ":f a owl:ObjectProperty, owl:FunctionalProperty. :g rdfs:subPropertyOf :f. :h a owl:ObjectProperty. "
      ":A rdfs:subClassOf :B. "
      "[owl:onProperty :f; owl:someValuesFrom :B] rdfs:subClassOf :P. [owl:intersectionOf (:P :C)] "
      "rdfs:subClassOf :Q. "
      ":C owl:disjointWith :D. :B rdfs:subClassOf [owl:onProperty :h; owl:someValuesFrom :C]. ";
  const Asked plain(base);
  const char* names[] = {"A", "B", "C", "D", "P", "Q"};
  const char* roles[] = {"f", "g", "h"};
  for (const char* x : names)
    for (const char* r : roles)
      for (const char* y : names)
        for (const char* z : names) {
          const std::string text = std::string(":N owl:equivalentClass [owl:intersectionOf (:") + x +
                                   " [owl:onProperty :" + r + "; owl:someValuesFrom :" + y +
                                   "] [owl:onProperty :g; owl:someValuesFrom :" + z + "])] .";
          const Asked defined(base + text);
          const auto question = ClassExpression::intersection(
              {plain.cls(x), ClassExpression::some({plain.iri(r)}, plain.cls(y)),
               ClassExpression::some({plain.iri("g")}, plain.cls(z))});
          ASSERT_EQ(plain.reasoner.satisfiable(question), defined.satisfiable("N")) << text;
          for (const char* super : names)
            ASSERT_EQ(plain.reasoner.entails_subsumption(question, plain.cls(super)),
                      defined.below("N", super))
                << text << super;
        }
}

}  // namespace
}  // namespace heed::dl::test
