#include "builder.h"
#include "lookup.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {
namespace {

const std::vector<owl::EntityKind> concept_kinds{owl::EntityKind::Class, owl::EntityKind::NamedIndividual};
const std::vector<owl::EntityKind> role_kinds{owl::EntityKind::ObjectProperty};

std::optional<owl::Iri> resolve_role(const owl::Ontology& ontology, const std::optional<Name>& name) {
  if (!name) return std::nullopt;
  return find_in_ontology(ontology, *name, role_kinds, "unknown-role");
}

}  // namespace

Builder::Builder(const dl::Reasoner& reasoner, const CatalogueOptions& options, util::Budget& budget)
    : reasoner_(reasoner),
      options_(options),
      budget_(budget),
      told_(reasoner.ontology(), resolve_role(reasoner.ontology(), options.subclass_role)),
      justifier_(reasoner.ontology(), budget) {
  catalogue_.ontology = reasoner.ontology();
  catalogue_.language = options.language;
}

bool Builder::is_individual(owl::Iri iri) const {
  return ontology().is(owl::EntityKind::NamedIndividual, iri) && !ontology().is(owl::EntityKind::Class, iri);
}

/// An unsatisfiable class is below everything, which says nothing about where it was meant to be: told edges
/// decide.
Scope Builder::resolve_scope(const std::vector<Name>& roots) const {
  Scope scope;
  for (const Name& name : roots)
    scope.roots.push_back(find_in_ontology(ontology(), name, concept_kinds, "unknown-root"));
  const auto below_root = [&](owl::Iri iri, bool individual) {
    const auto told = told_.concepts.above(iri);
    const auto types = individual ? reasoner_.types(iri) : std::vector<owl::Iri>{};
    return std::any_of(scope.roots.begin(), scope.roots.end(), [&](owl::Iri root) {
      if (told.contains(root)) return true;
      if (individual) return std::find(types.begin(), types.end(), root) != types.end();
      return reasoner_.satisfiable(iri) && reasoner_.subsumes(root, iri);
    });
  };
  for (const owl::EntityKind kind : concept_kinds)
    for (const owl::Iri iri : ontology().entities(kind))
      if (!scope.contains(iri) && below_root(iri, kind == owl::EntityKind::NamedIndividual)) {
        scope.members.push_back(iri);
        scope.set.insert(iri);
      }
  return scope;
}

/// Instances of a class of signs are single signs in a street, not kinds of signs: they count only where the
/// ontology is said to use individuals for kinds.
Scope Builder::entity_scope() const {
  Scope scope = resolve_scope(options_.entities);
  const bool individuals =
      options_.subclass_role.has_value() ||
      std::any_of(scope.roots.begin(), scope.roots.end(), [&](owl::Iri r) { return is_individual(r); });
  if (individuals) return scope;
  std::erase_if(scope.members, [&](owl::Iri iri) { return is_individual(iri); });
  scope.set = {scope.members.begin(), scope.members.end()};
  return scope;
}

std::vector<owl::Iri> Builder::resolve_roles(const std::vector<Name>& names) const {
  std::vector<owl::Iri> roles;
  roles.reserve(names.size());
  for (const Name& name : names)
    roles.push_back(find_in_ontology(ontology(), name, role_kinds, "unknown-role"));
  return roles;
}

bool Builder::role_counts(owl::Iri role, const std::vector<owl::Iri>& listed) const {
  if (listed.empty()) return true;
  const auto above = told_.roles.above(role);
  return std::any_of(listed.begin(), listed.end(), [&](owl::Iri r) { return above.contains(r); });
}

void Builder::resolve_options() {
  entities_ = entity_scope();
  if (entities_.members.empty())
    throw util::InputError(
        options_.entities.empty() ? util::Location{} : options_.entities.front().location, "no-entities",
        "the catalogue would be empty: no root of the entities is given or none has members",
        "name a class such as Sign as the root of the entities");
  features_ = resolve_scope(options_.features);
  behaviours_ = resolve_scope(options_.behaviours);
  feature_roles_ = resolve_roles(options_.feature_roles);
  action_roles_ = resolve_roles(options_.action_roles);
}

/// A root alone is a catalogue of one where something is said of it; otherwise it is a wrong root.
void Builder::refuse_empty() const {
  const auto said_of = [&](const Entity& entity) {
    return !entity.behaviours.empty() ||
           std::any_of(entity.features.begin(), entity.features.end(),
                       [&](const Entailed& has) { return !catalogue_.features[has.index].entity; });
  };
  const auto& all = catalogue_.entities;
  const std::set<owl::Iri> roots(entities_.roots.begin(), entities_.roots.end());
  if (std::any_of(all.begin(), all.end(),
                  [&](const Entity& e) { return !roots.contains(e.iri) || said_of(e); }))
    return;
  std::vector<std::string> described;
  for (const auto& [holder, bindings] : told_.bindings)
    if (!features_.contains(holder) && !behaviours_.contains(holder))
      described.emplace_back(ontology().local_name(holder));
  throw util::InputError(
      options_.entities.front().location, "no-entities",
      fmt::format("nothing stands below '{}', and nothing is said of it", options_.entities.front().text),
      described.empty()
          ? "name the class above the things that are to be recognised"
          : "name what is above those of which something is said; " + util::suggestion("", described));
}

}  // namespace heed::awareness
