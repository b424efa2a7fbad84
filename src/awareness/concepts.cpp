#include "concepts.h"

namespace heed::awareness {

using owl::ClassExpression;

ClassExpression concept_of(const Feature& feature) {
  switch (feature.kind) {
    case Feature::Kind::Some:
      return ClassExpression::some({feature.role, false}, ClassExpression::named(feature.filler));
    case Feature::Kind::Value:
      return ClassExpression::has_value({feature.role, false}, feature.filler);
    case Feature::Kind::Class:
      break;
  }
  return ClassExpression::named(feature.filler);
}

std::optional<ClassExpression> concept_of(const Entity& entity) {
  if (entity.individual) return std::nullopt;
  return ClassExpression::named(entity.iri);
}

std::vector<Inclusion> inclusions_below(const Catalogue& catalogue, std::size_t entity,
                                        std::size_t ancestor) {
  const auto sub = concept_of(catalogue.entities[entity]);
  const auto super = concept_of(catalogue.entities[ancestor]);
  if (!sub || !super) return {};
  return {{*sub, *super}};
}

std::vector<Inclusion> inclusions_has(const Catalogue& catalogue, std::size_t entity, std::size_t feature) {
  const auto sub = concept_of(catalogue.entities[entity]);
  if (!sub) return {};
  return {{*sub, concept_of(catalogue.features[feature])}};
}

std::vector<Inclusion> inclusions_prescribes(const Catalogue& catalogue, std::size_t entity,
                                             std::size_t behaviour) {
  const auto sub = concept_of(catalogue.entities[entity]);
  const Behaviour& act = catalogue.behaviours[behaviour];
  std::vector<Inclusion> result;
  if (!sub) return result;
  for (const owl::Iri role : catalogue.action_roles)
    result.push_back({*sub, act.individual
                                ? ClassExpression::has_value({role, false}, act.iri)
                                : ClassExpression::some({role, false}, ClassExpression::named(act.iri))});
  return result;
}

std::vector<Inclusion> inclusions_impossible(const Catalogue& catalogue, std::size_t entity) {
  const auto sub = concept_of(catalogue.entities[entity]);
  if (!sub) return {};
  return {{*sub, ClassExpression::nothing()}};
}

std::vector<Inclusion> inclusions_special(const Catalogue& catalogue, std::size_t behaviour,
                                          std::size_t general) {
  const Behaviour& sub = catalogue.behaviours[behaviour];
  const Behaviour& super = catalogue.behaviours[general];
  if (sub.individual || super.individual) return {};
  return {{ClassExpression::named(sub.iri), ClassExpression::named(super.iri)}};
}

}  // namespace heed::awareness
