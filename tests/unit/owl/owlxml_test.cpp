#include "support.h"

#include <gmock/gmock.h>

namespace heed::owl::test {
namespace {

using testing::ElementsAre;

std::string cls(const std::string& name) {
  return "<Class IRI=\"#" + name + "\"/>";
}

TEST(OwlXml, NamesStandAgainstBasePrefixAndOntology) {
  const Read read = owl_xml(
      "<SubClassOf><Class IRI=\"#A\"/><Class abbreviatedIRI=\":B\"/></SubClassOf>"
      "<SubClassOf><Class abbreviatedIRI=\"owl:Thing\"/><Class IRI=\"http://f/C\"/></SubClassOf>"
      "<SubClassOf xml:base=\"http://g/\"><Class IRI=\"#D\"/><Class IRI=\"x\"/></SubClassOf>");
  EXPECT_THAT(short_axioms(read.ontology), ElementsAre("SubClassOf(A B)", "SubClassOf(Thing http://f/C)",
                                                       "SubClassOf(http://g/#D http://g/x)"));
  EXPECT_EQ(read.ontology.iri(), "http://e/");
  const Read bare = read_text(
      "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" ontologyIRI=\"http://e/\"><Declaration><Class "
      "IRI=\"#A\"/></Declaration></Ontology>");
  EXPECT_THAT(short_axioms(bare.ontology, true), ElementsAre("Declaration(Class(A))"));
}

TEST(OwlXml, ExpressionsOfEveryKind) {
  const std::string p = "<ObjectProperty IRI=\"#p\"/>", d = "<DataProperty IRI=\"#d\"/>";
  const std::string integer = "<Datatype abbreviatedIRI=\"xsd:integer\"/>";
  const std::string five = "<Literal datatypeIRI=\"http://www.w3.org/2001/XMLSchema#integer\">5</Literal>";
  const std::pair<std::string, std::string> cases[] = {
      {"<ObjectMinCardinality cardinality=\"2\">" + p + "</ObjectMinCardinality>",
       "ObjectMinCardinality(2 p Thing)"},
      {"<ObjectMaxCardinality cardinality=\"0\">" + p + cls("B") + "</ObjectMaxCardinality>",
       "ObjectMaxCardinality(0 p B)"},
      {"<ObjectSomeValuesFrom><ObjectInverseOf>" + p + "</ObjectInverseOf><ObjectHasSelf>" + p +
           "</ObjectHasSelf></ObjectSomeValuesFrom>",
       "ObjectSomeValuesFrom(ObjectInverseOf(p) ObjectHasSelf(p))"},
      {"<DataHasValue>" + d + five + "</DataHasValue>", "DataHasValue(d \"5\"^^integer)"},
      {"<DataSomeValuesFrom>" + d + "<DatatypeRestriction>" + integer +
           "<FacetRestriction facet=\"http://www.w3.org/2001/XMLSchema#minInclusive\">" + five +
           "</FacetRestriction></DatatypeRestriction></DataSomeValuesFrom>",
       "DataSomeValuesFrom(d DatatypeRestriction(integer minInclusive \"5\"^^integer))"},
      {"<DataExactCardinality cardinality=\"1\">" + d + "<DataComplementOf>" + integer +
           "</DataComplementOf></DataExactCardinality>",
       "DataExactCardinality(1 d DataComplementOf(integer))"},
      {"<ObjectOneOf><NamedIndividual IRI=\"#i\"/><AnonymousIndividual nodeID=\"x\"/></ObjectOneOf>",
       "ObjectOneOf(i _:d0b0)"}};
  for (const auto& [xml, text] : cases)
    EXPECT_THAT(short_axioms(owl_xml("<SubClassOf>" + cls("A") + xml + "</SubClassOf>").ontology),
                ElementsAre("SubClassOf(A " + text + ")"));
}

TEST(OwlXml, AnnotationsLiteralsKeysAndChains) {
  const Read read = owl_xml(
      "<SubClassOf>\n<Annotation><Annotation><AnnotationProperty "
      "abbreviatedIRI=\"rdfs:seeAlso\"/><IRI>#z</IRI>"
      "</Annotation><AnnotationProperty abbreviatedIRI=\"rdfs:comment\"/><Literal xml:lang=\"EN\">a &lt; "
      "b</Literal></Annotation>" +
      cls("A") + cls("B") +
      "</SubClassOf>\n<AnnotationAssertion><AnnotationProperty abbreviatedIRI=\"rdfs:label\"/>"
      "<AbbreviatedIRI>:A</AbbreviatedIRI><Literal xml:lang=\"it\"> stop </Literal></AnnotationAssertion>"
      "<HasKey>" +
      cls("A") +
      "<ObjectProperty IRI=\"#p\"/><DataProperty "
      "IRI=\"#d\"/></HasKey><SubObjectPropertyOf><ObjectPropertyChain>"
      "<ObjectProperty IRI=\"#p\"/><ObjectProperty IRI=\"#q\"/></ObjectPropertyChain><ObjectProperty "
      "IRI=\"#p\"/></SubObjectPropertyOf>");
  EXPECT_THAT(short_axioms(read.ontology),
              ElementsAre("SubClassOf(Annotation(Annotation(seeAlso z) comment \"a  b\"@en) A B)",
                          "AnnotationAssertion(label A \" stop \"@it)", "HasKey(A (p) (d))",
                          "SubObjectPropertyOf(ObjectPropertyChain(p q) p)"));
  EXPECT_EQ(read.ontology.name(*read.ontology.find("http://e/#A"), "it"), " stop ");
  EXPECT_EQ(read.ontology.axioms()[0].location.line, 3U);
  EXPECT_EQ(read.ontology.axioms()[0].location.column, 1U);
}

TEST(OwlXml, RulesAreReportedAndSkipped) {
  const Read read = owl_xml("<DLSafeRule><Body><ClassAtom>" + cls("A") +
                            "<Variable IRI=\"#x\"/></ClassAtom></Body><Head/></DLSafeRule><Declaration>" +
                            cls("B") + "</Declaration>");
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics[0].code, "swrl");
  EXPECT_EQ(read.ontology.axioms().size(), 1U);
}

TEST(OwlXml, DeepNestingWorksToTheLimitAndIsRefusedBeyond) {
  const auto nested = [](std::size_t depth) {
    std::string open, close;
    for (std::size_t i = 0; i < depth; ++i) open += "<ObjectComplementOf>", close += "</ObjectComplementOf>";
    return "<SubClassOf>" + cls("A") + open + cls("B") + close + "</SubClassOf>";
  };
  const Read deep = owl_xml(nested(9'900));
  EXPECT_EQ(deep.ontology.axioms()[0].as<SubClassOf>()->super.depth(), 9'900U);
  EXPECT_EQ(refused([&] { (void)owl_xml(nested(100'000)); }).code, "nesting");
}

TEST(OwlXml, FlawsAreNamed) {
  const std::pair<std::string, std::string> cases[] = {
      {"<SubClassOf>" + cls("A") + "</SubClassOf>", "too-few"},
      {"<SubClassOf>" + cls("A") + cls("A") + cls("A") + "</SubClassOf>", "too-many"},
      {"<SubClassof>" + cls("A") + cls("A") + "</SubClassof>", "unknown-word"},
      {"<SubClassOf><ObjectProperty IRI=\"#p\"/>" + cls("A") + "</SubClassOf>", "wrong-argument"},
      {"<SubClassOf><SubClassOf/></SubClassOf>", "misplaced"},
      {"<SubClassOf><Class/>" + cls("A") + "</SubClassOf>", "missing-attribute"},
      {"<SubClassOf><Class abbreviatedIRI=\"q:A\"/>" + cls("A") + "</SubClassOf>", "undeclared-prefix"},
      {"<SubClassOf>text</SubClassOf>", "stray-text"},
      {cls("A"), "misplaced"},
      {"<ObjectMinCardinality cardinality=\"-1\"/>", "misplaced"},
      {"<SubClassOf>" + cls("A") + "<ObjectMinCardinality cardinality=\"-1\"/></SubClassOf>",
       "bad-cardinality"},
      {"<SubClassOf><Class IRI=\"&nope;A\"/>" + cls("A") + "</SubClassOf>", "undefined-entity"}};
  for (const auto& [body, code] : cases)
    EXPECT_EQ(refused([&, text = body] { (void)owl_xml(text); }).code, code) << body;
}

}  // namespace
}  // namespace heed::owl::test
