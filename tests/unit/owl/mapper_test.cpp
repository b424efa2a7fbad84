#include "support.h"

#include <gmock/gmock.h>

namespace heed::owl::test {
namespace {

struct Case {
  const char* turtle;
  const char* axiom;
};

class Mapping : public testing::TestWithParam<Case> {};

/// Every pattern of "OWL 2 Mapping to RDF Graphs" gives its axiom, alone and without a remark.
TEST_P(Mapping, GivesTheAxiom) {
  const Read read = turtle(GetParam().turtle);
  EXPECT_THAT(short_axioms(read.ontology), testing::ElementsAre(GetParam().axiom));
  for (const auto& d : read.diagnostics) ADD_FAILURE() << util::to_string(d);
}

INSTANTIATE_TEST_SUITE_P(
    Classes, Mapping,
    testing::Values(
        Case{":A rdfs:subClassOf :B .", "SubClassOf(A B)"},
        Case{":A owl:equivalentClass :B .", "EquivalentClasses(A B)"},
        Case{":A owl:disjointWith :B .", "DisjointClasses(A B)"},
        Case{":A owl:disjointUnionOf (:B :C) .", "DisjointUnion(A B C)"},
        Case{":A owl:disjointUnionOf (:B) .", "EquivalentClasses(A B)"},
        Case{":A owl:disjointUnionOf () .", "EquivalentClasses(A Nothing)"},
        Case{"[] a owl:AllDisjointClasses ; owl:members (:A :B :C) .", "DisjointClasses(A B C)"},
        Case{":A rdfs:subClassOf [owl:intersectionOf (:B :C)] .", "SubClassOf(A ObjectIntersectionOf(B C))"},
        Case{":A rdfs:subClassOf [a owl:Class; owl:unionOf (:B :C)] .", "SubClassOf(A ObjectUnionOf(B C))"},
        Case{":A rdfs:subClassOf [a owl:Class; owl:complementOf :B] .",
             "SubClassOf(A ObjectComplementOf(B))"},
        Case{":A owl:equivalentClass [a owl:Class; owl:oneOf (:x :y)] .",
             "EquivalentClasses(A ObjectOneOf(x y))"},
        Case{":A owl:unionOf (:B :C) .", "EquivalentClasses(A ObjectUnionOf(B C))"},
        Case{":A rdfs:subClassOf [a owl:Restriction; owl:onProperty :p; owl:someValuesFrom :B] .",
             "SubClassOf(A ObjectSomeValuesFrom(p B))"},
        Case{":A rdfs:subClassOf [owl:onProperty [owl:inverseOf :p]; owl:allValuesFrom :B] .",
             "SubClassOf(A ObjectAllValuesFrom(ObjectInverseOf(p) B))"},
        Case{":A rdfs:subClassOf [owl:onProperty :p; owl:hasValue :x] .",
             "SubClassOf(A ObjectHasValue(p x))"},
        Case{":A rdfs:subClassOf [owl:onProperty :p; owl:hasSelf true] .", "SubClassOf(A ObjectHasSelf(p))"},
        Case{":p a owl:ObjectProperty. :A rdfs:subClassOf [owl:onProperty :p; owl:minCardinality 2] .",
             "SubClassOf(A ObjectMinCardinality(2 p Thing))"},
        Case{":A rdfs:subClassOf [owl:onProperty :p; owl:maxQualifiedCardinality 1; owl:onClass :B] .",
             "SubClassOf(A ObjectMaxCardinality(1 p B))"},
        Case{":p a owl:ObjectProperty. :A rdfs:subClassOf [owl:onProperty :p; owl:cardinality 3] .",
             "SubClassOf(A ObjectExactCardinality(3 p Thing))"},
        Case{"[owl:onProperty :p; owl:someValuesFrom :B] rdfs:subClassOf :A .",
             "SubClassOf(ObjectSomeValuesFrom(p B) A)"},
        Case{":d a owl:DatatypeProperty. :A owl:hasKey (:p :d) .", "HasKey(A (p) (d))"}));

INSTANTIATE_TEST_SUITE_P(
    Data, Mapping,
    testing::Values(
        Case{":A rdfs:subClassOf [owl:onProperty :d; owl:someValuesFrom xsd:integer] .",
             "SubClassOf(A DataSomeValuesFrom(d integer))"},
        Case{":A rdfs:subClassOf [owl:onProperty :d; owl:hasValue 5] .",
             "SubClassOf(A DataHasValue(d \"5\"^^integer))"},
        Case{":A rdfs:subClassOf [owl:onProperty :d; owl:maxQualifiedCardinality 1; owl:onDataRange "
             "xsd:string] .",
             "SubClassOf(A DataMaxCardinality(1 d string))"},
        Case{":d rdfs:range [a rdfs:Datatype; owl:oneOf (1 2)] .",
             "DataPropertyRange(d DataOneOf(\"1\"^^integer \"2\"^^integer))"},
        Case{":d rdfs:range [a rdfs:Datatype; owl:onDatatype xsd:integer; owl:withRestrictions "
             "([xsd:minInclusive 5])] .",
             "DataPropertyRange(d DatatypeRestriction(integer minInclusive \"5\"^^integer))"},
        Case{":t a rdfs:Datatype; owl:equivalentClass [a rdfs:Datatype; owl:datatypeComplementOf xsd:string] "
             ".",
             "DatatypeDefinition(t DataComplementOf(string))"},
        Case{":d a owl:DatatypeProperty; rdfs:domain :A .", "DataPropertyDomain(d A)"},
        Case{":d a owl:DatatypeProperty, owl:FunctionalProperty .", "FunctionalDataProperty(d)"},
        Case{":d a owl:DatatypeProperty; rdfs:subPropertyOf :e .", "SubDataPropertyOf(d e)"},
        Case{":d a owl:DatatypeProperty; owl:equivalentProperty :e .", "EquivalentDataProperties(d e)"},
        Case{":d a owl:DatatypeProperty; owl:propertyDisjointWith :e .", "DisjointDataProperties(d e)"},
        Case{":d a owl:DatatypeProperty. :x :d \"v\"@EN .", "DataPropertyAssertion(d x \"v\"@en)"},
        Case{"[] a owl:NegativePropertyAssertion; owl:sourceIndividual :x; owl:assertionProperty :d; "
             "owl:targetValue 1 .",
             "NegativeDataPropertyAssertion(d x \"1\"^^integer)"}));

INSTANTIATE_TEST_SUITE_P(
    Properties, Mapping,
    testing::Values(
        Case{":p rdfs:subPropertyOf :q .", "SubObjectPropertyOf(p q)"},
        Case{":p owl:propertyChainAxiom (:q :r) .", "SubObjectPropertyOf(ObjectPropertyChain(q r) p)"},
        Case{":p owl:equivalentProperty :q .", "EquivalentObjectProperties(p q)"},
        Case{":p owl:propertyDisjointWith :q .", "DisjointObjectProperties(p q)"},
        Case{"[] a owl:AllDisjointProperties; owl:members (:p :q :r) .", "DisjointObjectProperties(p q r)"},
        Case{":p owl:inverseOf :q .", "InverseObjectProperties(p q)"},
        Case{":p a owl:ObjectProperty; rdfs:domain :A .", "ObjectPropertyDomain(p A)"},
        Case{":p a owl:ObjectProperty; rdfs:range :A .", "ObjectPropertyRange(p A)"},
        Case{":p a owl:ObjectProperty, owl:FunctionalProperty .", "FunctionalObjectProperty(p)"},
        Case{":p a owl:InverseFunctionalProperty .", "InverseFunctionalObjectProperty(p)"},
        Case{":p a owl:ReflexiveProperty .", "ReflexiveObjectProperty(p)"},
        Case{":p a owl:IrreflexiveProperty .", "IrreflexiveObjectProperty(p)"},
        Case{":p a owl:SymmetricProperty .", "SymmetricObjectProperty(p)"},
        Case{":p a owl:AsymmetricProperty .", "AsymmetricObjectProperty(p)"},
        Case{":p a owl:TransitiveProperty .", "TransitiveObjectProperty(p)"}));

INSTANTIATE_TEST_SUITE_P(
    Individuals, Mapping,
    testing::Values(
        Case{":x a :A .", "ClassAssertion(A x)"},
        Case{":x a [owl:onProperty :p; owl:someValuesFrom :B] .",
             "ClassAssertion(ObjectSomeValuesFrom(p B) x)"},
        Case{":p a owl:ObjectProperty. :x :p :y .", "ObjectPropertyAssertion(p x y)"},
        Case{"[] a owl:NegativePropertyAssertion; owl:sourceIndividual :x; owl:assertionProperty :p; "
             "owl:targetIndividual :y .",
             "NegativeObjectPropertyAssertion(p x y)"},
        Case{":x owl:sameAs :y .", "SameIndividual(x y)"},
        Case{":x owl:differentFrom :y .", "DifferentIndividuals(x y)"},
        Case{"[] a owl:AllDifferent; owl:distinctMembers (:x :y :z) .", "DifferentIndividuals(x y z)"},
        Case{":A rdfs:label \"sign\"@en .", "AnnotationAssertion(label A \"sign\"@en)"},
        Case{":n a owl:AnnotationProperty; rdfs:domain :A .", "AnnotationPropertyDomain(n A)"},
        Case{":n a owl:AnnotationProperty; rdfs:subPropertyOf rdfs:comment .",
             "SubAnnotationPropertyOf(n comment)"}));

TEST(Mapper, AnnotatedAxiomsCarryTheirAnnotations) {
  const Read read = turtle(
      ":A rdfs:subClassOf :B .\n[] a owl:Axiom; owl:annotatedSource :A; owl:annotatedProperty "
      "rdfs:subClassOf;\n"
      "owl:annotatedTarget :B; rdfs:comment \"why\" .\n");
  EXPECT_THAT(short_axioms(read.ontology),
              testing::ElementsAre("SubClassOf(Annotation(comment \"why\") A B)"));
  EXPECT_TRUE(read.diagnostics.empty());
}

TEST(Mapper, AnnotatedAxiomStandsEvenWhenItIsNotRepeated) {
  const Read read = turtle(
      "[] a owl:Axiom; owl:annotatedSource :A; owl:annotatedProperty rdfs:subClassOf; owl:annotatedTarget :B "
      ".");
  EXPECT_THAT(short_axioms(read.ontology), testing::ElementsAre("SubClassOf(A B)"));
}

TEST(Mapper, PunningKeepsBothUses) {
  const Read read = turtle(":A a owl:Class . :p a owl:ObjectProperty . :A :p :A . :B rdfs:subClassOf :A .");
  EXPECT_THAT(short_axioms(read.ontology),
              testing::ElementsAre("ObjectPropertyAssertion(p A A)", "SubClassOf(B A)"));
  const Iri both = *read.ontology.find("http://e/#A");
  EXPECT_TRUE(read.ontology.is(EntityKind::Class, both));
  EXPECT_TRUE(read.ontology.is(EntityKind::NamedIndividual, both));
}

TEST(Mapper, WhatIsNotUnderstoodIsReportedWithItsPlace) {
  const Read read = turtle(
      "<urn:r> a <http://www.w3.org/2003/11/swrl#Imp> .\n:A owl:onProperty :p .\n:x <urn:unknown> 1 .");
  ASSERT_EQ(read.diagnostics.size(), 3U);
  EXPECT_EQ(read.diagnostics[0].code, "swrl");
  EXPECT_EQ(read.diagnostics[1].code, "not-understood");
  EXPECT_EQ(read.diagnostics[1].location.line, 3U);
  EXPECT_EQ(read.diagnostics[2].code, "undeclared-property");
}

TEST(Mapper, BrokenListsAndCyclesCostOneAxiomAndAreReported) {
  const Read broken =
      turtle(":A rdfs:subClassOf [owl:unionOf _:l] . _:l rdf:first :B . :C rdfs:subClassOf :D .");
  EXPECT_THAT(short_axioms(broken.ontology), testing::ElementsAre("SubClassOf(C D)"));
  EXPECT_EQ(broken.diagnostics.front().code, "broken-list");
  const Read circle = turtle(":A owl:unionOf _:l . _:l rdf:first :B; rdf:rest _:l .");
  EXPECT_EQ(circle.diagnostics.front().code, "broken-list");
  const Read nested =
      turtle(":A rdfs:subClassOf _:c . _:c owl:complementOf _:d . _:d owl:complementOf _:c .");
  EXPECT_TRUE(short_axioms(nested.ontology).empty());
  EXPECT_EQ(nested.diagnostics.front().code, "cyclic-class");
}

TEST(Mapper, IdsFollowTheDocumentAndLocationsPointIntoIt) {
  const Read read = turtle(":A a owl:Class ;\n  rdfs:subClassOf :B ,\n    :C .\n");
  ASSERT_EQ(read.ontology.axioms().size(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.ontology.axioms()[i].id.number, i + 1);
    EXPECT_EQ(read.ontology.axioms()[i].location.line, i + 2);
  }
  EXPECT_EQ(to_string(read.ontology.axioms()[1].id), "a2");
}

/// Named blank nodes chain without any bracket, so only the expression's own depth bounds them.
TEST(Mapper, DeepExpressionsAreBuiltAndTooDeepOnesRefused) {
  const auto chain = [](int depth) {
    std::string text = ":A rdfs:subClassOf _:n0 .\n";
    for (int i = 0; i < depth; ++i)
      text += "_:n" + std::to_string(i) + " owl:onProperty :p; owl:someValuesFrom " +
              (i + 1 == depth ? std::string(":B") : "_:n" + std::to_string(i + 1)) + " .\n";
    return text;
  };
  const Read fine = turtle(chain(9000));
  ASSERT_EQ(short_axioms(fine.ontology).size(), 1U);
  EXPECT_GT(to_text(fine.ontology.axioms()[0], fine.ontology).size(), 9000U);
  const Read refused = turtle(chain(100000));
  EXPECT_TRUE(short_axioms(refused.ontology).empty());
  EXPECT_EQ(refused.diagnostics.front().code, "nesting");
}

}  // namespace
}  // namespace heed::owl::test
