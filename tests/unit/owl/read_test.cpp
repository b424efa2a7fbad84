#include "axioms.h"
#include "temporary_folder.h"

#include <heed/owl/signature.h>
#include <heed/owl/vocabulary.h>

#include <gmock/gmock.h>

#include <fstream>
#include <set>

namespace heed::owl::test {
namespace {

Ontology read_corpus(const std::string& name) {
  util::Diagnostics diagnostics;
  Ontology out = read(util::read_file(corpus() + "/owl/" + name), {}, diagnostics);
  for (const auto& d : diagnostics) ADD_FAILURE() << util::to_string(d);
  return out;
}

TEST(OwlCorpus, TheSyntaxesOfTheSignsSayTheSame) {
  if (!std::filesystem::exists(corpus() + "/owl/signs")) GTEST_SKIP() << "no corpus at " << corpus();
  const auto xml = logical(read_corpus("signs/signs.owl"));
  EXPECT_EQ(xml.size(), 76U);
  for (const char* other : {"signs.ttl", "signs.owx", "signs.ofn", "signs.omn"}) {
    SCOPED_TRACE(other);
    EXPECT_EQ(xml, logical(read_corpus(std::string("signs/") + other)));
  }
}

TEST(OwlCorpus, PublicOntologiesLeaveNothingNotUnderstood) {
  if (!std::filesystem::exists(corpus() + "/owl/public")) GTEST_SKIP() << "no corpus at " << corpus();
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus() + "/owl/public")) {
    SCOPED_TRACE(entry.path().string());
    EXPECT_GT(read_corpus("public/" + entry.path().filename().string()).axioms().size(), 100U);
    ++files;
  }
  std::cout << files << " files read, none skipped\n";
}

TEST(OwlCorpus, LoadsTheClosureOfTheAutomotiveOntology) {
  const std::string root = corpus() + "/owl/auto/automotive_urban_traffic_ontology.owl";
  if (!std::filesystem::exists(root)) GTEST_SKIP() << "no corpus at " << corpus();
  util::Diagnostics diagnostics;
  const Ontology all = load(root, {}, {}, diagnostics);
  ASSERT_EQ(diagnostics.size(), 1U) << "physics.owl ends in a node that is nothing";
  EXPECT_EQ(diagnostics[0].code, "not-understood");
  EXPECT_EQ(diagnostics[0].location.line, 1532U);
  std::set<std::string> imports;
  for (const Import& import : all.imports()) imports.insert(import.iri);
  EXPECT_EQ(imports.size() + 1, 27U);
  std::set<std::string> documents;
  for (const Axiom& axiom : all.axioms()) documents.emplace(axiom.location.file_name());
  EXPECT_EQ(documents.size(), 25U) << "two documents only import";
  std::cout << imports.size() + 1 << " documents read, none skipped\n";
  for (std::uint32_t i = 0; i < all.axioms().size(); ++i) ASSERT_EQ(all.axioms()[i].id.number, i + 1);
}

TEST(Read, RecognisesSyntaxesByContentBeforeTheName) {
  const auto of = [](const std::string& text, const std::string& name) {
    return recognise(util::SourceText(name, text));
  };
  EXPECT_EQ(of("<?xml version='1.0'?><!-- c --><!DOCTYPE x [<!ENTITY a \"b\">]><rdf:RDF/>", "x.ttl"),
            Syntax::RdfXml);
  EXPECT_EQ(of("# c\n@prefix : <a:b> .", "x.owl"), Syntax::Turtle);
  EXPECT_EQ(of("<?xml version='1.0'?>\n<Ontology xmlns=\"x\"/>", "x.owl"), Syntax::OwlXml);
  EXPECT_EQ(of("Prefix(:=<a:b>)", "x.owl"), Syntax::Functional);
  EXPECT_EQ(of("Prefix: : <a:b>", "x.owl"), Syntax::Manchester);
  EXPECT_EQ(of("", "x.ttl"), Syntax::Turtle);
  EXPECT_EQ(of("hello", "x.txt"), Syntax::Unknown);
}

std::string utf16(std::string_view ascii, bool big) {
  std::string out = big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) (out += big ? '\0' : c) += big ? c : '\0';
  return out;
}

TEST(Read, OtherEncodingsAreConvertedOrRefused) {
  const auto document = [](const std::string& encoding, const std::string& label) {
    return "<?xml version=\"1.0\" encoding=\"" + encoding +
           "\"?>\n<Ontology "
           "xmlns=\"http://www.w3.org/2002/07/owl#\"><AnnotationAssertion><AnnotationProperty "
           "abbreviatedIRI=\"rdfs:label\"/><IRI>http://e/#A</IRI><Literal>" +
           label + "</Literal></AnnotationAssertion></Ontology>";
  };
  const auto label = [](const std::string& text) {
    const Read read = read_text(text, "x.owx");
    return read.ontology.name(*read.ontology.find("http://e/#A"));
  };
  EXPECT_EQ(label(document("ISO-8859-1", "caf\xE9")), "caf\xC3\xA9");
  EXPECT_EQ(label(document("utf-8", "caf\xC3\xA9")), "caf\xC3\xA9");
  EXPECT_EQ(label(utf16(document("UTF-16", "coffee"), true)), "coffee");
  EXPECT_EQ(label(utf16(document("UTF-16", "coffee"), false)), "coffee");
  EXPECT_EQ(short_axioms(read_text(utf16(turtle_head + ":A rdfs:subClassOf :B .", true)).ontology).size(),
            1U);
  const auto code = [](const std::string& text) {
    return refused([&] { (void)read_text(text, "x.owx"); }).code;
  };
  EXPECT_EQ(code(document("EBCDIC", "x")), "encoding");
  EXPECT_EQ(code(document("UTF-16", "x")), "encoding");
  EXPECT_EQ(code(utf16("<a/>", true) + "x"), "bad-encoding");
  EXPECT_EQ(code("\xFE\xFF\xD8\x3D\x20\x20"), "bad-encoding");
  std::string pair = utf16(document("UTF-16", "@@"), false);
  pair.replace(pair.find(std::string("@\0@\0", 4)), 4, std::string("\x3D\xD8\x00\xDE", 4));
  EXPECT_EQ(label(pair), "\xF0\x9F\x98\x80");
}

class Imports : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path(name)) << text;
    return folder_.path(name);
  }
  std::string document(const std::string& self, const std::string& import, const std::string& body) {
    return turtle_head + "<http://e/" + self + "> a owl:Ontology ; owl:imports <http://e/" + import +
           "> .\n" + body;
  }
  heed::test::TemporaryFolder folder_;
};

TEST_F(Imports, FollowTheCatalogueAndEndInCycles) {
  const std::string root = write("a.ttl", document("a", "b", ":x :p :y ."));
  write("b.ttl", document("b", "a", ":p a owl:ObjectProperty . _:n a :A ."));
  write("catalog-v001.xml", "<catalog><group><uri name=\"http://e/b\" uri=\"b.ttl\"/></group></catalog>");
  util::Diagnostics diagnostics;
  const Ontology all = load(root, {}, {}, diagnostics);
  EXPECT_THAT(short_axioms(all),
              testing::ElementsAre("ObjectPropertyAssertion(p x y)", "ClassAssertion(A _:d1b0)"));
  EXPECT_EQ(all.iri(), "http://e/a");
  EXPECT_EQ(all.imports().size(), 2U);
  EXPECT_TRUE(diagnostics.empty());
}

TEST_F(Imports, MissingOnesAreAnErrorUnlessAllowed) {
  const std::string root = write("a.ttl", document("a", "nowhere", ":A rdfs:subClassOf :B ."));
  util::Diagnostics diagnostics;
  const auto error = refused([&] { (void)load(root, {}, {}, diagnostics); });
  EXPECT_EQ(error.code, "missing-import");
  EXPECT_EQ(error.location.line, 2U);
  EXPECT_FALSE(error.hint.empty());
  ImportOptions options;
  options.allow_missing = true;
  EXPECT_EQ(short_axioms(load(root, options, {}, diagnostics)).size(), 1U);
  EXPECT_EQ(diagnostics.size(), 1U);
  options.allow_missing = false;
  options.mapping.emplace_back("http://e/nowhere", write("c.ttl", turtle_head + ":C rdfs:subClassOf :D ."));
  EXPECT_EQ(short_axioms(load(root, options, {}, diagnostics)).size(), 2U);
}

TEST(Ontology, KnowsNamesLabelsAndKinds) {
  const Read read = turtle(
      ":StopSign a owl:Class ; rdfs:label \"Stop sign\"@en, \"Segnale di stop\"@it . :Red a owl:Class ; "
      "rdfs:label \"red\" .\n"
      ":hasColour a owl:ObjectProperty . :StopSign rdfs:subClassOf [ owl:onProperty :hasColour ; "
      "owl:someValuesFrom :Red ] .");
  const Ontology& o = read.ontology;
  const Iri stop = *o.find("http://e/#StopSign");
  EXPECT_EQ(o.name(stop), "Stop sign");
  EXPECT_EQ(o.name(stop, "it"), "Segnale di stop");
  EXPECT_EQ(o.name(*o.find("http://e/#Red")), "red");
  EXPECT_EQ(o.local_name(stop), "StopSign");
  for (const char* name : {"StopSign", ":StopSign", "Stop sign", "Segnale di stop", "http://e/#StopSign"})
    EXPECT_THAT(o.lookup(name), testing::ElementsAre(stop)) << name;
  EXPECT_TRUE(o.lookup("nothing").empty());
  EXPECT_EQ(to_text(o.axioms().back(), o), "Stop sign SubClassOf hasColour some red");
  EXPECT_EQ(signature(o.axioms().back().content).size(), 3U);
  EXPECT_EQ(*o.find("http://www.w3.org/2002/07/owl#Thing"), vocabulary::owl_thing);
  for (std::uint32_t id = 0; id < vocabulary::size; ++id)
    EXPECT_EQ(o.text(Iri{id}), vocabulary::text(Iri{id}));
}

TEST(Print, BracketsFollowTheNesting) {
  const Read read = turtle(
      ":A rdfs:subClassOf [ owl:intersectionOf ( :B [ owl:unionOf ( :C [ owl:complementOf :D ] ) ] [ "
      "owl:onProperty :p ; "
      "owl:allValuesFrom [ owl:onProperty :q ; owl:hasValue :x ] ] ) ] .");
  EXPECT_EQ(to_text(read.ontology.axioms()[0], read.ontology),
            "A SubClassOf B and (C or (not D)) and (p only (q value x))");
  const std::string document = to_functional({AxiomId{1}, AxiomId{1}}, read.ontology);
  EXPECT_EQ(document.find("SubClassOf("), document.rfind("SubClassOf("));
  EXPECT_NE(document.find("Declaration(ObjectProperty(<http://e/#p>))"), std::string::npos);
}

}  // namespace
}  // namespace heed::owl::test
