#include "builder.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {

bool Builder::description_suffices(std::size_t entity) const {
  const auto described = catalogue_.described(entity);
  std::vector<owl::ClassExpression> parts;
  for (const Entailed& feature : described) {
    if (catalogue_.features[feature.index].entity == entity) return true;
    parts.push_back(concept_of(catalogue_.features[feature.index]));
  }
  if (parts.empty() || catalogue_.entities[entity].individual) return false;
  return reasoner_.entails_subsumption(owl::ClassExpression::intersection(std::move(parts)),
                                       owl::ClassExpression::named(catalogue_.entities[entity].iri));
}

/// Read as a definition, the description of \p entity would make every entity that has all of it one of its
/// kind.
bool Builder::refused(std::size_t entity) {
  const auto described = catalogue_.described(entity);
  for (std::size_t other = 0; other < catalogue_.entities.size(); ++other) {
    if (other == entity || !catalogue_.entities[other].satisfiable || catalogue_.is_below(other, entity))
      continue;
    Axioms why;
    const bool swallowed = std::all_of(described.begin(), described.end(), [&](const Entailed& feature) {
      const Entailed* has = catalogue_.has_feature(other, feature.index);
      if (has != nullptr) why = join(why, join(has->axioms, feature.axioms));
      return has != nullptr;
    });
    if (!swallowed) continue;
    warn("sufficient-refused",
         fmt::format("The description of '{}' cannot be read as a definition: '{}' has all of it, and would "
                     "become a '{}', "
                     "which nobody wrote.",
                     label(entity), label(other), label(entity)),
         why, {entity, other});
    return true;
  }
  return false;
}

void Builder::judge_sufficiency() {
  std::set<std::size_t> declared;
  for (const Name& name : options_.sufficient_entities) declared.insert(catalogue_.entity(name));
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    budget_.check();
    Entity& entity = catalogue_.entities[e];
    if (!entity.satisfiable) continue;
    if (description_suffices(e)) {
      entity.sufficiency = Sufficiency::Defined;
      continue;
    }
    const bool asked = options_.sufficient || entity.individual || declared.contains(e);
    if (asked && !catalogue_.described(e).empty() && !refused(e)) entity.sufficiency = Sufficiency::Declared;
  }
  judge_groups();
}

void Builder::judge_groups() {
  auto& entities = catalogue_.entities;
  for (std::size_t e = 0; e < entities.size(); ++e)
    if (entities[e].sufficiency == Sufficiency::Defined || entities[e].sufficiency == Sufficiency::Declared)
      for (const Entailed& up : entities[e].ancestors)
        if (entities[up.index].sufficiency == Sufficiency::Never && entities[up.index].satisfiable)
          entities[up.index].sufficiency = Sufficiency::MembersOnly;
}

}  // namespace heed::awareness
