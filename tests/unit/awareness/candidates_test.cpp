// Observations of small random ontologies, judged three times: by the compiled policy, by chaining over the
// catalogue's implications, and by asking the reasoner about the conjunction of what is seen.
#include "fixture.h"
#include "random_horn.h"

#include <heed/awareness/explain.h>
#include <heed/awareness/observation.h>
#include <heed/dl/reasoner.h>
#include <heed/owl/print.h>

#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using test::RandomHorn;

struct Case {
  explicit Case(std::uint32_t seed) : text(RandomHorn(seed).text()) {
    util::Diagnostics diagnostics;
    const owl::Ontology ontology = owl::read(util::SourceText("random.ofn", text), {}, diagnostics);
    reasoner = std::make_unique<dl::Reasoner>(ontology, budget);
    catalogue = build_catalogue(*reasoner, RandomHorn::options(), budget);
    PerceptionOptions options;
    options.enumerate = false;
    for (const Feature& feature : catalogue.features)
      if (feature.standard)
        options.reported.push_back({Name(feature.atom), "", Reported::Reading::Feature, true});
    perception = resolve_perception(catalogue, options);
  }

  std::string text;
  util::Budget budget{};
  std::unique_ptr<dl::Reasoner> reasoner;
  Catalogue catalogue;
  Perception perception;
};

/// Every observation of up to three reported features, each seen or excluded.
std::vector<Observation> observations(const Case& it) {
  std::vector<std::size_t> features;
  for (std::size_t f = 0; f < it.catalogue.features.size(); ++f)
    if (it.perception.perceivable[f]) features.push_back(f);
  std::vector<Observation> result{{}};
  for (std::size_t first = 0; first < result.size(); ++first) {
    const Observation base = result[first];
    if (base.seen.size() + base.excluded.size() == 3) continue;
    std::size_t from = 0;
    for (const auto* list : {&base.seen, &base.excluded})
      for (const std::size_t f : *list) from = std::max(from, f + 1);
    for (const std::size_t f : features) {
      if (f < from) continue;
      result.push_back(base);
      result.back().seen.push_back(f);
      result.push_back(base);
      result.back().excluded.push_back(f);
    }
  }
  return result;
}

/// What the reasoner says of "all that is seen, and an \p entity": DESIGN's definitions, word by word.
class Oracle {
 public:
  explicit Oracle(const Case& it) : it_(it) {}

  [[nodiscard]] owl::ClassExpression what(std::size_t feature) const {
    const Feature& f = it_.catalogue.features[feature];
    if (f.kind == Feature::Kind::Class) return owl::ClassExpression::named(f.filler);
    return owl::ClassExpression::some({f.role, false}, owl::ClassExpression::named(f.filler));
  }

  [[nodiscard]] owl::ClassExpression thing(const Observation& seen, std::optional<std::size_t> entity) const {
    std::vector<owl::ClassExpression> parts;
    for (const std::size_t f : seen.seen) parts.push_back(what(f));
    if (entity) parts.push_back(owl::ClassExpression::named(it_.catalogue.entities[*entity].iri));
    if (parts.size() == 1) return parts.front();
    return owl::ClassExpression::intersection(std::move(parts));
  }

  [[nodiscard]] bool refuted(const owl::ClassExpression& thing, const Observation& seen) const {
    if (!it_.reasoner->satisfiable(thing)) return true;
    return std::any_of(seen.excluded.begin(), seen.excluded.end(),
                       [&](std::size_t n) { return it_.reasoner->entails_subsumption(thing, what(n)); });
  }

  [[nodiscard]] std::set<std::size_t> candidates(const Observation& seen) const {
    std::set<std::size_t> result;
    for (std::size_t e = 0; e < it_.catalogue.entities.size(); ++e)
      if (is_leaf(e) && it_.catalogue.entities[e].satisfiable && !refuted(thing(seen, e), seen))
        result.insert(e);
    return result;
  }

  [[nodiscard]] std::set<std::size_t> acts(const owl::ClassExpression& thing) const {
    std::set<std::size_t> result;
    const auto role = it_.catalogue.ontology.lookup("act").front();
    for (std::size_t b = 0; b < it_.catalogue.behaviours.size(); ++b)
      if (it_.reasoner->entails_subsumption(
              thing, owl::ClassExpression::some(
                         {role, false}, owl::ClassExpression::named(it_.catalogue.behaviours[b].iri))))
        result.insert(b);
    return result;
  }

 private:
  [[nodiscard]] bool is_leaf(std::size_t entity) const {
    for (std::size_t d = 0; d < it_.catalogue.entities.size(); ++d)
      if (it_.catalogue.entities[d].satisfiable && it_.catalogue.is_below(d, entity) != nullptr &&
          it_.catalogue.is_below(entity, d) == nullptr)
        return false;
    return true;
  }

  const Case& it_;
};

std::set<std::size_t> as_set(const std::vector<std::size_t>& list) {
  return {list.begin(), list.end()};
}

bool within(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  return std::includes(b.begin(), b.end(), a.begin(), a.end());
}

std::map<std::string, bool> symbols(const Case& it, const Observation& observation) {
  std::map<std::string, bool> values;
  for (const std::size_t f : observation.seen) values[it.perception.feature_atom[f]] = true;
  for (const std::size_t f : observation.excluded) values[it.perception.excluded_atom[f]] = true;
  return values;
}

TEST(Candidates, AreWhatTheReasonerLeavesPossible) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Case it(seed);
    const Judge judge(it.catalogue, {true, {}});
    const Oracle oracle(it);
    for (const Observation& seen : observations(it)) {
      if (seen.seen.empty() && seen.excluded.empty()) continue;
      const Judgement found = judge(seen);
      ASSERT_EQ(as_set(found.candidates), oracle.candidates(seen)) << it.text;
      if (seen.seen.empty()) continue;
      ASSERT_EQ(found.conflict, oracle.refuted(oracle.thing(seen, {}), seen)) << it.text;
      if (found.candidates.empty()) continue;
      std::set<std::size_t> common = oracle.acts(oracle.thing(seen, found.candidates.front())), brave;
      for (const std::size_t d : found.candidates) {
        const auto acts = oracle.acts(oracle.thing(seen, d));
        std::erase_if(common, [&](std::size_t b) { return !acts.contains(b); });
        brave.insert(acts.begin(), acts.end());
      }
      ASSERT_EQ(as_set(found.common), common) << it.text;
      ASSERT_EQ(as_set(found.brave), brave) << it.text;
    }
  }
}

TEST(Candidates, RecognisedIsWhatTheReasonerEntailsAndGrowsWithWhatIsSeen) {
  for (std::uint32_t seed = 100; seed < 140; ++seed) {
    const Case it(seed);
    const Judge judge(it.catalogue);
    const Oracle oracle(it);
    for (const Observation& seen : observations(it)) {
      if (seen.seen.empty()) continue;
      const Judgement found = judge(seen);
      Observation less = seen;
      less.seen.pop_back();
      EXPECT_TRUE(within(judge(less).recognised, found.recognised)) << it.text;
      if (found.conflict) continue;
      std::set<std::size_t> entailed;
      for (std::size_t e = 0; e < it.catalogue.entities.size(); ++e)
        if (it.reasoner->entails_subsumption(oracle.thing(seen, {}),
                                             owl::ClassExpression::named(it.catalogue.entities[e].iri)))
          entailed.insert(e);
      ASSERT_EQ(as_set(found.recognised), entailed) << it.text;
    }
  }
}

TEST(Candidates, CautiousIsWithinCommonIsWithinBrave) {
  for (std::uint32_t seed = 200; seed < 260; ++seed) {
    const Case it(seed);
    for (const bool closed : {true, false}) {
      const Judge judge(it.catalogue, {closed, {0}});
      for (const Observation& seen : observations(it)) {
        const Judgement found = judge(seen);
        EXPECT_TRUE(within(found.cautious, found.common)) << it.text;
        EXPECT_TRUE(within(found.common, found.brave)) << it.text;
        EXPECT_TRUE(!found.conflict || found.candidates.empty()) << it.text;
      }
    }
  }
}

using Acting = PolicyOptions::Acting;

/// What the compiled policy has to say of one observation.
struct Expected {
  const Catalogue& catalogue;
  const Judgement& found;
  Acting acting;

  [[nodiscard]] bool recognised(std::size_t e) const {
    const auto in = [&](const std::vector<std::size_t>& list, std::size_t d) {
      return std::find(list.begin(), list.end(), d) != list.end();
    };
    for (std::size_t d = 0; d < catalogue.entities.size(); ++d)
      if ((d == e || catalogue.is_below(d, e) != nullptr) && catalogue.entities[d].satisfiable &&
          (in(found.recognised, d) || in(found.identified, d)))
        return true;
    return false;
  }

  [[nodiscard]] std::set<std::size_t> acts() const {
    if (acting == Acting::Common) return as_set(found.common);
    if (acting == Acting::Brave) return as_set(found.brave);
    auto result = as_set(found.cautious);
    for (const std::size_t e : found.identified)
      for (const Entailed& act : catalogue.entities[e].behaviours) result.insert(act.index);
    return result;
  }
};

void compare(const Case& it, const Recognition& compiled, const Observation& seen, const Expected& expected) {
  auto values = symbols(it, seen);
  for (const Situation& situation : compiled.situations)
    values[situation.name] = test::truth_of(situation.formula, values);
  EXPECT_EQ(values["observation_conflict"], expected.found.conflict);
  EXPECT_EQ(values["unknown_entity"], expected.found.unknown);
  values = test::react(compiled, values);
  // Under a conflict the compiled policy recognises only by evidence that does not contradict itself.
  for (std::size_t e = 0; e < it.catalogue.entities.size() && !expected.found.conflict; ++e)
    ASSERT_EQ(values["recognised_" + it.catalogue.entities[e].atom], expected.recognised(e))
        << it.catalogue.entities[e].atom << '\n'
        << it.text;
  std::set<std::size_t> acts;
  for (std::size_t b = 0; b < it.catalogue.behaviours.size(); ++b)
    if (values["prescribed_" + it.catalogue.behaviours[b].atom]) acts.insert(b);
  if (expected.found.conflict) {
    EXPECT_TRUE(acts.contains(0));
    return;
  }
  ASSERT_EQ(acts, expected.acts()) << it.text;
}

TEST(Candidates, TheCompiledPolicySaysTheSame) {
  for (std::uint32_t seed = 300; seed < 318; ++seed) {
    const Case it(seed);
    for (const bool closed : {true, false})
      for (const Acting acting : {Acting::Cautious, Acting::Common, Acting::Brave}) {
        PolicyOptions options;
        options.kind = PolicyOptions::Kind::Identifying;
        options.acting = acting;
        options.closed = closed;
        options.fallback = {Name(it.catalogue.behaviours[0].atom)};
        const Recognition compiled = compile_policy(it.catalogue, it.perception, options);
        const Judge judge(it.catalogue, {closed, {0}});
        for (const Observation& seen : observations(it)) {
          const Judgement found = judge(seen);
          compare(it, compiled, seen, {it.catalogue, found, acting});
          if (testing::Test::HasFatalFailure()) return;
        }
      }
  }
}

TEST(Candidates, ListedEvidenceSufficesAndIsMinimal) {
  for (std::uint32_t seed = 400; seed < 420; ++seed) {
    const Case it(seed);
    PolicyOptions options;
    options.kind = PolicyOptions::Kind::Identifying;
    options.closed = true;
    const Recognition compiled = compile_policy(it.catalogue, it.perception, options);
    const auto recognised = [&](const RecognisedEntity& entity, const std::vector<std::string>& atoms) {
      std::map<std::string, bool> values;
      for (const std::string& atom : atoms) values[atom] = true;
      for (const Situation& situation : compiled.situations)
        values[situation.name] = test::truth_of(situation.formula, values);
      return test::react(compiled, values)[entity.name];
    };
    for (const RecognisedEntity& entity : compiled.entities)
      for (const Evidence& evidence : entity.evidence) {
        EXPECT_TRUE(recognised(entity, evidence.atoms)) << entity.name << '\n' << it.text;
        for (std::size_t i = 0; i < evidence.atoms.size(); ++i) {
          auto less = evidence.atoms;
          less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
          EXPECT_FALSE(recognised(entity, less)) << entity.name << '\n' << it.text;
        }
      }
  }
}

/// Whether the axioms of \p step, as a document of their own, leave no \p entity with what is seen.
bool alone_suffices(const Case& it, const ExplanationStep& step, const Observation& seen,
                    std::size_t entity) {
  const owl::Ontology& whole = it.catalogue.ontology;
  std::vector<owl::AxiomId> ids;
  for (const owl::Axiom& axiom : whole.axioms())
    if (axiom.as<owl::Declaration>() != nullptr) ids.push_back(axiom.id);
  for (const AxiomText& axiom : step.axioms) ids.push_back(axiom.id);
  util::Diagnostics diagnostics;
  const owl::Ontology part =
      owl::read(util::SourceText("part.ofn", owl::to_functional(ids, whole)), {}, diagnostics);
  util::Budget budget;
  const dl::Reasoner reasoner(part, budget);
  const auto named = [&](owl::Iri iri) { return part.find(whole.text(iri)); };
  const auto what = [&](std::size_t f) -> std::optional<owl::ClassExpression> {
    const Feature& feature = it.catalogue.features[f];
    const auto filler = named(feature.filler);
    if (!filler) return std::nullopt;
    if (feature.kind == Feature::Kind::Class) return owl::ClassExpression::named(*filler);
    const auto role = named(feature.role);
    if (!role) return std::nullopt;
    return owl::ClassExpression::some({*role, false}, owl::ClassExpression::named(*filler));
  };
  std::vector<owl::ClassExpression> parts;
  if (const auto self = named(it.catalogue.entities[entity].iri))
    parts.push_back(owl::ClassExpression::named(*self));
  for (const std::size_t f : seen.seen)
    if (const auto part_of = what(f)) parts.push_back(*part_of);
  const auto thing = owl::ClassExpression::intersection(parts);
  if (!reasoner.satisfiable(thing)) return true;
  return std::any_of(seen.excluded.begin(), seen.excluded.end(), [&](std::size_t n) {
    const auto excluded = what(n);
    return excluded && reasoner.entails_subsumption(thing, *excluded);
  });
}

TEST(Candidates, WhatFellAwayIsExplainedByAxiomsThatSuffice) {
  std::size_t explained = 0;
  for (std::uint32_t seed = 400; seed < 420; ++seed) {
    const Case it(seed);
    PolicyOptions options;
    options.kind = PolicyOptions::Kind::Identifying;
    options.closed = true;
    const Recognition compiled = compile_policy(it.catalogue, it.perception, options);
    const Judge judge(it.catalogue, {true, {}});
    for (const Observation& seen : observations(it)) {
      const Judgement found = judge(seen);
      if (seen.seen.empty() || found.conflict) continue;
      std::set<std::string> atoms;
      for (const auto& [atom, value] : symbols(it, seen)) atoms.insert(atom);
      for (const Situation& situation : compiled.situations) {
        if (situation.kind != Situation::Kind::Possible) continue;
        const auto why = why_impossible(it.catalogue, compiled, *situation.entity, atoms);
        ASSERT_EQ(why.has_value(), !as_set(found.candidates).contains(*situation.entity)) << it.text;
        if (!why) continue;
        ++explained;
        ASSERT_TRUE(alone_suffices(it, *why, seen, *situation.entity))
            << to_text({why->sentence, true, {*why}}) << it.text;
      }
    }
  }
  EXPECT_GT(explained, 100U);
}

}  // namespace
}  // namespace heed::awareness
