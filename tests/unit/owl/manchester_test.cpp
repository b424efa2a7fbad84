#include "axioms.h"

#include <gmock/gmock.h>

namespace heed::owl::test {
namespace {

using testing::ElementsAre;

Read manchester(const std::string& body) {
  return read_text("Prefix: : <http://e/#>\nOntology: <http://e/> <http://e/1>\n" + body + "\n", "test.omn");
}

/// The one super class of A, whose p is an object property and d a data property.
std::string super_class(const std::string& expression) {
  const Read read =
      manchester("Class: A SubClassOf: " + expression + "\nObjectProperty: p\nDataProperty: d Datatype: t");
  const auto axioms = short_axioms(read.ontology);
  return axioms.size() == 1 ? axioms[0] : "not one axiom";
}

TEST(Manchester, ExpressionsBindAsTheGrammarSays) {
  const std::pair<const char*, const char*> cases[] = {
      {"B and C or D", "ObjectUnionOf(ObjectIntersectionOf(B C) D)"},
      {"B and (C or D)", "ObjectIntersectionOf(B ObjectUnionOf(C D))"},
      {"not B and C", "ObjectIntersectionOf(ObjectComplementOf(B) C)"},
      {"not (B and C)", "ObjectComplementOf(ObjectIntersectionOf(B C))"},
      {"p some B and C", "ObjectIntersectionOf(ObjectSomeValuesFrom(p B) C)"},
      {"p some (B and C)", "ObjectSomeValuesFrom(p ObjectIntersectionOf(B C))"},
      {"p some not p only B", "ObjectSomeValuesFrom(p ObjectComplementOf(ObjectAllValuesFrom(p B)))"},
      {"B that p value i", "ObjectIntersectionOf(B ObjectHasValue(p i))"},
      {"inverse p some B", "ObjectSomeValuesFrom(ObjectInverseOf(p) B)"},
      {"inverse(p) Self", "ObjectHasSelf(ObjectInverseOf(p))"},
      {"p min 2", "ObjectMinCardinality(2 p Thing)"},
      {"p min 2 and B", "ObjectIntersectionOf(ObjectMinCardinality(2 p Thing) B)"},
      {"p max 1 (B or C)", "ObjectMaxCardinality(1 p ObjectUnionOf(B C))"},
      {"p exactly 3 B", "ObjectExactCardinality(3 p B)"},
      {"{i, j}", "ObjectOneOf(i j)"},
      {"d some t", "DataSomeValuesFrom(d t)"},
      {"d only xsd:integer[>= 5, < 9]",
       "DataAllValuesFrom(d DatatypeRestriction(integer minInclusive \"5\"^^integer maxExclusive "
       "\"9\"^^integer))"},
      {"d some xsd:integer[<5,>3]",
       "DataSomeValuesFrom(d DatatypeRestriction(integer maxExclusive \"5\"^^integer minExclusive "
       "\"3\"^^integer))"},
      {"d some (t or not xsd:string)", "DataSomeValuesFrom(d DataUnionOf(t DataComplementOf(string)))"},
      {"d some {1, 2.5, 1.5e3f, true, \"x\"@EN}",
       "DataSomeValuesFrom(d DataOneOf(\"1\"^^integer \"2.5\"^^decimal \"1.5e3\"^^float \"true\"^^boolean "
       "\"x\"@en))"},
      {"d value -5", "DataHasValue(d \"-5\"^^integer)"},
      {"d max 1", "DataMaxCardinality(1 d Literal)"},
      {"<http://e/#p> some <http://f/B>", "ObjectSomeValuesFrom(p http://f/B)"}};
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(super_class(text), std::string("SubClassOf(A ") + expected + ")") << text;
}

const char* const frames = R"(Annotations: rdfs:comment "about"
Class: A  Annotations: rdfs:label "stop"@en, Annotations: rdfs:comment "why" rdfs:comment "c"
  SubClassOf: Annotations: rdfs:comment "x" B, C
  EquivalentTo: p some B   DisjointWith: B   DisjointUnionOf: B, C   HasKey: p d
Class: B DisjointWith: A
ObjectProperty: p Domain: A Range: B Characteristics: Functional, Transitive SubPropertyOf: inverse q
  EquivalentTo: q DisjointWith: q InverseOf: q SubPropertyChain: p o inverse q
DataProperty: d Domain: A Range: xsd:integer[> 0] Characteristics: Functional SubPropertyOf: e
AnnotationProperty: a Domain: A Range: xsd:string SubPropertyOf: rdfs:comment
Datatype: t EquivalentTo: xsd:integer or xsd:string
Individual: i Types: A, not B Facts: p j, not p i, d 5, not d "x" SameAs: j DifferentFrom: k
Individual: _:x Types: A
EquivalentClasses: Annotations: rdfs:comment "y" A, B, C
DisjointProperties: d, e
DataProperty: e
DifferentIndividuals: i, j, k)";

TEST(Manchester, FramesOfEveryKind) {
  const Read read = manchester(frames);
  EXPECT_THAT(short_axioms(read.ontology),
              testing::ElementsAreArray<std::string>(
                  {"AnnotationAssertion(label A \"stop\"@en)",
                   "AnnotationAssertion(Annotation(comment \"why\") comment A \"c\")",
                   "SubClassOf(Annotation(comment \"x\") A B)",
                   "SubClassOf(A C)",
                   "EquivalentClasses(A ObjectSomeValuesFrom(p B))",
                   "DisjointClasses(A B)",
                   "DisjointUnion(A B C)",
                   "HasKey(A (p) (d))",
                   "ObjectPropertyDomain(p A)",
                   "ObjectPropertyRange(p B)",
                   "FunctionalObjectProperty(p)",
                   "TransitiveObjectProperty(p)",
                   "SubObjectPropertyOf(p ObjectInverseOf(q))",
                   "EquivalentObjectProperties(p q)",
                   "DisjointObjectProperties(p q)",
                   "InverseObjectProperties(p q)",
                   "SubObjectPropertyOf(ObjectPropertyChain(p ObjectInverseOf(q)) p)",
                   "DataPropertyDomain(d A)",
                   "DataPropertyRange(d DatatypeRestriction(integer minExclusive \"0\"^^integer))",
                   "FunctionalDataProperty(d)",
                   "SubDataPropertyOf(d e)",
                   "AnnotationPropertyDomain(a A)",
                   "AnnotationPropertyRange(a string)",
                   "SubAnnotationPropertyOf(a comment)",
                   "DatatypeDefinition(t DataUnionOf(integer string))",
                   "ClassAssertion(A i)",
                   "ClassAssertion(ObjectComplementOf(B) i)",
                   "ObjectPropertyAssertion(p i j)",
                   "NegativeObjectPropertyAssertion(p i i)",
                   "DataPropertyAssertion(d i \"5\"^^integer)",
                   "NegativeDataPropertyAssertion(d i \"x\")",
                   "SameIndividual(i j)",
                   "DifferentIndividuals(i k)",
                   "ClassAssertion(A _:d0b0)",
                   "EquivalentClasses(Annotation(comment \"y\") A B C)",
                   "DisjointDataProperties(d e)",
                   "DifferentIndividuals(i j k)"}));
  EXPECT_EQ(read.ontology.annotations().size(), 1U);
  EXPECT_EQ(read.ontology.version_iri(), "http://e/1");
  EXPECT_EQ(read.ontology.axioms()[7].location.line, 6U) << "the place of an axiom is that of its part";
}

TEST(Manchester, RulesAreReportedAndSkipped) {
  const Read read = manchester("Rule: A(?x), p(?x, ?y) -> B(?y)\nClass: B");
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics[0].code, "swrl");
  EXPECT_EQ(read.ontology.axioms().size(), 1U);
}

TEST(Manchester, DeepNestingWorksToTheLimitAndIsRefusedBeyond) {
  const auto brackets = [](std::size_t depth) {
    std::string text = "Class: A SubClassOf: ";
    for (std::size_t i = 0; i < depth; ++i) text += "p some (";
    return text + "B" + std::string(depth, ')');
  };
  const auto words = [](std::size_t depth) {
    std::string text = "Class: A SubClassOf: ";
    for (std::size_t i = 0; i < depth; ++i) text += "not ";
    return text + "B";
  };
  EXPECT_EQ(manchester(brackets(9'900)).ontology.axioms()[1].as<SubClassOf>()->super.depth(), 9'900U);
  EXPECT_EQ(manchester(words(9'900)).ontology.axioms()[1].as<SubClassOf>()->super.depth(), 9'900U);
  EXPECT_EQ(refused([&] { (void)manchester(brackets(100'000)); }).code, "nesting");
  EXPECT_EQ(refused([&] { (void)manchester(words(100'000)); }).code, "nesting");
  std::string ranges = "DataProperty: d Class: A SubClassOf: d some ";
  for (int i = 0; i < 300; ++i) ranges += "not ";
  EXPECT_EQ(refused([&] { (void)manchester(ranges + "xsd:integer"); }).code, "nesting");
}

TEST(Manchester, FlawsAreNamed) {
  const std::pair<std::string, std::string> cases[] = {
      {"Class: A SubClassOf: B and", "syntax"},
      {"Class: A SubClassOf: (B", "syntax"},
      {"Class: A SubClasOf: B", "unknown-word"},
      {"Class: A SubClassOf: B C", "unknown-word"},
      {"Clas: A", "syntax"},
      {"Class: A SubClassOf: q:B", "undeclared-prefix"},
      {"Class: A SubClassOf: p min x B", "bad-cardinality"},
      {"ObjectProperty: p Characteristics: Transitiv", "unknown-word"},
      {"DataProperty: d Characteristics: Transitive", "unknown-word"},
      {"DisjointClasses: A", "too-few"},
      {"Individual: i Facts: p", "syntax"},
      {"Class: A Annotations: rdfs:comment \"x", "open-string"},
      {"Class: A SubClassOf: B and {1}", "wrong-argument"},
      {"Class: A SubClassOf: {1}", "wrong-argument"},
      {"Class: A SubClassOf: p some xsd:int[almost 5]", "syntax"}};
  for (const auto& [body, code] : cases)
    EXPECT_EQ(refused([&, text = body] { (void)manchester(text); }).code, code) << body;
}

}  // namespace
}  // namespace heed::owl::test
