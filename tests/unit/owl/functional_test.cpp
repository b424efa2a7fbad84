#include "axioms.h"

#include <heed/owl/write.h>

#include <gmock/gmock.h>

namespace heed::owl::test {
namespace {

using testing::ElementsAre;

Read functional(const std::string& body) {
  return read_text("Prefix(:=<http://e/#>)\nPrefix(q:=<http://e/#q>)\nOntology(<http://e/> <http://e/1>\n" +
                       body + "\n)\n",
                   "test.ofn");
}

const std::vector<std::string> axioms = {
    "Declaration(Class(A))",
    "Declaration(NamedIndividual(i))",
    "SubClassOf(A ObjectIntersectionOf(B ObjectUnionOf(C ObjectComplementOf(D))))",
    "EquivalentClasses(A B ObjectOneOf(i j))",
    "DisjointClasses(A B C)",
    "DisjointUnion(A B C)",
    "SubClassOf(A ObjectSomeValuesFrom(ObjectInverseOf(p) ObjectAllValuesFrom(p B)))",
    "SubClassOf(ObjectHasValue(p i) ObjectHasSelf(p))",
    "SubClassOf(ObjectMinCardinality(2 p B) ObjectMaxCardinality(1 p Thing))",
    "SubClassOf(ObjectExactCardinality(3 p B) DataSomeValuesFrom(d integer))",
    "SubClassOf(DataAllValuesFrom(d DataIntersectionOf(integer DataComplementOf(string))) DataHasValue(d "
    "\"x\"))",
    "SubClassOf(DataMinCardinality(1 d string) DataMaxCardinality(2 d DataOneOf(\"a\" \"b\"@en)))",
    "SubClassOf(A DataExactCardinality(1 d DatatypeRestriction(integer minInclusive \"5\"^^integer "
    "maxExclusive "
    "\"9\"^^integer)))",
    "SubClassOf(A DataSomeValuesFrom(d d2 DataUnionOf(integer string)))",
    "SubObjectPropertyOf(p p2)",
    "SubObjectPropertyOf(ObjectPropertyChain(p ObjectInverseOf(p2)) p)",
    "EquivalentObjectProperties(p p2)",
    "DisjointObjectProperties(p p2)",
    "InverseObjectProperties(p p2)",
    "ObjectPropertyDomain(p A)",
    "ObjectPropertyRange(p A)",
    "FunctionalObjectProperty(p)",
    "InverseFunctionalObjectProperty(p)",
    "ReflexiveObjectProperty(p)",
    "IrreflexiveObjectProperty(p)",
    "SymmetricObjectProperty(ObjectInverseOf(p))",
    "AsymmetricObjectProperty(p)",
    "TransitiveObjectProperty(p)",
    "SubDataPropertyOf(d d2)",
    "EquivalentDataProperties(d d2)",
    "DisjointDataProperties(d d2)",
    "DataPropertyDomain(d A)",
    "DataPropertyRange(d integer)",
    "FunctionalDataProperty(d)",
    "DatatypeDefinition(t integer)",
    "HasKey(A (p ObjectInverseOf(p2)) (d))",
    "HasKey(A () (d))",
    "SameIndividual(i j)",
    "DifferentIndividuals(i j k)",
    "ClassAssertion(A i)",
    "ObjectPropertyAssertion(p i _:d0b0)",
    "NegativeObjectPropertyAssertion(p i j)",
    "DataPropertyAssertion(d i \"say \\\"hi\\\" \\\\ there\")",
    "NegativeDataPropertyAssertion(d i \"1\"^^integer)",
    "AnnotationAssertion(a A \"text\"@en-gb)",
    "AnnotationAssertion(Annotation(a2 \"inner\") a i j)",
    "SubAnnotationPropertyOf(a a2)",
    "AnnotationPropertyDomain(a A)",
    "AnnotationPropertyRange(a A)",
    "SubClassOf(Annotation(Annotation(a \"deep\") a2 i) A B)"};
/// The short form of short_axioms() with its prefixes.
std::string prefixed(const std::string& axiom) {
  std::string text;
  for (std::size_t at = 0; at < axiom.size();) {
    // A name of small letters, or one capital, gets the prefix; words with a bracket behind them do not.
    const std::size_t end = std::min(axiom.find_first_of(" ()\"^@:", at), axiom.size());
    const std::string word = axiom.substr(at, end - at);
    const bool is_number = word.find_first_not_of("0123456789") == std::string::npos;
    const char next = end < axiom.size() ? axiom[end] : ' ';
    static const std::set<std::string> xsd = {"integer", "string", "minInclusive", "maxExclusive"};
    if (!is_number && next != '(' && next != ':')
      text += word == "Thing" ? "owl:" : xsd.contains(word) ? "xsd:" : ":";
    text += word;
    at = end;
    if (next == '"') {
      std::size_t close = at + 1;
      while (axiom[close] != '"') close += axiom[close] == '\\' ? 2 : 1;
      text += axiom.substr(at, close + 1 - at);
      at = close + 1;
      if (at < axiom.size() && axiom[at] == '@') {
        const std::size_t tag = axiom.find_first_of(" )", at);
        text += axiom.substr(at, tag - at);
        at = tag;
      }
      if (at < axiom.size() && axiom[at] == '^') text += "^^", at += 2;
    } else if (next == ':') {
      text += axiom.substr(at, 5), at += 5;
    } else if (at < axiom.size()) {
      text += axiom[at++];
    }
  }
  return text;
}

/// What the writer writes is what was read.
TEST(Functional, EveryWordComesBack) {
  std::string body;
  for (const std::string& axiom : axioms) body += prefixed(axiom) + "\n";
  const Read read = functional(body);
  EXPECT_THAT(short_axioms(read.ontology, true), testing::ElementsAreArray(axioms)) << body;
  EXPECT_EQ(all_axioms(read_text(write_functional(read.ontology), "x.ofn").ontology),
            all_axioms(read.ontology));
  for (std::uint32_t i = 0; i < axioms.size(); ++i) EXPECT_EQ(read.ontology.axioms()[i].location.line, i + 4);
}

TEST(Functional, HeaderImportsAndAnnotations) {
  const Read read = functional(
      "Import(<http://e/other>) Annotation(rdfs:comment \"x # no comment\") # a comment )\nSubClassOf( "
      "q:A\t<http://f> )");
  EXPECT_EQ(read.ontology.iri(), "http://e/");
  EXPECT_EQ(read.ontology.version_iri(), "http://e/1");
  ASSERT_EQ(read.ontology.imports().size(), 1U);
  EXPECT_EQ(read.ontology.imports()[0].location.line, 4U);
  EXPECT_EQ(read.ontology.annotations().size(), 1U);
  EXPECT_THAT(short_axioms(read.ontology), ElementsAre("SubClassOf(qA http://f)"));
  EXPECT_TRUE(read_text("Ontology()", "x.ofn").ontology.axioms().empty());
}

TEST(Functional, PlainLiteralsAreStringsWithALanguage) {
  EXPECT_THAT(short_axioms(functional("DataPropertyAssertion(:d :i \"a@b@EN\"^^rdf:PlainLiteral)"
                                      "DataPropertyAssertion(:d :i \"ab@\"^^rdf:PlainLiteral)")
                               .ontology),
              ElementsAre("DataPropertyAssertion(d i \"a@b\"@en)", "DataPropertyAssertion(d i \"ab\")"));
}

TEST(Functional, DeepNestingWorksToTheLimitAndIsRefusedBeyond) {
  const auto nested = [](std::size_t depth) {
    std::string text = "SubClassOf(:A ";
    for (std::size_t i = 0; i < depth; ++i) text += "ObjectComplementOf(";
    return text + ":B" + std::string(depth + 1, ')');
  };
  const Read deep = functional(nested(9'900));
  EXPECT_EQ(deep.ontology.axioms()[0].as<SubClassOf>()->super.depth(), 9'900U);
  EXPECT_EQ(all_axioms(read_text(write_functional(deep.ontology), "x.ofn").ontology).size(), 1U);
  EXPECT_EQ(refused([&] { (void)functional(nested(100'000)); }).code, "nesting");
}

TEST(Functional, FlawsAreNamed) {
  const std::pair<std::string, std::string> cases[] = {{"SubClassOf(:A)", "too-few"},
                                                       {"SubClassOf(:A :B :C)", "too-many"},
                                                       {"SubClasOf(:A :B)", "unknown-word"},
                                                       {"SubClassOf(:A :B", "open-ontology"},
                                                       {"SubClassOf(:A SubClassOf(:A :B))", "misplaced"},
                                                       {"ObjectUnionOf(:A :B)", "misplaced"},
                                                       {"SubClassOf(:A \"x\")", "wrong-argument"},
                                                       {"SubClassOf(x:A :B)", "undeclared-prefix"},
                                                       {"SubClassOf(A :B)", "syntax"},
                                                       {"SubClassOf(:A <http://a b>)", "bad-iri"},
                                                       {"SubClassOf(:A _:b)", "wrong-argument"},
                                                       {"HasKey(:A (:p))", "too-few"},
                                                       {"Declaration(:A)", "wrong-argument"},
                                                       {"SubClassOf(:A \"x", "open-string"},
                                                       {") )", "syntax"}};
  for (const auto& [body, code] : cases)
    EXPECT_EQ(refused([&, text = body] { (void)functional(text); }).code, code) << body;
}

/// RDF knows these axioms only as pairs.
std::multiset<std::string> in_pairs(const Ontology& ontology) {
  std::multiset<std::string> out;
  const auto add = [&](AxiomContent content, const Axiom& axiom) {
    Axiom pair = axiom;
    pair.content = std::move(content);
    out.insert(sorted_text(blank_names_alike(to_functional(pair, ontology))));
  };
  for (const Axiom& axiom : ontology.axioms()) {
    if (axiom.as<Declaration>()) continue;
    if (const auto* a = axiom.as<EquivalentClasses>())
      for (std::size_t i = 0; i + 1 < a->classes.size(); ++i)
        add(EquivalentClasses{{a->classes[i], a->classes[i + 1]}}, axiom);
    else if (const auto* s = axiom.as<SameIndividual>())
      for (std::size_t i = 0; i + 1 < s->individuals.size(); ++i)
        add(SameIndividual{{s->individuals[i], s->individuals[i + 1]}}, axiom);
    else
      add(axiom.content, axiom);
  }
  return out;
}

TEST(Turtle, WhatIsWrittenReadsBack) {
  std::string body;
  for (const std::string& axiom : axioms) body += prefixed(axiom) + "\n";
  body +=
      "SubClassOf(Annotation(rdfs:comment \"a\\\\b\n\\\"c\") ObjectUnionOf(:A :B) ObjectComplementOf(:C))\n"
      "SubObjectPropertyOf(Annotation(:a \"chain\") ObjectPropertyChain(:p :p2) :p)\n"
      "DisjointClasses(Annotation(Annotation(:a :x) :a2 \"all\"@en) :A :B :C)";
  const Ontology before = functional(body).ontology;
  const Read after = read_text(write_turtle(before), "again.ttl");
  for (const auto& d : after.diagnostics) ADD_FAILURE() << util::to_string(d);
  EXPECT_EQ(in_pairs(after.ontology), in_pairs(before)) << write_turtle(before);
  EXPECT_EQ(after.ontology.version_iri(), "http://e/1");
}

/// In XML a prefix may stand for what is no IRI.
TEST(Functional, PrefixesThatCannotBeWrittenAreLeftOut) {
  const Ontology before =
      read_text(
          "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" xmlns:bad=\"http://e/?></x\" "
          "xmlns:\xC3\xA9=\"http://f/#\" xmlns:owl=\"http://www.w3.org/2002/07/owl#\">"
          "<owl:Class rdf:about=\"http://e/#A\"/></rdf:RDF>",
          "a.owl")
          .ontology;
  const std::string written = write_functional(before);
  EXPECT_EQ(written.find("bad"), std::string::npos);
  EXPECT_NE(written.find("Prefix(owl:="), std::string::npos);
  EXPECT_EQ(all_axioms(read_text(written, "again.ofn").ontology), all_axioms(before));
}

TEST(OwlCorpus, TurtleRoundTripKeepsEveryAxiom) {
  const auto files = corpus_files();
  if (files.empty()) GTEST_SKIP() << "no corpus at " << corpus();
  for (const std::string& path : files) {
    SCOPED_TRACE(path);
    const Ontology before = read_path(path);
    EXPECT_EQ(in_pairs(read_text(write_turtle(before), "again.ttl").ontology), in_pairs(before));
  }
  std::cout << files.size() << " files written and read, none skipped\n";
}

TEST(OwlCorpus, FunctionalRoundTripKeepsEveryAxiom) {
  const auto files = corpus_files();
  if (files.empty()) GTEST_SKIP() << "no corpus at " << corpus();
  for (const std::string& path : files) {
    SCOPED_TRACE(path);
    const Ontology before = read_path(path);
    const Ontology after = read_text(write_functional(before), "again.ofn").ontology;
    EXPECT_EQ(all_axioms(after), all_axioms(before));
    EXPECT_EQ(after.annotations().size(), before.annotations().size());
    EXPECT_EQ(after.iri(), before.iri());
  }
  std::cout << files.size() << " files written and read, none skipped\n";
}

}  // namespace
}  // namespace heed::owl::test
