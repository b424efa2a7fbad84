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

namespace {

ClassExpression concept_of(owl::Iri iri, bool individual) {
  return individual ? ClassExpression::one_of({iri}) : ClassExpression::named(iri);
}

}  // namespace

ClassExpression concept_of(const Entity& entity) {
  return concept_of(entity.iri, entity.individual);
}

std::vector<Inclusion> inclusions_below(const Catalogue& catalogue, std::size_t entity,
                                        std::size_t ancestor) {
  return {{concept_of(catalogue.entities[entity]), concept_of(catalogue.entities[ancestor])}};
}

std::vector<Inclusion> inclusions_has(const Catalogue& catalogue, std::size_t entity, std::size_t feature) {
  return {{concept_of(catalogue.entities[entity]), concept_of(catalogue.features[feature])}};
}

std::vector<Inclusion> inclusions_prescribes(const Catalogue& catalogue, std::size_t entity,
                                             std::size_t behaviour) {
  const ClassExpression sub = concept_of(catalogue.entities[entity]);
  const Behaviour& act = catalogue.behaviours[behaviour];
  std::vector<Inclusion> result;
  for (const owl::Iri role : catalogue.action_roles)
    result.push_back({sub, act.individual
                               ? ClassExpression::has_value({role, false}, act.iri)
                               : ClassExpression::some({role, false}, ClassExpression::named(act.iri))});
  return result;
}

std::vector<Inclusion> inclusions_impossible(const Catalogue& catalogue, std::size_t entity) {
  return {{concept_of(catalogue.entities[entity]), ClassExpression::nothing()}};
}

std::vector<Inclusion> inclusions_special(const Catalogue& catalogue, std::size_t behaviour,
                                          std::size_t general) {
  const Behaviour& sub = catalogue.behaviours[behaviour];
  const Behaviour& super = catalogue.behaviours[general];
  return {{concept_of(sub.iri, sub.individual), concept_of(super.iri, super.individual)}};
}

}  // namespace heed::awareness
