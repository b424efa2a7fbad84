#include "support.h"

#include <gmock/gmock.h>

#include <ctime>

namespace heed::owl::test {
namespace {

TEST(RdfXml, ResolvesNamesInEveryPlaceWhereTheyStand) {
  const Read read = rdf_xml(
      "<owl:Class rdf:about=\"http://e/#A\"><rdfs:subClassOf rdf:resource=\"#B\"/></owl:Class>\n"
      "<owl:Class rdf:ID=\"C\"><rdfs:subClassOf rdf:resource=\"http://e/#B\"/></owl:Class>\n"
      "<B rdf:about=\"#x\"/>");
  EXPECT_THAT(short_axioms(read.ontology),
              testing::ElementsAre("SubClassOf(A B)", "SubClassOf(C B)", "ClassAssertion(B x)"));
  EXPECT_TRUE(read.diagnostics.empty());
}

TEST(RdfXml, ParseTypesNestedNodesAndNodeIds) {
  const Read read = rdf_xml(
      "<owl:Class rdf:about=\"#A\"><owl:equivalentClass><owl:Class><owl:intersectionOf "
      "rdf:parseType=\"Collection\">"
      "<rdf:Description rdf:about=\"#B\"/><owl:Restriction><owl:onProperty rdf:resource=\"#p\"/>"
      "<owl:someValuesFrom "
      "rdf:nodeID=\"n\"/></owl:Restriction></owl:intersectionOf></owl:Class></owl:equivalentClass>"
      "<rdfs:subClassOf rdf:parseType=\"Resource\"><owl:onProperty rdf:resource=\"#p\"/>"
      "<owl:someValuesFrom rdf:resource=\"#C\"/></rdfs:subClassOf></owl:Class>"
      "<owl:Class rdf:nodeID=\"n\"><owl:complementOf rdf:resource=\"#D\"/></owl:Class>");
  EXPECT_THAT(
      short_axioms(read.ontology),
      testing::ElementsAre(
          "EquivalentClasses(A ObjectIntersectionOf(B ObjectSomeValuesFrom(p ObjectComplementOf(D))))",
          "SubClassOf(A ObjectSomeValuesFrom(p C))"));
  EXPECT_TRUE(read.diagnostics.empty());
}

TEST(RdfXml, LiteralsKeepLanguageDatatypeAndMarkup) {
  const Read read = rdf_xml(
      "<owl:Class rdf:about=\"#A\" rdfs:comment=\"in an attribute\" "
      "xml:lang=\"IT\"><rdfs:label>segnale</rdfs:label>"
      "<rdfs:label xml:lang=\"\">plain</rdfs:label><rdfs:comment><![CDATA[a < b & c]]></rdfs:comment>"
      "<rdfs:comment rdf:parseType=\"Literal\"><b>bold</b></rdfs:comment></owl:Class>");
  EXPECT_THAT(short_axioms(read.ontology),
              testing::ElementsAre("AnnotationAssertion(comment A \"in an attribute\"@it)",
                                   "AnnotationAssertion(label A \"segnale\"@it)",
                                   "AnnotationAssertion(label A \"plain\")",
                                   "AnnotationAssertion(comment A \"a  b & c\"@it)",
                                   "AnnotationAssertion(comment A \"bbold/b\"^^XMLLiteral)"));
  const Iri a = *read.ontology.find("http://e/#A");
  EXPECT_EQ(read.ontology.name(a, "it"), "segnale");
  EXPECT_EQ(read.ontology.name(a, "en"), "plain");
}

TEST(RdfXml, LocationsPointAtTheElement) {
  const Read read =
      rdf_xml("<owl:Class rdf:about=\"#A\">\n  <rdfs:subClassOf rdf:resource=\"#B\"/>\n</owl:Class>");
  const Axiom& axiom = read.ontology.axioms()[1];
  EXPECT_EQ(util::to_string(axiom.location), "test.owl:4:3");
}

TEST(RdfXml, InnerBindingsDoNotLeak) {
  const Read read = rdf_xml(
      "<owl:Class rdf:about=\"#A\"><q:subClassOf xmlns:q=\"http://www.w3.org/2000/01/rdf-schema#\" "
      "rdf:resource=\"#B\"/>"
      "<q:label xmlns:q=\"http://www.w3.org/2000/01/rdf-schema#\">x</q:label></owl:Class>"
      "<q:A xmlns:q=\"http://e/#\" rdf:about=\"#i\"/>");
  EXPECT_THAT(
      short_axioms(read.ontology),
      testing::ElementsAre("SubClassOf(A B)", "AnnotationAssertion(label A \"x\")", "ClassAssertion(A i)"));
}

TEST(RdfXml, ExpandsDeclaredEntitiesInAttributesAndText) {
  const Read read = rdf_xml(
      "<owl:Class rdf:about=\"&e;A\"><rdfs:label>&who; &amp;lt; &#233;&lt;</rdfs:label></owl:Class>",
      "<!DOCTYPE rdf:RDF [ <!ENTITY e \"http://e/#\" > <!-- <!ENTITY who \"no\"> --> <!ENTITY who '&inner;s'>"
      "<!ENTITY inner \"sign\"> ]>\n");
  const Iri a = *read.ontology.find("http://e/#A");
  EXPECT_EQ(read.ontology.labels(a).front().text, "signs &lt; \xC3\xA9<");
}

std::string laughs(int levels, const std::string& leaf) {
  std::string out = "<!DOCTYPE rdf:RDF [ <!ENTITY l0 \"" + leaf + "\">";
  for (int i = 1; i <= levels; ++i) {
    out += "<!ENTITY l" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) out += "&l" + std::to_string(i - 1) + ";";
    out += "\">";
  }
  return out + "]>\n";
}

/// Exponential, quadratic, empty-leaf and cyclic definitions end at the cap, fast.
TEST(RdfXml, RefusesHostileEntities) {
  const std::clock_t begin = std::clock();
  const auto code = [](const std::string& doctype, const std::string& text) {
    return refused([&] {
             rdf_xml("<owl:Class rdf:about=\"#A\"><rdfs:label>" + text + "</rdfs:label></owl:Class>",
                     doctype);
           })
        .code;
  };
  EXPECT_EQ(code(laughs(12, "ha"), "&l12;"), "entity-expansion");
  EXPECT_EQ(code(laughs(12, ""), "&l12;"), "entity-expansion");
  std::string many;
  for (int i = 0; i < 20000; ++i) many += "&l0;";
  EXPECT_EQ(code(laughs(0, std::string(100000, 'x')), many), "entity-expansion");
  EXPECT_EQ(code("<!DOCTYPE rdf:RDF [<!ENTITY a \"&b;\"><!ENTITY b \"&a;\">]>\n", "&a;"), "entity-cycle");
  EXPECT_EQ(code("<!DOCTYPE rdf:RDF [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>\n", "&a;"),
            "external-entity");
  EXPECT_EQ(code("<!DOCTYPE rdf:RDF [<!ENTITY % p \"x\"> %p;]>\n", "x"), "parameter-entity");
  EXPECT_EQ(code("<!DOCTYPE rdf:RDF [<!ENTITY a \"<b/>\">]>\n", "&a;"), "entity-markup");
  EXPECT_EQ(code("", "&nowhere;"), "undefined-entity");
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC) << "of the processor, however busy the machine is";
}

TEST(RdfXml, RefusesDeepNestingWithAMessage) {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += "<owl:Class><owl:complementOf>";
  for (int i = 0; i < 50000; ++i) text += "</owl:complementOf></owl:Class>";
  EXPECT_EQ(refused([&] { rdf_xml(text); }).code, "nesting");
}

TEST(RdfXml, BuildsWhatNestsBelowTheLimit) {
  std::string text = "<owl:Class rdf:about=\"#A\"><rdfs:subClassOf>";
  for (int i = 0; i < 4900; ++i) text += "<owl:Class><owl:complementOf>";
  text += "<owl:Class rdf:about=\"#B\"/>";
  for (int i = 0; i < 4900; ++i) text += "</owl:complementOf></owl:Class>";
  const Read read = rdf_xml(text + "</rdfs:subClassOf></owl:Class>");
  ASSERT_EQ(short_axioms(read.ontology).size(), 1U);
  EXPECT_EQ(read.ontology.axioms()[1].as<SubClassOf>()->super.depth(), 4900U);
}

}  // namespace
}  // namespace heed::owl::test
