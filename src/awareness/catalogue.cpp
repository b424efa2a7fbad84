#include <heed/awareness/catalogue.h>

#include "lookup.h"

#include <algorithm>
#include <set>

namespace heed::awareness {
namespace {

const Entailed* find(const std::vector<Entailed>& sorted, std::size_t index) {
  const auto place = std::lower_bound(sorted.begin(), sorted.end(), index,
                                      [](const Entailed& e, std::size_t i) { return e.index < i; });
  return place != sorted.end() && place->index == index ? &*place : nullptr;
}

std::vector<std::string> words_of(const Catalogue& catalogue, const std::string& atom, owl::Iri iri,
                                  const std::string& label) {
  return {atom, std::string(catalogue.ontology.local_name(iri)), label,
          std::string(catalogue.ontology.text(iri))};
}

/// "hasMainColour Red" under the role's name; with the plain filler only the feature that has the plain atom
/// is meant.
std::vector<std::string> words_of(const Catalogue& catalogue, const Feature& feature, bool plain) {
  if (feature.kind == Feature::Kind::Class)
    return words_of(catalogue, feature.atom, feature.filler, feature.label);
  const std::string role(catalogue.ontology.local_name(feature.role));
  const std::string filler(catalogue.ontology.local_name(feature.filler));
  std::vector<std::string> words{feature.atom, role + " " + filler, role + "." + filler};
  if (plain) {
    words.push_back(filler);
    words.push_back(feature.label);
    words.emplace_back(catalogue.ontology.text(feature.filler));
  }
  return words;
}

}  // namespace

std::size_t Catalogue::entity(const Name& name) const {
  std::vector<Callable> things;
  for (std::size_t i = 0; i < entities.size(); ++i)
    things.push_back({i, words_of(*this, entities[i].atom, entities[i].iri, entities[i].label)});
  return find_callable(things, name, "entity");
}

std::size_t Catalogue::feature(const Name& name) const {
  std::vector<Callable> things;
  std::set<owl::Iri> seen;
  for (std::size_t i = 0; i < features.size(); ++i)
    things.push_back({i, words_of(*this, features[i], seen.insert(features[i].filler).second)});
  return find_callable(things, name, "feature");
}

std::size_t Catalogue::behaviour(const Name& name) const {
  std::vector<Callable> things;
  for (std::size_t i = 0; i < behaviours.size(); ++i)
    things.push_back({i, words_of(*this, behaviours[i].atom, behaviours[i].iri, behaviours[i].label)});
  return find_callable(things, name, "behaviour");
}

const Entailed* Catalogue::has_feature(std::size_t entity, std::size_t feature) const {
  return find(entities[entity].features, feature);
}

const Entailed* Catalogue::prescribes(std::size_t entity, std::size_t behaviour) const {
  return find(entities[entity].behaviours, behaviour);
}

const Entailed* Catalogue::is_below(std::size_t entity, std::size_t ancestor) const {
  return find(entities[entity].ancestors, ancestor);
}

const Entailed* Catalogue::implies(std::size_t feature, std::size_t general) const {
  return find(features[feature].implies, general);
}

std::vector<Entailed> Catalogue::described(std::size_t entity, const std::vector<bool>& perceivable) const {
  std::vector<Entailed> candidates;
  for (const Entailed& has : entities[entity].features)
    if (perceivable.empty() ? features[has.index].standard : perceivable[has.index])
      candidates.push_back(has);
  std::vector<Entailed> result;
  for (const Entailed& has : candidates) {
    // Of features that imply each other the first stays.
    const bool covered = std::any_of(candidates.begin(), candidates.end(), [&](const Entailed& other) {
      if (other.index == has.index || implies(other.index, has.index) == nullptr) return false;
      return implies(has.index, other.index) == nullptr || other.index < has.index;
    });
    if (!covered) result.push_back(has);
  }
  return result;
}

}  // namespace heed::awareness
