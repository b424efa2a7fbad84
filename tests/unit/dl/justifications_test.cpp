#include "support.h"

#include <heed/util/random.h>

#include <iostream>

// Every justification is judged by reading its axioms alone, as a document of their own: they entail the
// question, and without any one of them no longer.

namespace heed::dl::test {
namespace {

struct Asking {
  std::string sub, super;  ///< Full names; an empty `super` asks whether `sub` is unsatisfiable.
  bool individual = false;
};

bool entails(const std::vector<owl::AxiomId>& kept, const owl::Ontology& whole, const Asking& asking) {
  util::Diagnostics diagnostics;
  util::Budget budget;
  const owl::Ontology part =
      owl::read(util::SourceText("part.ofn", owl::to_functional(kept, whole)), {}, diagnostics);
  const Reasoner reasoner(part, budget);
  const auto sub = part.find(asking.sub), super = part.find(asking.super);
  if (!sub) return false;
  if (asking.super.empty()) return !reasoner.satisfiable(*sub);
  if (!super) return !asking.individual && !reasoner.satisfiable(*sub);
  if (!asking.individual) return reasoner.subsumes(*super, *sub);
  const auto types = reasoner.types(*sub);
  return std::find(types.begin(), types.end(), *super) != types.end();
}

void expect_minimal(const std::optional<std::vector<owl::AxiomId>>& found, const owl::Ontology& whole,
                    const Asking& asking) {
  ASSERT_TRUE(found) << asking.sub << " " << asking.super;
  EXPECT_TRUE(entails(*found, whole, asking)) << asking.sub << " " << asking.super;
  for (const owl::AxiomId gone : *found) {
    std::vector<owl::AxiomId> fewer = *found;
    std::erase(fewer, gone);
    EXPECT_FALSE(entails(fewer, whole, asking))
        << asking.sub << " " << asking.super << " without " << owl::to_string(gone);
  }
}

/// All that is entailed of named classes and individuals beyond what holds of every ontology.
std::vector<Asking> all_entailed(const Reasoner& reasoner) {
  const owl::Ontology& o = reasoner.ontology();
  std::vector<Asking> out;
  for (const owl::Iri sub : o.entities(owl::EntityKind::Class)) {
    const std::string name(o.text(sub));
    if (!reasoner.satisfiable(sub)) {
      out.push_back({name, "", false});
      continue;
    }
    for (const owl::Iri super : reasoner.superclasses(sub))
      if (super != sub) out.push_back({name, std::string(o.text(super)), false});
  }
  for (const owl::Iri individual : o.entities(owl::EntityKind::NamedIndividual))
    for (const owl::Iri type : reasoner.types(individual))
      out.push_back({std::string(o.text(individual)), std::string(o.text(type)), true});
  return out;
}

std::optional<std::vector<owl::AxiomId>> justify(Justifier& justifier, const owl::Ontology& o,
                                                 const Asking& asking) {
  const owl::Iri sub = *o.find(asking.sub);
  if (asking.super.empty()) return justifier.unsatisfiable(owl::ClassExpression::named(sub));
  const auto super = owl::ClassExpression::named(*o.find(asking.super));
  if (asking.individual) return justifier.type(sub, super);
  return justifier.subsumption(owl::ClassExpression::named(sub), super);
}

/// \param most  Of the entailments, drawn at random; 0: all.
void judge(const std::string& file, std::size_t most) {
  const std::string path = corpus() + "/owl/" + file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no corpus at " << corpus();
  util::Diagnostics diagnostics;
  util::Budget budget;
  const Reasoner reasoner(owl::load(path, {}, {}, diagnostics), budget);
  const owl::Ontology& o = reasoner.ontology();
  Justifier justifier(o, budget);
  std::vector<Asking> questions = all_entailed(reasoner);
  util::CounterRandom random(1, 0);
  std::size_t axioms = 0, judged = 0;
  while (!questions.empty() && (most == 0 || judged < most)) {
    const std::size_t at =
        most == 0 ? questions.size() - 1 : random.below(static_cast<std::uint32_t>(questions.size()));
    const auto found = justify(justifier, o, questions[at]);
    expect_minimal(found, o, questions[at]);
    axioms += found ? found->size() : 0;
    ++judged;
    questions.erase(questions.begin() + static_cast<std::ptrdiff_t>(at));
  }
  EXPECT_GT(axioms, judged);
  std::cout << file << ": " << judged << " justifications, " << axioms << " axioms\n";
}

TEST(JustificationsCorpus, AllOfSignsAreMinimal) {
  judge("signs/signs.ttl", 0);
}

TEST(JustificationsCorpus, TwoHundredOfGalenAreMinimal) {
  judge("public/galen.owl", 200);
}

/// Here unions, complements and universals on the left take part.
TEST(JustificationsCorpus, AHundredOfPizzaAreMinimal) {
  judge("public/pizza.owl", 100);
}

}  // namespace
}  // namespace heed::dl::test
