#include "builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace heed::awareness {

/// What axioms state of an entity or of anything above it.
std::vector<Builder::Bound> Builder::bindings_of(std::size_t entity) const {
  std::vector<Bound> result;
  for (const auto& [holder, why] : above_[entity])
    if (const auto found = told_.bindings.find(holder); found != told_.bindings.end())
      for (const Binding& binding : found->second)
        result.push_back({entity, binding, join(why, {binding.axiom})});
  return result;
}

/// "It has some colour" says nothing where every value of the role is a colour.
bool Builder::informative(owl::Iri role, owl::Iri filler) const {
  for (const auto& [super, why] : told_.roles.above(role))
    if (const auto ranges = told_.ranges.find(super); ranges != told_.ranges.end())
      for (const owl::Iri range : ranges->second)
        if (told_.concepts.path(range, filler)) return false;
  return true;
}

void Builder::add_feature(owl::Iri role, owl::Iri filler, bool value) {
  if (feature_index_.contains({role, filler})) return;
  Feature feature;
  feature.kind = value ? Feature::Kind::Value : Feature::Kind::Some;
  feature.filler = filler;
  feature.role = role;
  feature.label = label_of(filler);
  feature.role_atom = role_atom_of(ontology().local_name(role));
  feature.functional = told_.functional_because(role).value_or(Axioms{});
  feature_index_[{role, filler}] = catalogue_.features.size();
  catalogue_.features.push_back(std::move(feature));
}

/// Features are what some entity is told to have, by the role told and by the listed roles above it, with the
/// filler told and the more general ones that still say something.
void Builder::collect_features() {
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
    for (const Bound& bound : bindings_of(e)) {
      budget_.check();
      if (!features_.roots.empty() && !features_.contains(bound.binding.filler)) continue;
      if (features_.roots.empty() && feature_roles_.empty()) continue;
      if (!role_counts(bound.binding.role, feature_roles_) || entities_.contains(bound.binding.filler))
        continue;
      if (behaviours_.contains(bound.binding.filler)) continue;
      const Above& fillers = above_filler(bound.binding.filler);
      for (const auto& [role, why] : told_.roles.above(bound.binding.role)) {
        const bool listed =
            std::find(feature_roles_.begin(), feature_roles_.end(), role) != feature_roles_.end();
        if (role != bound.binding.role && !listed) continue;
        for (const auto& [filler, reason] : fillers)
          if ((features_.roots.empty() || features_.contains(filler)) && informative(role, filler))
            add_feature(role, filler, is_individual(filler));
      }
    }
}

/// Entities first, then by the order in which the roles are listed, then as the ontology names them: the
/// first feature with a filler gets the plain atom.
void Builder::order_features() {
  const auto rank = [&](const Feature& f) {
    if (f.kind == Feature::Kind::Class) return std::size_t{0};
    const auto place = std::find(feature_roles_.begin(), feature_roles_.end(), f.role);
    return static_cast<std::size_t>(place - feature_roles_.begin()) + 1;
  };
  auto& features = catalogue_.features;
  std::stable_sort(features.begin(), features.end(), [&](const Feature& a, const Feature& b) {
    return std::make_tuple(rank(a), a.role, a.filler) < std::make_tuple(rank(b), b.role, b.filler);
  });
  std::set<owl::Iri> plain;
  for (std::size_t i = 0; i < features.size(); ++i) {
    Feature& f = features[i];
    const bool is_class = f.kind == Feature::Kind::Class;
    feature_index_[{is_class ? f.filler : f.role, f.filler}] = i;
    if (is_class) continue;
    f.atom = atom_of(ontology().local_name(f.filler));
    if (!plain.insert(f.filler).second) {
      f.atom = f.role_atom + "_" + f.atom;
      f.label = label_of(f.role) + " " + f.label;
    }
  }
}

std::optional<Axioms> Builder::feature_implies(const Feature& special, const Feature& general) {
  if (special.kind == Feature::Kind::Class && general.kind == Feature::Kind::Class) {
    const auto& all = above_[*special.entity];
    const auto found = all.find(general.filler);
    if (found == all.end()) return std::nullopt;
    return found->second;
  }
  if (special.kind == Feature::Kind::Class || general.kind == Feature::Kind::Class) return std::nullopt;
  const auto by_role = told_.roles.path(special.role, general.role);
  if (!by_role) return std::nullopt;
  const Above& fillers = above_filler(special.filler);
  const auto by_filler = fillers.find(general.filler);
  if (by_filler == fillers.end()) return std::nullopt;
  return join(*by_role, by_filler->second);
}

void Builder::relate_features() {
  auto& features = catalogue_.features;
  for (std::size_t i = 0; i < features.size(); ++i) {
    budget_.check();
    for (std::size_t j = 0; j < features.size(); ++j)
      if (i != j)
        if (const auto why = feature_implies(features[i], features[j]))
          features[i].implies.push_back({j, *why});
    if (features[i].kind == Feature::Kind::Class) continue;
    const auto supers = reasoner_.superclasses(concept_of(features[i]));
    if (!supers) continue;
    for (std::size_t j = 0; j < features.size(); ++j)
      if (features[j].kind == Feature::Kind::Class && !is_individual(features[j].filler) &&
          std::find(supers->begin(), supers->end(), features[j].filler) != supers->end())
        features[i].implies.push_back(
            {j,
             justifier_.subsumption(concept_of(features[i]), owl::ClassExpression::named(features[j].filler))
                 .value_or(Axioms{})});
    std::sort(features[i].implies.begin(), features[i].implies.end(),
              [](const Entailed& a, const Entailed& b) { return a.index < b.index; });
  }
}

void Builder::assign_features() {
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    std::map<std::size_t, Axioms> found;
    for (std::size_t f = 0; f < catalogue_.features.size(); ++f)
      if (catalogue_.features[f].entity)
        if (const auto up = above_[e].find(catalogue_.features[f].filler); up != above_[e].end())
          found[f] = up->second;
    for (const Bound& bound : bindings_of(e)) {
      const auto start = feature_index_.find({bound.binding.role, bound.binding.filler});
      if (start == feature_index_.end()) continue;
      const auto keep_shorter = [&](std::size_t f, const Axioms& why) {
        const auto [place, fresh] = found.emplace(f, why);
        if (!fresh && why.size() < place->second.size()) place->second = why;
      };
      keep_shorter(start->second, bound.axioms);
      for (const Entailed& more : catalogue_.features[start->second].implies)
        keep_shorter(more.index, join(bound.axioms, more.axioms));
    }
    for (const auto& [f, why] : found) catalogue_.entities[e].features.push_back({f, why});
  }
  if (!told_.derived.empty()) search_features();
}

/// Chains and inclusions with a complex left side can bind features that no single axiom tells. General
/// features come first: what lacks one lacks all that imply it.
void Builder::search_features() {
  const auto& features = catalogue_.features;
  std::vector<std::size_t> order;
  for (std::size_t f = 0; f < features.size(); ++f)
    if (features[f].kind != Feature::Kind::Class && told_.derived.contains(features[f].role))
      order.push_back(f);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return features[a].implies.size() < features[b].implies.size();
  });
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    Entity& entity = catalogue_.entities[e];
    if (entity.individual || !entity.satisfiable) continue;
    const auto self = owl::ClassExpression::named(entity.iri);
    for (const std::size_t f : order) {
      budget_.check();
      const auto& general = features[f].implies;
      const bool possible = std::all_of(general.begin(), general.end(), [&](const Entailed& g) {
        return catalogue_.has_feature(e, g.index) != nullptr;
      });
      if (!possible || catalogue_.has_feature(e, f) != nullptr) continue;
      if (!reasoner_.entails_subsumption(self, concept_of(features[f]))) continue;
      entity.features.push_back(
          {f, justifier_.subsumption(self, concept_of(features[f])).value_or(Axioms{})});
      std::sort(entity.features.begin(), entity.features.end(),
                [](const Entailed& a, const Entailed& b) { return a.index < b.index; });
    }
  }
}

const Above& Builder::above_filler(owl::Iri iri) {
  Above& memo = filler_above_[iri];
  if (memo.empty()) memo = above(iri, is_individual(iri));
  return memo;
}

std::optional<Axioms> Builder::concepts_apart(owl::Iri a, owl::Iri b) {
  const Above& above_a = above_filler(a);
  const Above& above_b = above_filler(b);
  for (const auto& [x, why_x] : above_a)
    for (const auto& [y, why_y] : above_b)
      if (const auto apart = told_.disjoint.find({x, y}); apart != told_.disjoint.end())
        return join(join(why_x, why_y), {apart->second});
  return std::nullopt;
}

/// Two values of one functional role, or of two roles below one, exclude each other when they are declared
/// disjoint or different.
void Builder::find_exclusive() {
  const auto& features = catalogue_.features;
  std::map<std::pair<owl::Iri, owl::Iri>, std::optional<Axioms>> memo;
  const auto functional = [&](owl::Iri a, owl::Iri b) -> const std::optional<Axioms>& {
    const auto [place, fresh] = memo.emplace(std::pair(a, b), std::nullopt);
    if (fresh) place->second = told_.functional_because(a, b);
    return place->second;
  };
  for (std::size_t i = 0; i < features.size(); ++i)
    for (std::size_t j = i + 1; j < features.size(); ++j) {
      const Feature& a = features[i];
      const Feature& b = features[j];
      if (a.kind == Feature::Kind::Class || b.kind == Feature::Kind::Class) continue;
      const std::optional<Axioms>& one = functional(a.role, b.role);
      if (!one) continue;
      budget_.check();
      if (const auto why = concepts_apart(a.filler, b.filler))
        catalogue_.exclusive[{i, j}] = join(*one, *why);
    }
}

}  // namespace heed::awareness
