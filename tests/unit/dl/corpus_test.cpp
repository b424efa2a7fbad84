#include "support.h"

#include <heed/owl/vocabulary.h>

#include <map>
#include <set>

namespace heed::dl::test {
namespace {

using Closure = std::set<std::pair<std::string, std::string>>;
const std::string nothing = "http://www.w3.org/2002/07/owl#Nothing";
const std::string thing = "http://www.w3.org/2002/07/owl#Thing";

/// The subsumptions of an OWL/XML file of SubClassOf and EquivalentClasses over named classes, closed under
/// transitivity.
Closure reference(const std::string& path) {
  const std::string text = util::read_file(path).text();
  std::map<std::string, std::set<std::string>> up;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const bool sub = text.compare(at, 11, "<SubClassOf") == 0;
    if (!sub && text.compare(at, 18, "<EquivalentClasses") != 0) continue;
    const std::size_t end = text.find(sub ? "</SubClassOf" : "</EquivalentClasses", at);
    std::vector<std::string> classes;
    for (std::size_t c = text.find("IRI=\"", at); c < end; c = text.find("IRI=\"", c + 5))
      classes.push_back(text.substr(c + 5, text.find('"', c + 5) - c - 5));
    for (std::size_t i = 0; i < classes.size(); ++i)
      for (std::size_t j = 0; j < classes.size(); ++j)
        if (sub ? i == 0 && j == 1 : i != j) up[classes[i]].insert(classes[j]);
  }
  Closure out;
  for (const auto& entry : up) {
    std::vector<std::string> open = {entry.first};
    while (!open.empty()) {
      const std::string next = open.back();
      open.pop_back();
      for (const std::string& above : up[next])
        if (out.emplace(entry.first, above).second) open.push_back(above);
    }
  }
  return out;
}

struct Difference {
  std::set<std::pair<std::string, std::string>> extra, missing;
};

Difference compare(const std::string& ontology_path, const std::string& reference_path) {
  util::Diagnostics diagnostics;
  util::Budget budget;
  const Reasoner reasoner(owl::load(ontology_path, {}, {}, diagnostics), budget);
  const owl::Ontology& o = reasoner.ontology();
  const Closure expected = reference(reference_path);
  Difference out;
  const auto trivial = [&](const std::string& sub, const std::string& super) {
    return sub == super || super == thing || sub == nothing ||
           (super != nothing && expected.contains({sub, nothing}));
  };
  for (const owl::Iri sub : o.entities(owl::EntityKind::Class)) {
    const std::string name(o.text(sub));
    if (!reasoner.satisfiable(sub) && !expected.contains({name, nothing})) out.extra.emplace(name, nothing);
    for (const owl::Iri super : reasoner.superclasses(sub))
      if (!trivial(name, std::string(o.text(super))) &&
          !expected.contains({name, std::string(o.text(super))}))
        out.extra.emplace(name, o.text(super));
  }
  for (const auto& [sub, super] : expected) {
    const auto a = o.find(sub), b = o.find(super);
    if (trivial(sub, super) || !a || !b) continue;
    if (super == nothing ? reasoner.satisfiable(*a) : !reasoner.subsumes(*b, *a))
      out.missing.emplace(sub, super);
  }
  return out;
}

struct Case {
  const char* name;
  const char* path;
  const char* reference;
  std::size_t missing;  ///< At most: what needs case distinctions, which the Horn fragment has not.
};

class Corpus : public testing::TestWithParam<Case> {};

TEST_P(Corpus, ClosureMatchesTheReference) {
  const Case& given = GetParam();
  const std::string root = corpus() + "/owl/";
  if (!std::filesystem::exists(root + "reference")) GTEST_SKIP() << "no corpus at " << corpus();
  const Difference found = compare(root + given.path, root + "reference/" + given.reference + ".cls.owx");
  for (const auto& [sub, super] : found.extra)
    ADD_FAILURE() << "not in the reference: " << sub << " below " << super;
  EXPECT_LE(found.missing.size(), given.missing);
}

INSTANTIATE_TEST_SUITE_P(
    All, Corpus,
    testing::Values(Case{"signs", "signs/signs.owl", "signs", 0},
                    Case{"galen", "public/galen.owl", "galen", 0}, Case{"sio", "public/sio.owl", "sio", 5},
                    Case{"pizza", "public/pizza.owl", "pizza", 67},
                    Case{"wine", "public/wine.owl", "wine", 29},
                    Case{"SWEET", "public/SWEET.owl", "SWEET", 517},
                    Case{"auto", "auto/automotive_urban_traffic_ontology.owl", "auto_merged", 2}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(Signs, TheTwoAccidentsAreFoundAndJustified) {
  if (!std::filesystem::exists(corpus() + "/owl/signs")) GTEST_SKIP() << "no corpus at " << corpus();
  util::Diagnostics diagnostics;
  util::Budget budget;
  const owl::Ontology o = owl::read(util::read_file(corpus() + "/owl/signs/signs.ttl"), {}, diagnostics);
  const Reasoner reasoner(o, budget);
  const auto iri = [&](const char* name) {
    return *o.find(std::string("http://example.org/ontologies/traffic-signs#") + name);
  };
  EXPECT_EQ(reasoner.taxonomy().node_of(iri("NoEntry")), reasoner.taxonomy().node_of(iri("ProhibitorySign")));
  EXPECT_EQ(reasoner.taxonomy().node_of(iri("ImpossibleSign")), 1U);
  EXPECT_TRUE(reasoner.consistent());
  Justifier justifier(o, budget);
  const auto impossible = justifier.unsatisfiable(owl::ClassExpression::named(iri("ImpossibleSign")));
  ASSERT_TRUE(impossible);
  EXPECT_EQ(impossible->size(), 5U);
  const auto accident = justifier.subsumption(owl::ClassExpression::named(iri("ProhibitorySign")),
                                              owl::ClassExpression::named(iri("NoEntry")));
  ASSERT_TRUE(accident);
  EXPECT_EQ(accident->size(), 5U);
}

}  // namespace
}  // namespace heed::dl::test
