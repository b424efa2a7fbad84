#include "builder.h"

#include <algorithm>

namespace heed::awareness {

/// A root such as "Behaviour" is a heading, not something to do, unless nothing stands below it.
void Builder::add_behaviours() {
  for (const owl::Iri iri : behaviours_.members) {
    const bool root =
        std::find(behaviours_.roots.begin(), behaviours_.roots.end(), iri) != behaviours_.roots.end();
    const bool heading =
        root && std::any_of(behaviours_.members.begin(), behaviours_.members.end(), [&](owl::Iri other) {
          return other != iri && above_filler(other).contains(iri);
        });
    if (heading) continue;
    Behaviour behaviour;
    behaviour.iri = iri;
    behaviour.individual = is_individual(iri);
    behaviour.label = label_of(iri);
    behaviour.atom = atom_of(ontology().local_name(iri));
    behaviour_index_[iri] = catalogue_.behaviours.size();
    catalogue_.behaviours.push_back(std::move(behaviour));
  }
}

void Builder::relate_behaviours() {
  auto& behaviours = catalogue_.behaviours;
  for (std::size_t b = 0; b < behaviours.size(); ++b)
    for (const auto& [super, why] : above_filler(behaviours[b].iri))
      if (const auto found = behaviour_index_.find(super);
          found != behaviour_index_.end() && found->second != b)
        behaviours[b].general.push_back({found->second, why});
  const auto by_index = [](const Entailed& a, const Entailed& b) { return a.index < b.index; };
  for (Behaviour& behaviour : behaviours)
    std::sort(behaviour.general.begin(), behaviour.general.end(), by_index);
  const auto above = [&](std::size_t b, std::size_t c) {
    return std::any_of(behaviours[b].general.begin(), behaviours[b].general.end(),
                       [&](const Entailed& up) { return up.index == c; });
  };
  for (std::size_t b = 0; b < behaviours.size(); ++b)
    for (const Entailed& up : behaviours[b].general) {
      const bool direct =
          std::none_of(behaviours[b].general.begin(), behaviours[b].general.end(), [&](const Entailed& x) {
            return x.index != up.index && above(x.index, up.index) && !above(up.index, x.index);
          });
      if (direct) behaviours[b].parents.push_back(up);
    }
}

void Builder::assign_behaviours() {
  catalogue_.action_roles = action_roles_;
  if (action_roles_.empty()) {
    std::set<owl::Iri> roles;
    for (const auto& [holder, bindings] : told_.bindings)
      for (const Binding& binding : bindings)
        if (behaviours_.contains(binding.filler)) roles.insert(binding.role);
    catalogue_.action_roles.assign(roles.begin(), roles.end());
  }
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    std::map<std::size_t, Axioms> found;
    const auto keep_shorter = [&](std::size_t b, const Axioms& why) {
      const auto [place, fresh] = found.emplace(b, why);
      if (!fresh && why.size() < place->second.size()) place->second = why;
    };
    for (const Bound& bound : bindings_of(e)) {
      const auto start = behaviour_index_.find(bound.binding.filler);
      if (start == behaviour_index_.end() || !role_counts(bound.binding.role, action_roles_)) continue;
      keep_shorter(start->second, bound.axioms);
      for (const Entailed& more : catalogue_.behaviours[start->second].general)
        keep_shorter(more.index, join(bound.axioms, more.axioms));
    }
    for (const auto& [b, why] : found) catalogue_.entities[e].behaviours.push_back({b, why});
  }
  if (!told_.derived.empty()) search_behaviours();
}

/// Roles of actions by which more may be bound than single axioms tell.
std::vector<owl::Iri> Builder::derived_action_roles() const {
  std::set<owl::Iri> roles(catalogue_.action_roles.begin(), catalogue_.action_roles.end());
  std::erase_if(roles, [&](owl::Iri role) { return !told_.derived.contains(role); });
  return {roles.begin(), roles.end()};
}

/// "Prescribes what its action implies" is a role chain: only the reasoner follows it.
void Builder::search_behaviours() {
  const auto roles = derived_action_roles();
  for (Entity& entity : catalogue_.entities) {
    if (entity.individual || !entity.satisfiable) continue;
    const auto self = owl::ClassExpression::named(entity.iri);
    for (std::size_t b = 0; b < catalogue_.behaviours.size(); ++b)
      for (const owl::Iri role : roles) {
        budget_.check();
        const Behaviour& behaviour = catalogue_.behaviours[b];
        const bool known = std::any_of(entity.behaviours.begin(), entity.behaviours.end(),
                                       [&](const Entailed& has) { return has.index == b; });
        if (known) continue;
        const auto act =
            behaviour.individual
                ? owl::ClassExpression::has_value({role, false}, behaviour.iri)
                : owl::ClassExpression::some({role, false}, owl::ClassExpression::named(behaviour.iri));
        if (reasoner_.entails_subsumption(self, act))
          entity.behaviours.push_back({b, justifier_.subsumption(self, act).value_or(Axioms{})});
      }
    std::sort(entity.behaviours.begin(), entity.behaviours.end(),
              [](const Entailed& x, const Entailed& y) { return x.index < y.index; });
  }
}

}  // namespace heed::awareness
