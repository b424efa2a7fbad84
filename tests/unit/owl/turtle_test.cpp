#include "support.h"

#include <gmock/gmock.h>

namespace heed::owl::test {
namespace {

TEST(Turtle, ReadsDirectivesOfBothStyles) {
  const Read read = read_text(
      "@prefix owl: <http://www.w3.org/2002/07/owl#> .\nPREFIX : <http://e/#>\nbase <http://e/dir/doc>\n"
      ":A a owl:Class . <#x> a :A . <other> a :A . <../up> a :A . </root> a :A .\n");
  std::vector<std::string> names;
  for (const Iri iri : read.ontology.entities(EntityKind::NamedIndividual))
    names.emplace_back(read.ontology.text(iri));
  EXPECT_THAT(names, testing::UnorderedElementsAre("http://e/dir/doc#x", "http://e/dir/other", "http://e/up",
                                                   "http://e/root"));
}

TEST(Turtle, ReadsLiteralsOfEveryForm) {
  const Read read = turtle(
      ":d a owl:DatatypeProperty . :x :d 1, -2.5, 3e4, true, \"a\\u00e9\\n\", 'b', \"\"\"c \"\" d\n\"\"\", "
      "'''e''', \"f\"@en-GB, \"g\"^^xsd:token, 5.\n");
  EXPECT_THAT(
      short_axioms(read.ontology),
      testing::ElementsAre(
          "DataPropertyAssertion(d x \"1\"^^integer)", "DataPropertyAssertion(d x \"-2.5\"^^decimal)",
          "DataPropertyAssertion(d x \"3e4\"^^double)", "DataPropertyAssertion(d x \"true\"^^boolean)",
          "DataPropertyAssertion(d x \"a\xC3\xA9\n\")", "DataPropertyAssertion(d x \"b\")",
          "DataPropertyAssertion(d x \"c \\\"\\\" d\n\")", "DataPropertyAssertion(d x \"e\")",
          "DataPropertyAssertion(d x \"f\"@en-gb)", "DataPropertyAssertion(d x \"g\"^^token)",
          "DataPropertyAssertion(d x \"5\"^^integer)"));
}

TEST(Turtle, ReadsNamesWithDotsEscapesAndBlankNodes) {
  const Read read = turtle(
      ":p a owl:ObjectProperty . :a.b :p :c\\,d, _:n.1 . _:n.1 :p [ :p [] ; ; ] . [] :p :x . [ :p :y ] .");
  EXPECT_THAT(short_axioms(read.ontology), testing::SizeIs(6));
  EXPECT_TRUE(read.ontology.find("http://e/#a.b"));
  EXPECT_TRUE(read.ontology.find("http://e/#c,d"));
  EXPECT_TRUE(read.diagnostics.empty());
}

TEST(Turtle, NTriplesIsTurtle) {
  const Read read =
      read_text("<http://e/#A> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/#B> .\n", "x.nt");
  EXPECT_THAT(short_axioms(read.ontology), testing::ElementsAre("SubClassOf(A B)"));
}

TEST(Turtle, DeepNestingIsReadOrRefused) {
  const auto nested = [](int depth, const std::string& open, const std::string& close) {
    std::string text = ":A rdfs:subClassOf ";
    for (int i = 0; i < depth; ++i) text += open;
    text += ":B ";
    for (int i = 0; i < depth; ++i) text += close;
    return text + ".";
  };
  EXPECT_EQ(short_axioms(turtle(nested(9000, "[ owl:complementOf ", "]")).ontology).size(), 1U);
  EXPECT_EQ(refused([&] { turtle(nested(100000, "[ owl:complementOf ", "]")); }).code, "nesting");
  EXPECT_EQ(refused([&] { turtle(nested(100000, "( ", ")")); }).code, "nesting");
}

TEST(Turtle, EveryCutOfAGoodDocumentIsReadOrRefused) {
  const std::string text = turtle_head +
                           ":A rdfs:subClassOf [ owl:onProperty :p ; owl:someValuesFrom ( :B \"s\\n\"@en "
                           "1.5e3 '''x''' true ) ] . :x a :A .";
  for (std::size_t cut = 0; cut < text.size(); ++cut) {
    util::Diagnostics diagnostics;
    try {
      (void)read(util::SourceText("cut.ttl", text.substr(0, cut)), {}, diagnostics);
    } catch (const util::InputError& error) {
      EXPECT_FALSE(error.diagnostic().message.empty());
    }
  }
}

}  // namespace
}  // namespace heed::owl::test
