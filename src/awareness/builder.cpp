#include "builder.h"

namespace heed::awareness {
namespace {

/// Distinct atoms over all lists, in the order entities, features, behaviours: what comes later gets a
/// number.
void settle_atoms(Catalogue& catalogue) {
  AtomTable atoms;
  for (Entity& entity : catalogue.entities) entity.atom = atoms.claim(entity.atom);
  for (Feature& feature : catalogue.features)
    feature.atom = feature.entity ? catalogue.entities[*feature.entity].atom : atoms.claim(feature.atom);
  for (Behaviour& behaviour : catalogue.behaviours) behaviour.atom = atoms.claim(behaviour.atom);
}

}  // namespace

Catalogue Builder::build() {
  resolve_options();
  add_entities();
  add_ancestors();
  add_parents();
  add_entity_features();
  collect_features();
  order_features();
  relate_features();
  assign_features();
  add_behaviours();
  relate_behaviours();
  assign_behaviours();
  refuse_empty();
  settle_atoms(catalogue_);
  find_exclusive();
  note_individuals();
  warn_unsatisfiable();
  judge_sufficiency();
  add_implications();
  warn_subsumptions();
  warn_conflicts();
  warn_never_recognised();
  warn_indistinguishable();
  warn_excludes_nothing();
  warn_unused();
  return std::move(catalogue_);
}

Catalogue build_catalogue(const dl::Reasoner& reasoner, const CatalogueOptions& options,
                          util::Budget& budget) {
  return Builder(reasoner, options, budget).build();
}

}  // namespace heed::awareness
