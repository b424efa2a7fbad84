#include "support.h"

namespace heed::dl::test {
namespace {

/// `:X some P Y` and the like, to keep the inputs readable.
std::string some(const std::string& p, const std::string& c) {
  return "[owl:onProperty :" + p + "; owl:someValuesFrom " + c + "]";
}
std::string only(const std::string& p, const std::string& c) {
  return "[owl:onProperty :" + p + "; owl:allValuesFrom " + c + "]";
}

TEST(Rules, ConjunctionsAndExistentials) {
  const Asked a(":A rdfs:subClassOf :B, " + some("r", ":C") +
                ". :C rdfs:subClassOf :D. :Q owl:equivalentClass [owl:intersectionOf (:B " + some("r", ":D") +
                ")]. :E rdfs:subClassOf :Q.");
  EXPECT_TRUE(a.below("A", "Q"));
  EXPECT_TRUE(a.below("E", "B"));
  EXPECT_FALSE(a.below("B", "Q"));
  EXPECT_TRUE(a.reasoner.incomplete().empty());
}

TEST(Rules, BottomTravelsAgainstExistentials) {
  const Asked a(":A owl:disjointWith :B. :C rdfs:subClassOf :A, :B. :D rdfs:subClassOf " + some("r", ":C") +
                ". :E rdfs:subClassOf :A.");
  EXPECT_FALSE(a.satisfiable("C"));
  EXPECT_FALSE(a.satisfiable("D"));
  EXPECT_TRUE(a.satisfiable("E"));
  EXPECT_TRUE(a.below("D", "E"));
  EXPECT_TRUE(a.reasoner.consistent());
}

TEST(Rules, NaryDisjointnessIsPairwise) {
  const Asked a(
      "[] a owl:AllDisjointClasses; owl:members (:A :B :C). :X rdfs:subClassOf :A, :C. :U "
      "owl:disjointUnionOf (:V :W). "
      ":Y rdfs:subClassOf :V, :W. :Z rdfs:subClassOf :V.");
  EXPECT_FALSE(a.satisfiable("X"));
  EXPECT_FALSE(a.satisfiable("Y"));
  EXPECT_TRUE(a.below("Z", "U"));
  EXPECT_EQ(a.reasoner.incomplete().size(), 1U);
}

TEST(Rules, DomainsRangesAndHierarchies) {
  const Asked a(
      ":r a owl:ObjectProperty; rdfs:domain :D; rdfs:range :R. :s rdfs:subPropertyOf :r. :A "
      "rdfs:subClassOf " +
      some("s", ":B") + ". " + some("r", "[owl:intersectionOf (:B :R)]") + " rdfs:subClassOf :Q.");
  EXPECT_TRUE(a.below("A", "D"));
  EXPECT_TRUE(a.below("A", "Q"));
  EXPECT_FALSE(a.below("B", "R"));
}

TEST(Rules, ChainsAndTransitivity) {
  const Asked a(":t a owl:TransitiveProperty. :u owl:propertyChainAxiom (:t :v :w). :A rdfs:subClassOf " +
                some("t", ":B") + ". :B rdfs:subClassOf " + some("t", ":C") + ". :C rdfs:subClassOf " +
                some("v", some("w", ":E")) + ". " + some("t", ":C") + " rdfs:subClassOf :P. " +
                some("u", ":E") + " rdfs:subClassOf :Q.");
  EXPECT_TRUE(a.below("A", "P"));
  EXPECT_TRUE(a.below("A", "Q"));
  EXPECT_TRUE(a.below("B", "Q"));
  EXPECT_FALSE(a.below("C", "Q"));
}

/// A: some r B, some s C; both below the functional f: one successor that is B and C.
TEST(Rules, FunctionalPropertiesMergeSuccessors) {
  const std::string base =
      ":f a owl:ObjectProperty. :r rdfs:subPropertyOf :f. :s rdfs:subPropertyOf :f. :A rdfs:subClassOf " +
      some("r", ":B") + ", " + some("s", ":C") + ". " + some("s", ":B") + " rdfs:subClassOf :Q. ";
  EXPECT_FALSE(Asked(base).below("A", "Q"));
  EXPECT_TRUE(Asked(base + ":f a owl:FunctionalProperty.").below("A", "Q"));
  EXPECT_FALSE(Asked(base + ":f a owl:FunctionalProperty. :B owl:disjointWith :C.").satisfiable("A"));
  EXPECT_TRUE(Asked(base + ":A rdfs:subClassOf [owl:onProperty :f; owl:maxCardinality 1].").below("A", "Q"));
}

TEST(Rules, UniversalsOnTheRight) {
  const Asked a(":A rdfs:subClassOf " + some("r", ":B") + ", " + only("r", ":C") + ". " +
                some("r", "[owl:intersectionOf (:B :C)]") + " rdfs:subClassOf :Q. :N rdfs:subClassOf " +
                some("r", ":B") + ", [owl:complementOf " + some("r", "owl:Thing") + "].");
  EXPECT_TRUE(a.below("A", "Q"));
  EXPECT_FALSE(a.satisfiable("N"));
  const Asked t(":t a owl:TransitiveProperty. :A rdfs:subClassOf " + only("t", ":C") + ", " +
                some("t", some("t", ":B")) + ". " + some("t", "[owl:intersectionOf (:B :C)]") +
                " rdfs:subClassOf :Q.");
  EXPECT_TRUE(t.below("A", "Q"));
}

TEST(Rules, InversesReachTheSuccessor) {
  const Asked a(":r owl:inverseOf :i. :A rdfs:subClassOf " + some("r", ":B") + ". " + some("i", ":A") +
                " rdfs:subClassOf :C. " + some("r", "[owl:intersectionOf (:B :C)]") + " rdfs:subClassOf :Q.");
  EXPECT_TRUE(a.below("A", "Q"));
  EXPECT_FALSE(a.below("B", "C"));
}

TEST(Rules, UnionsAndEnumerationsOnTheLeftSplit) {
  const Asked a(
      "[owl:unionOf (:A :B)] rdfs:subClassOf :C. :E owl:equivalentClass [a owl:Class; owl:oneOf (:x :y)]. :E "
      "rdfs:subClassOf :F.");
  EXPECT_TRUE(a.below("A", "C"));
  EXPECT_TRUE(a.below("B", "C"));
  EXPECT_TRUE(a.is_a("x", "F"));
  EXPECT_EQ(a.reasoner.incomplete().size(), 1U);
}

TEST(Rules, IndividualsAreNominals) {
  const Asked a(
      ":r a owl:ObjectProperty. :x a :A; :r :y. :y a :B. " + some("r", ":B") +
      " rdfs:subClassOf :Q. :x owl:sameAs :z. :z a :C. "
      ":V rdfs:subClassOf [owl:onProperty :r; owl:hasValue :y]. :r a owl:FunctionalProperty. :x :r :w.");
  EXPECT_TRUE(a.is_a("x", "Q"));
  EXPECT_TRUE(a.is_a("x", "C"));
  EXPECT_TRUE(a.below("V", "Q"));
  EXPECT_TRUE(a.is_a("w", "B"));
  EXPECT_FALSE(Asked(":x a :A. :y a :B. :x owl:sameAs :y. :x owl:differentFrom :y.").reasoner.consistent());
  EXPECT_FALSE(Asked(":A owl:disjointWith :B. :x a :A, :B.").reasoner.consistent());
}

TEST(Rules, DataValuesDifferByValue) {
  const Asked a(
      ":d a owl:DatatypeProperty, owl:FunctionalProperty. :A rdfs:subClassOf [owl:onProperty :d; "
      "owl:hasValue 50]. :B rdfs:subClassOf "
      "[owl:onProperty :d; owl:hasValue 60]. :C rdfs:subClassOf :A, :B. :D owl:equivalentClass "
      "[owl:onProperty :d; owl:hasValue \"050\"^^xsd:integer].");
  EXPECT_FALSE(a.satisfiable("C"));
  EXPECT_TRUE(a.below("A", "D"));
  EXPECT_FALSE(a.below("B", "D"));
}

TEST(Rules, WhatIsDroppedIsListedWithItsAxiom) {
  const Asked a(
      ":A rdfs:subClassOf :B.\n:A rdfs:subClassOf [owl:unionOf (:C :D)].\n[owl:complementOf :A] "
      "rdfs:subClassOf :E.\n");
  ASSERT_EQ(a.reasoner.incomplete().size(), 2U);
  EXPECT_EQ(a.reasoner.incomplete()[0].axiom.number, 2U);
  EXPECT_EQ(a.reasoner.incomplete()[0].signature.size(), 3U);
  EXPECT_EQ(a.reasoner.incomplete()[1].axiom.number, 3U);
}

std::string union_of(const std::string& members) {
  return "[owl:unionOf (" + members + ")]";
}
std::string no(const std::string& c) {
  return "[owl:complementOf " + c + "]";
}

TEST(Rules, WhatAllCasesHaveTheWholeHas) {
  const Asked a(
      ":A rdfs:subClassOf " + union_of(":B :C") +
      ". :B rdfs:subClassOf :D. :C rdfs:subClassOf :E. :E rdfs:subClassOf :D. :F rdfs:subClassOf :A.");
  EXPECT_TRUE(a.below("A", "D"));
  EXPECT_TRUE(a.below("F", "D"));
  EXPECT_FALSE(a.below("A", "E"));
  const Asked one(":A rdfs:subClassOf " + union_of(":B :C") + ", :X. :X owl:disjointWith :B.");
  EXPECT_TRUE(one.below("A", "C"));
  const Asked none(":A rdfs:subClassOf " + union_of(":B :C") + ", :X. :X owl:disjointWith :B, :C.");
  EXPECT_FALSE(none.satisfiable("A"));
}

TEST(Rules, ComplementsAndUniversalsOnTheLeftAreRefuted) {
  const Asked a(":Green owl:equivalentClass [owl:intersectionOf (:Dish " + no(some("has", ":Meat")) +
                ")]. :Salad rdfs:subClassOf :Dish, " + only("has", ":Plant") +
                ". :Plant owl:disjointWith :Meat. :Soup rdfs:subClassOf :Dish.");
  EXPECT_TRUE(a.below("Salad", "Green"));
  EXPECT_FALSE(a.below("Soup", "Green"));
  const Asked b("[owl:intersectionOf (:Dish " + only("has", ":Plant") +
                ")] rdfs:subClassOf :Green. :Salad rdfs:subClassOf :Dish, " + only("has", ":Leaf") +
                ". :Leaf rdfs:subClassOf :Plant. :Soup rdfs:subClassOf :Dish.");
  EXPECT_TRUE(b.below("Salad", "Green"));
  EXPECT_FALSE(b.below("Soup", "Green"));
}

TEST(Rules, UniversalsReachBackOverInverses) {
  const Asked a(":r owl:inverseOf :i. :A rdfs:subClassOf " + some("r", ":B") + ". :B rdfs:subClassOf " +
                only("i", ":C") + ". :D rdfs:subClassOf " + some("r", ":E") + ".");
  EXPECT_TRUE(a.below("A", "C"));
  EXPECT_FALSE(a.below("D", "C"));
}

TEST(Rules, SuccessorsThatDifferAreCounted) {
  const std::string many =
      ":Rich owl:equivalentClass [a owl:Restriction; owl:onProperty :r; owl:minCardinality 2]. ";
  const std::string two = ":A rdfs:subClassOf " + some("r", ":B") + ", " + some("r", ":C") + ". ";
  EXPECT_FALSE(Asked(many + two).below("A", "Rich"));
  EXPECT_TRUE(Asked(many + two + ":B owl:disjointWith :C.").below("A", "Rich"));
}

TEST(Rules, DatatypesExcludeEachOther) {
  const std::string age = ":age a owl:DatatypeProperty. ";
  const Asked a(
      age +
      ":age rdfs:range xsd:integer. :A rdfs:subClassOf [owl:onProperty :age; owl:hasValue \"old\"]. "
      ":B rdfs:subClassOf [owl:onProperty :age; owl:someValuesFrom xsd:byte]. "
      "[owl:onProperty :age; owl:someValuesFrom xsd:long] rdfs:subClassOf :C.");
  EXPECT_FALSE(a.satisfiable("A"));
  EXPECT_TRUE(a.satisfiable("B"));
  EXPECT_TRUE(a.below("B", "C"));
}

}  // namespace
}  // namespace heed::dl::test
