// Conditions under which a thing is an entity, has a feature, prescribes a behaviour or cannot exist.
//
// Axioms whose parts are entities and features of the catalogue are taken over one by one; they explain
// themselves. Of a definition that speaks of other things as well the reasoner finds the minimal parts of the
// description that suffice. What neither finds is missed, never invented: a condition too few leaves
// candidates that could have fallen away.
#include "builder.h"

#include <algorithm>

namespace heed::awareness {
namespace {

using Kind = owl::ClassExpression::Kind;

/// Of an entity's description at most this many minimal parts are looked for; more make no difference that
/// anyone would see.
constexpr std::size_t parts_cap = 16;

std::vector<owl::ClassExpression> alternatives(const owl::ClassExpression& expression) {
  if (expression.kind() == Kind::Union) return expression.operands();
  return {expression};
}

void keep_sorted(std::vector<std::size_t>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

/// The feature, entity or behaviour that \p part is, as a head without conditions.
std::optional<Implication> Builder::named_head(const owl::ClassExpression& part) const {
  using Head = Implication::Head;
  if (part.is_nothing()) return Implication{};
  if (part.is_named()) {
    const auto found = entity_index_.find(part.iri());
    if (found == entity_index_.end()) return std::nullopt;
    return Implication{{}, {}, Head::Entity, found->second, {}};
  }
  const bool counted = part.kind() == Kind::Min && part.cardinality() == 1;
  const bool some = part.kind() == Kind::Some || counted;
  if ((!some && part.kind() != Kind::HasValue) || part.property().inverse) return std::nullopt;
  if (some && !part.filler().is_named()) return std::nullopt;
  const owl::Iri role = part.property().iri;
  const owl::Iri filler = some ? part.filler().iri() : part.individuals()[0];
  if (const auto f = feature_index_.find({role, filler}); f != feature_index_.end())
    return Implication{{}, {}, Head::Feature, f->second, {}};
  const auto b = behaviour_index_.find(filler);
  if (b == behaviour_index_.end() || !role_counts(role, action_roles_)) return std::nullopt;
  return Implication{{}, {}, Head::Behaviour, b->second, {}};
}

/// The conditions that \p sub consists of; nothing when it speaks of more than the catalogue knows.
std::optional<Implication> Builder::conditions(const owl::ClassExpression& sub) const {
  Implication body;
  for (const auto& part : conjuncts(sub)) {
    if (part.is_thing()) continue;
    const auto found = named_head(part);
    if (!found || found->head == Implication::Head::Behaviour || found->head == Implication::Head::Nothing)
      return std::nullopt;
    (found->head == Implication::Head::Entity ? body.entities : body.features).push_back(found->index);
  }
  keep_sorted(body.entities);
  keep_sorted(body.features);
  if (body.entities.empty() && body.features.empty()) return std::nullopt;
  return body;
}

void Builder::imply(const owl::ClassExpression& sub, const owl::ClassExpression& super, owl::AxiomId axiom) {
  if (sub.is_named() && !super.is_nothing()) return;  // what it is below and has is listed with the entity
  for (const auto& alternative : alternatives(sub)) {
    const auto body = conditions(alternative);
    if (!body) continue;
    for (const auto& part : conjuncts(super))
      if (auto rule = named_head(part)) {
        rule->entities = body->entities;
        rule->features = body->features;
        rule->axioms = {axiom};
        catalogue_.implications.push_back(std::move(*rule));
      }
  }
}

void Builder::imply_disjoint(const owl::ClassExpression& a, const owl::ClassExpression& b,
                             owl::AxiomId axiom) {
  auto rule = conditions(owl::ClassExpression::intersection({a, b}));
  if (!rule || rule->entities.size() + rule->features.size() < 2) return;
  rule->axioms = {axiom};
  catalogue_.implications.push_back(std::move(*rule));
}

void Builder::imply_told(const owl::Axiom& axiom) {
  const auto apart = [&](const std::vector<owl::ClassExpression>& classes) {
    for (std::size_t i = 0; i < classes.size(); ++i)
      for (std::size_t j = i + 1; j < classes.size(); ++j) imply_disjoint(classes[i], classes[j], axiom.id);
  };
  if (const auto* inclusion = axiom.as<owl::SubClassOf>()) imply(inclusion->sub, inclusion->super, axiom.id);
  if (const auto* same = axiom.as<owl::EquivalentClasses>())
    for (const auto& sub : same->classes)
      for (const auto& super : same->classes)
        if (!sub.identical(super)) imply(sub, super, axiom.id);
  if (const auto* disjoint = axiom.as<owl::DisjointClasses>()) apart(disjoint->classes);
  if (const auto* whole = axiom.as<owl::DisjointUnion>()) apart(whole->parts);
}

/// What a single feature brings with it beyond other features: entities below the groups, or that it cannot
/// be.
void Builder::imply_single_features() {
  for (std::size_t f = 0; f < catalogue_.features.size(); ++f) {
    const Feature& feature = catalogue_.features[f];
    if (feature.kind == Feature::Kind::Class) continue;
    budget_.check();
    const auto self = concept_of(feature);
    const auto supers = reasoner_.superclasses(self);
    if (!supers) {
      catalogue_.implications.push_back({{}, {f}, Implication::Head::Nothing, 0, {}});
      catalogue_.implications.back().axioms = justifier_.unsatisfiable(self).value_or(Axioms{});
      continue;
    }
    for (const owl::Iri super : *supers) {
      const auto e = entity_index_.find(super);
      if (e == entity_index_.end()) continue;
      const auto why = justifier_.subsumption(self, owl::ClassExpression::named(super));
      catalogue_.implications.push_back(
          {{}, {f}, Implication::Head::Entity, e->second, why.value_or(Axioms{})});
    }
  }
}

bool Builder::suffices(const std::vector<std::size_t>& features, std::size_t entity) const {
  std::vector<owl::ClassExpression> parts;
  parts.reserve(features.size());
  for (const std::size_t f : features) parts.push_back(concept_of(catalogue_.features[f]));
  if (parts.empty()) return false;
  const auto whole = parts.size() == 1 ? parts.front() : owl::ClassExpression::intersection(parts);
  return reasoner_.entails_subsumption(whole, owl::ClassExpression::named(catalogue_.entities[entity].iri));
}

/// Minimal parts of the description that suffice: the branches of a hitting-set tree, each of which leaves
/// out one feature of a part found before. \cite reiter.87.aij
void Builder::imply_minimal_parts(std::size_t entity) {
  std::vector<std::size_t> all;
  for (const Entailed& has : catalogue_.described(entity)) all.push_back(has.index);
  std::vector<std::vector<std::size_t>> open{all};
  std::set<std::vector<std::size_t>> tried, found;
  while (!open.empty() && found.size() < parts_cap) {
    auto part = open.back();
    open.pop_back();
    budget_.check();
    if (!tried.insert(part).second || !suffices(part, entity)) continue;
    const auto whole = part;
    for (const std::size_t f : whole) {
      auto smaller = part;
      std::erase(smaller, f);
      if (suffices(smaller, entity)) part = std::move(smaller);
    }
    found.insert(part);
    for (const std::size_t f : part) {
      open.push_back(whole);
      std::erase(open.back(), f);
    }
  }
  for (const auto& part : found) {
    std::vector<owl::ClassExpression> parts;
    for (const std::size_t f : part) parts.push_back(concept_of(catalogue_.features[f]));
    const auto whole = parts.size() == 1 ? parts.front() : owl::ClassExpression::intersection(parts);
    const auto why =
        justifier_.subsumption(whole, owl::ClassExpression::named(catalogue_.entities[entity].iri));
    catalogue_.implications.push_back({{}, part, Implication::Head::Entity, entity, why.value_or(Axioms{})});
  }
}

/// The entities that the implications so far do not derive from their descriptions, though they are defined.
std::vector<std::size_t> Builder::underived() const {
  const HornBase base(catalogue_);
  std::vector<std::size_t> result;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    const Sufficiency sufficiency = catalogue_.entities[e].sufficiency;
    if (sufficiency != Sufficiency::Defined && sufficiency != Sufficiency::Declared) continue;
    std::vector<HornBase::Prop> facts;
    for (const Entailed& has : catalogue_.described(e)) facts.push_back(base.feature(has.index));
    if (base.closure(facts)[base.entity(e)] == 0) result.push_back(e);
  }
  return result;
}

/// What is declared sufficient is taken as it is described; of a definition the reasoner finds the parts.
void Builder::imply_definitions() {
  for (const std::size_t e : underived()) {
    if (catalogue_.entities[e].sufficiency == Sufficiency::Defined) {
      imply_minimal_parts(e);
      continue;
    }
    Implication rule{{}, {}, Implication::Head::Entity, e, {}};
    for (const Entailed& has : catalogue_.described(e)) {
      rule.features.push_back(has.index);
      rule.axioms = join(rule.axioms, has.axioms);
    }
    catalogue_.implications.push_back(std::move(rule));
  }
}

void Builder::add_implications() {
  for (const owl::Axiom& axiom : ontology().axioms()) {
    budget_.check();
    imply_told(axiom);
  }
  imply_single_features();
  imply_definitions();
}

}  // namespace heed::awareness
