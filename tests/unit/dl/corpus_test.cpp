#include "support.h"

#include <heed/owl/vocabulary.h>

#include <fstream>
#include <iostream>
#include <map>
#include <set>

namespace heed::dl::test {
namespace {

using Pair = std::pair<std::string, std::string>;
using Closure = std::set<Pair>;
const std::string nothing = "http://www.w3.org/2002/07/owl#Nothing";
const std::string thing = "http://www.w3.org/2002/07/owl#Thing";

/// What a document of SubClassOf and EquivalentClasses over named classes says, closed under transitivity.
Closure known_answers(const std::string& path) {
  util::Diagnostics diagnostics;
  const owl::Ontology o = owl::read(util::read_file(path), {}, diagnostics);
  std::map<std::string, std::set<std::string>> up;
  const auto add = [&](const owl::ClassExpression& sub, const owl::ClassExpression& super) {
    if (sub.is_named() && super.is_named()) up[std::string(o.text(sub.iri()))].emplace(o.text(super.iri()));
  };
  for (const owl::Axiom& axiom : o.axioms()) {
    if (const auto* inclusion = axiom.as<owl::SubClassOf>()) add(inclusion->sub, inclusion->super);
    if (const auto* same = axiom.as<owl::EquivalentClasses>())
      for (const auto& a : same->classes)
        for (const auto& b : same->classes) add(a, b);
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

/// Between satisfiable classes what is above owl:Thing or oneself says nothing.
bool says_nothing(const Closure& all, const Pair& pair) {
  const auto& [sub, super] = pair;
  return sub == super || super == thing || sub == nothing ||
         (super != nothing && all.contains({sub, nothing}));
}

/// All that the reasoner says of named classes, in the form of known_answers().
Closure answers(const Reasoner& reasoner) {
  const owl::Ontology& o = reasoner.ontology();
  Closure out;
  for (const owl::Iri sub : o.entities(owl::EntityKind::Class)) {
    const std::string name(o.text(sub));
    if (!reasoner.satisfiable(sub)) {
      out.emplace(name, nothing);
      continue;
    }
    for (const owl::Iri super : reasoner.superclasses(sub)) out.emplace(name, o.text(super));
  }
  return out;
}

/// "sub super" lines of corpus_missing.txt below the heading `[name]`, without the common namespace.
std::set<std::string> expected_missing(const std::string& name) {
  std::set<std::string> out;
  std::ifstream file(std::string(HEED_SOURCE_DIR) + "/tests/unit/dl/corpus_missing.txt");
  bool mine = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("[")) mine = line == "[" + name + "]";
    if (mine && !line.starts_with("[") && !line.starts_with("#") && !line.empty()) out.insert(line);
  }
  return out;
}

/// Whether the report of what was left out speaks of one of the two classes.
bool is_reported(const Reasoner& reasoner, const Pair& pair) {
  const auto sub = reasoner.ontology().find(pair.first), super = reasoner.ontology().find(pair.second);
  for (const Dropped& dropped : reasoner.incomplete())
    for (const owl::Iri iri : dropped.signature)
      if (iri == sub || iri == super) return true;
  return false;
}

std::string local(const std::string& iri) {
  return iri.substr(iri.find_last_of("#/") + 1);
}

struct Case {
  const char* name;
  const char* path;
  const char* known;
};

class Corpus : public testing::TestWithParam<Case> {};

TEST_P(Corpus, EqualsTheKnownAnswers) {
  const Case& given = GetParam();
  const std::string root = corpus() + "/owl/";
  if (!std::filesystem::exists(root + "reference")) GTEST_SKIP() << "no corpus at " << corpus();
  util::Diagnostics diagnostics;
  util::Budget budget;
  const Reasoner reasoner(owl::load(root + given.path, {}, {}, diagnostics), budget);
  const Closure ours = answers(reasoner), known = known_answers(root + given.known);
  for (const Pair& pair : ours)
    if (!says_nothing(known, pair) && !known.contains(pair))
      ADD_FAILURE() << "not among the known answers: " << pair.first << " below " << pair.second;
  std::set<std::string> missing;
  for (const Pair& pair : known) {
    if (says_nothing(known, pair) || ours.contains(pair) || ours.contains({pair.first, nothing})) continue;
    missing.insert(local(pair.first) + " " + local(pair.second));
    EXPECT_TRUE(is_reported(reasoner, pair)) << pair.first << " below " << pair.second;
  }
  EXPECT_EQ(missing, expected_missing(given.name)) << given.known;
  std::cout << given.known << ": " << known.size() << " known answers, " << missing.size() << " missing\n";
}

INSTANTIATE_TEST_SUITE_P(All, Corpus,
                         testing::Values(Case{"signs", "signs/signs.owl", "reference/signs.cls.owx"},
                                         Case{"galen", "public/galen.owl", "reference/galen.cls.owx"},
                                         Case{"galen", "public/galen.owl", "public/galen-conclusions.owl"},
                                         Case{"sio", "public/sio.owl", "reference/sio.cls.owx"},
                                         Case{"sio", "public/sio.owl", "public/sio-conclusions.owl"},
                                         Case{"pizza", "public/pizza.owl", "reference/pizza.cls.owx"},
                                         Case{"wine", "public/wine.owl", "reference/wine.cls.owx"},
                                         Case{"SWEET", "public/SWEET.owl", "reference/SWEET.cls.owx"},
                                         Case{"SWEET", "public/SWEET.owl", "public/SWEET-conclusions.owl"},
                                         Case{"auto", "auto/automotive_urban_traffic_ontology.owl",
                                              "reference/auto_merged.cls.owx"}),
                         [](const auto& instance) {
                           const bool published = std::string(instance.param.known).starts_with("public");
                           return std::string(instance.param.name) + (published ? "Published" : "Konclude");
                         });

/// Every ontology of the corpus is compared, so that a file that is added does not go unnoticed.
TEST(CorpusFiles, NoOntologyIsForgotten) {
  if (!std::filesystem::exists(corpus() + "/owl/public")) GTEST_SKIP() << "no corpus at " << corpus();
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(corpus() + "/owl/public"))
    found.insert(entry.path().filename().string());
  EXPECT_EQ(found,
            (std::set<std::string>{"SWEET-conclusions.owl", "SWEET.owl", "galen-conclusions.owl", "galen.owl",
                                   "pizza.owl", "sio-conclusions.owl", "sio.owl", "wine.owl"}));
}

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
