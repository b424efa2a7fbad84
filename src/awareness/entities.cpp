#include "builder.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {

/// Why \p sub is below \p super, where told edges do not lead there.
Axioms Builder::because(owl::Iri sub, owl::Iri super) {
  const auto expression = owl::ClassExpression::named(super);
  const auto found = is_individual(sub)
                         ? justifier_.type(sub, expression)
                         : justifier_.subsumption(owl::ClassExpression::named(sub), expression);
  return found.value_or(Axioms{});
}

Above Builder::above(owl::Iri concept_iri, bool individual) {
  Above result = told_.concepts.above(concept_iri);
  if (!individual && !reasoner_.satisfiable(concept_iri)) return result;
  const auto classes = individual ? reasoner_.types(concept_iri) : reasoner_.superclasses(concept_iri);
  for (const owl::Iri super : classes)
    if (!result.contains(super)) result[super] = because(concept_iri, super);
  return result;
}

void Builder::add_entities() {
  for (const owl::Iri iri : entities_.members) {
    budget_.check();
    Entity entity;
    entity.iri = iri;
    entity.individual = is_individual(iri);
    entity.label = label_of(iri);
    entity.atom = atom_of(ontology().local_name(iri));
    entity.satisfiable = entity.individual || reasoner_.satisfiable(iri);
    if (const auto place = told_.declared.find(iri); place != told_.declared.end())
      entity.location = place->second;
    entity_index_[iri] = catalogue_.entities.size();
    catalogue_.entities.push_back(std::move(entity));
    above_.push_back(above(iri, is_individual(iri)));
  }
}

void Builder::add_ancestors() {
  for (std::size_t d = 0; d < catalogue_.entities.size(); ++d)
    for (const auto& [super, why] : above_[d])
      if (const auto e = entity_index_.find(super); e != entity_index_.end() && e->second != d)
        catalogue_.entities[d].ancestors.push_back({e->second, why});
  for (Entity& entity : catalogue_.entities)
    std::sort(entity.ancestors.begin(), entity.ancestors.end(),
              [](const Entailed& a, const Entailed& b) { return a.index < b.index; });
}

/// The transitive reduction, in which equivalent entities are each other's parents and nobody's child for
/// that.
void Builder::add_parents() {
  auto& entities = catalogue_.entities;
  const auto strictly_below = [&](std::size_t d, std::size_t e) {
    return catalogue_.is_below(d, e) != nullptr && catalogue_.is_below(e, d) == nullptr;
  };
  for (std::size_t d = 0; d < entities.size(); ++d)
    for (const Entailed& up : entities[d].ancestors) {
      const bool equivalent = !strictly_below(d, up.index);
      const bool direct =
          std::none_of(entities[d].ancestors.begin(), entities[d].ancestors.end(), [&](const Entailed& x) {
            return x.index != up.index && strictly_below(d, x.index) && strictly_below(x.index, up.index);
          });
      if (!equivalent && !direct) continue;
      entities[d].parents.push_back(up);
      if (!equivalent) entities[up.index].children.push_back(d);
    }
}

void Builder::add_entity_features() {
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    const Entity& entity = catalogue_.entities[e];
    const bool root =
        std::find(entities_.roots.begin(), entities_.roots.end(), entity.iri) != entities_.roots.end();
    if (!root && entity.is_leaf()) continue;
    Feature feature;
    feature.kind = Feature::Kind::Class;
    feature.atom = entity.atom;
    feature.label = entity.label;
    feature.filler = entity.iri;
    feature.entity = e;
    feature.standard = root;
    feature_index_[{entity.iri, entity.iri}] = catalogue_.features.size();
    catalogue_.features.push_back(std::move(feature));
  }
}

void Builder::note_individuals() {
  std::vector<std::string> names;
  for (const Entity& entity : catalogue_.entities)
    if (entity.individual) names.push_back("'" + entity.label + "'");
  if (names.empty()) return;
  util::Diagnostic note;
  note.severity = util::Severity::Note;
  note.code = "role-assertions-normalised";
  note.message = fmt::format(
      "{} individual(s) are read as kinds of things ({}): what a role asserts of one holds of every such "
      "thing and is "
      "inherited along '{}', which OWL itself does not do",
      names.size(), fmt::join(names, ", "),
      options_.subclass_role ? options_.subclass_role->text : "rdf:type");
  note.hint = "in a new ontology use classes and restrictions";
  catalogue_.notes.push_back(std::move(note));
}

}  // namespace heed::awareness
