#include "support.h"

#include <algorithm>
#include <set>

namespace heed::dl::test {
namespace {

/// The lines of \p text that hold the axioms \p kept (one axiom a line), read and classified anew.
std::string lines_of(const std::string& text, const owl::Ontology& ontology,
                     const std::vector<owl::AxiomId>& kept) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  std::string out;
  for (const owl::AxiomId id : kept) out += lines[ontology.axiom(id).location.line - 2] + "\n";
  return out;
}

const std::string declarations =
    ":A a owl:Class.\n:B a owl:Class.\n:C a owl:Class.\n:D a owl:Class.\n:Q a owl:Class.\n:f a "
    "owl:ObjectProperty.\n"
    ":r a owl:ObjectProperty.\n:s a owl:ObjectProperty.\n";
const std::string rules =
    ":r rdfs:subPropertyOf :f.\n:s rdfs:subPropertyOf :f.\n:f a owl:FunctionalProperty.\n"
    ":A rdfs:subClassOf [owl:onProperty :r; owl:someValuesFrom :B].\n"
    ":A rdfs:subClassOf [owl:onProperty :s; owl:someValuesFrom :C].\n"
    "[owl:onProperty :s; owl:someValuesFrom :B] rdfs:subClassOf :Q.\n"
    ":B rdfs:subClassOf :D.\n:D rdfs:subClassOf :B.\n:f rdfs:range :D.\n:Q rdfs:subClassOf :C.\n"
    ":A rdfs:subClassOf :D.\n:D owl:disjointWith :C.\n";

/// Alone it entails the question; without any one axiom it does not.
void expect_minimal(const std::string& text, const Asked& whole, const std::vector<owl::AxiomId>& found,
                    const std::string& sub, const std::string& super) {
  const auto entails = [&](const std::vector<owl::AxiomId>& kept) {
    const Asked part(declarations + lines_of(text, whole.ontology, kept));
    return super.empty() ? !part.satisfiable(sub) : part.below(sub, super);
  };
  EXPECT_TRUE(entails(found)) << sub << " " << super;
  for (const owl::AxiomId gone : found) {
    std::vector<owl::AxiomId> fewer = found;
    std::erase(fewer, gone);
    EXPECT_FALSE(entails(fewer)) << sub << " " << super << " without " << owl::to_string(gone);
  }
}

TEST(Justifier, EverySubsumptionGetsAMinimalSet) {
  for (const bool clash : {false, true}) {
    const std::string text =
        declarations + (clash ? rules : rules.substr(0, rules.rfind(":D owl:disjointWith")));
    const Asked whole(text);
    util::Budget budget;
    Justifier justifier(whole.ontology, budget);
    for (const std::string sub : {"A", "B", "C", "D", "Q"})
      for (const std::string super : {"A", "B", "C", "D", "Q"}) {
        const auto found = justifier.subsumption(whole.cls(sub), whole.cls(super));
        ASSERT_EQ(found.has_value(), whole.below(sub, super)) << sub << " " << super;
        if (found) expect_minimal(text, whole, *found, sub, super);
      }
    const auto unsatisfiable = justifier.unsatisfiable(whole.cls("A"));
    ASSERT_EQ(unsatisfiable.has_value(), clash);
    if (clash) expect_minimal(text, whole, *unsatisfiable, "A", "");
  }
}

TEST(Justifier, TautologiesNeedNothing) {
  const Asked whole(declarations + rules);
  util::Budget budget;
  Justifier justifier(whole.ontology, budget);
  EXPECT_TRUE(justifier.subsumption(whole.cls("A"), owl::ClassExpression::thing())->empty());
  EXPECT_TRUE(justifier.subsumption(whole.cls("A"), whole.cls("A"))->empty());
  EXPECT_FALSE(justifier.inconsistent());
}

TEST(Justifier, TypesAndInconsistency) {
  const Asked whole(":A a owl:Class.\n:A rdfs:subClassOf :B.\n:x a :A.\n:x a :C.\n:B owl:disjointWith :D.\n");
  util::Budget budget;
  Justifier justifier(whole.ontology, budget);
  const auto type = justifier.type(whole.iri("x"), whole.cls("B"));
  ASSERT_TRUE(type);
  EXPECT_EQ(type->size(), 2U);
  const Asked broken(":A rdfs:subClassOf :B.\n:x a :A.\n:x a :D.\n:B owl:disjointWith :D.\n:x a :E.\n");
  Justifier why(broken.ontology, budget);
  ASSERT_TRUE(why.inconsistent());
  EXPECT_EQ(why.inconsistent()->size(), 4U);
}

/// All minimal sets of axioms, by trying every set.
std::set<std::vector<owl::AxiomId>> by_trying(const std::string& text, const Asked& whole,
                                              const std::string& sub, const std::string& super) {
  std::vector<owl::AxiomId> logical;
  for (const owl::Axiom& axiom : whole.ontology.axioms())
    if (owl::is_logical(axiom)) logical.push_back(axiom.id);
  std::vector<unsigned> entailing;
  for (unsigned bits = 0; bits < 1U << logical.size(); ++bits) {
    if (std::any_of(entailing.begin(), entailing.end(), [&](unsigned e) { return (bits & e) == e; }))
      continue;
    std::vector<owl::AxiomId> kept;
    for (std::size_t i = 0; i < logical.size(); ++i)
      if ((bits >> i & 1U) != 0) kept.push_back(logical[i]);
    const Asked part(declarations + lines_of(text, whole.ontology, kept));
    if (part.below(sub, super)) entailing.push_back(bits);
  }
  std::set<std::vector<owl::AxiomId>> out;
  for (const unsigned bits : entailing) {
    const bool smallest = std::none_of(entailing.begin(), entailing.end(),
                                       [&](unsigned e) { return e != bits && (bits & e) == e; });
    std::vector<owl::AxiomId> kept;
    for (std::size_t i = 0; i < logical.size(); ++i)
      if ((bits >> i & 1U) != 0) kept.push_back(logical[i]);
    if (smallest) out.insert(kept);
  }
  return out;
}

TEST(Justifier, FindsAllMinimalSets) {
  const std::string text = declarations +
                           ":A rdfs:subClassOf :B.\n:A rdfs:subClassOf :C.\n:B rdfs:subClassOf :D.\n:C "
                           "rdfs:subClassOf :D.\n:A rdfs:subClassOf :D.\n:B rdfs:subClassOf :C.\n:D "
                           "rdfs:subClassOf :Q.\n:A rdfs:subClassOf [owl:onProperty :r; owl:someValuesFrom "
                           ":B].\n:r rdfs:domain :C.\n";
  const Asked whole(text);
  util::Budget budget;
  Justifier justifier(whole.ontology, budget);
  for (const std::string super : {"C", "D", "Q"}) {
    const Justifications all = justifier.all_subsumption(whole.cls("A"), whole.cls(super), 100);
    EXPECT_TRUE(all.complete);
    EXPECT_EQ((std::set<std::vector<owl::AxiomId>>(all.sets.begin(), all.sets.end())),
              by_trying(text, whole, "A", super))
        << super;
  }
  const Justifications some = justifier.all_subsumption(whole.cls("A"), whole.cls("D"), 2);
  EXPECT_FALSE(some.complete);
  EXPECT_EQ(some.sets.size(), 2U);
  EXPECT_TRUE(justifier.all_subsumption(whole.cls("D"), whole.cls("A"), 2).sets.empty());
}

}  // namespace
}  // namespace heed::dl::test
