// The compiled rules against the reasoner itself: what a policy recognises from a set of features must follow
// from having them.
#include "fixture.h"
#include "ontologies.h"

#include <gtest/gtest.h>

namespace heed::awareness {
namespace {

using Indices = std::set<std::size_t>;

class Soundness : public testing::Test {
 protected:
  Soundness()
      : catalogue_(test::traffic_signs()),
        perception_(resolve_perception(catalogue_, {})),
        recognition_(compile_policy(catalogue_, perception_, {})),
        reasoner_(catalogue_.ontology, budget_) {}

  [[nodiscard]] owl::ClassExpression concept_of(const Indices& features) const {
    std::vector<owl::ClassExpression> parts;
    for (const std::size_t f : features) {
      const Feature& feature = catalogue_.features[f];
      const auto filler = owl::ClassExpression::named(feature.filler);
      const bool plain = feature.kind == Feature::Kind::Class;
      parts.push_back(plain ? filler : owl::ClassExpression::some({feature.role, false}, filler));
    }
    return owl::ClassExpression::intersection(parts);
  }

  /// Entities that OWL recognises: T entails that whatever has the features is one.
  [[nodiscard]] Indices by_reasoner(const Indices& features) const {
    const auto supers = reasoner_.superclasses(concept_of(features));
    Indices result;
    for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
      if (!supers || std::find(supers->begin(), supers->end(), catalogue_.entities[e].iri) != supers->end())
        result.insert(e);
    return result;
  }

  [[nodiscard]] Indices by_policy(const Indices& features) const {
    std::map<std::string, bool> seen;
    for (const std::size_t f : features) seen[perception_.feature_atom[f]] = true;
    const auto values = test::react(recognition_, seen);
    Indices result;
    for (const RecognisedEntity& entity : recognition_.entities)
      if (values.at(entity.name)) result.insert(entity.entity);
    return result;
  }

  [[nodiscard]] Indices described(std::size_t entity) const {
    Indices result;
    for (const Entailed& has : catalogue_.described(entity)) result.insert(has.index);
    return result;
  }

  util::Budget budget_;
  Catalogue catalogue_;
  Perception perception_;
  Recognition recognition_;
  dl::Reasoner reasoner_;
};

TEST_F(Soundness, AFullDescriptionIsRecognisedAsTheReasonerDoes) {
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    if (!catalogue_.entities[e].is_leaf()) continue;
    const Indices features = described(e);
    EXPECT_TRUE(reasoner_.satisfiable(concept_of(features))) << catalogue_.entities[e].label;
    EXPECT_EQ(by_policy(features), by_reasoner(features)) << catalogue_.entities[e].label;
    EXPECT_TRUE(by_policy(features).contains(e));
  }
}

TEST_F(Soundness, WithPartsMissingNothingIsRecognisedThatDoesNotFollow) {
  std::size_t fewer = 0;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    const Indices all = described(e);
    for (const std::size_t dropped : all) {
      Indices features = all;
      features.erase(dropped);
      const Indices policy = by_policy(features);
      const Indices reasoner = by_reasoner(features);
      EXPECT_TRUE(std::includes(reasoner.begin(), reasoner.end(), policy.begin(), policy.end()))
          << catalogue_.entities[e].label << " without " << catalogue_.features[dropped].atom;
      fewer += policy.contains(e) ? 0 : 1;
    }
  }
  EXPECT_GT(fewer, 200U);
}

/// What single axioms tell of behaviours must be all that the reasoner finds.
TEST_F(Soundness, PrescriptionsAreThoseOfTheReasoner) {
  const owl::ObjectProperty action{
      *catalogue_.ontology.find("http://example.org/heed/traffic-signs#hasAction"), false};
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
    for (std::size_t b = 0; b < catalogue_.behaviours.size(); ++b) {
      const auto act =
          owl::ClassExpression::some(action, owl::ClassExpression::named(catalogue_.behaviours[b].iri));
      EXPECT_EQ(reasoner_.entails_subsumption(owl::ClassExpression::named(catalogue_.entities[e].iri), act),
                catalogue_.prescribes(e, b) != nullptr)
          << catalogue_.entities[e].atom << " " << catalogue_.behaviours[b].atom;
    }
}

}  // namespace
}  // namespace heed::awareness
