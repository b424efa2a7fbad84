#include "theory_builder.h"

#include "datatypes.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::dl {

TheoryBuilder::TheoryBuilder(Theory& theory, const owl::Ontology& ontology)
    : theory_(theory), ontology_(ontology) {
  intern({ConceptKind::Top, 0, 0});
  intern({ConceptKind::Bottom, 0, 0});
}

void TheoryBuilder::losses(ConceptNode& node) const {
  const auto right = [&](Concept c) { return theory_.concepts_[c].loss_right; };
  const auto left = [&](Concept c) { return theory_.concepts_[c].loss_left; };
  const auto set = [&](unsigned r, unsigned l) {
    node.loss_right = static_cast<std::uint16_t>(r);
    node.loss_left = static_cast<std::uint16_t>(l);
  };
  switch (node.kind) {
    case ConceptKind::And:
      return set(right(node.a) | right(node.b), left(node.a) | left(node.b));
    case ConceptKind::Or:
      return set(UnionRight, left(node.a) | left(node.b));
    case ConceptKind::Not:
      return set(left(node.a), ComplementLeft);
    case ConceptKind::Some:
      return set(right(node.b), left(node.b));
    case ConceptKind::All:
      return set(right(node.b), UniversalLeft);
    case ConceptKind::AtMostOne:
      return set(NoLoss, NumberLeft);
    case ConceptKind::AtLeast:
      return set(NumberRight | right(node.a), NumberLeft | left(node.a));
    case ConceptKind::AtMost:
      return set(NumberRight, NumberLeft);
    case ConceptKind::Self:
      return set(NoLoss, SelfLeft);
    case ConceptKind::Unknown:
      return set(KindLoss, KindLoss);
    default:
      return;
  }
}

Concept TheoryBuilder::intern(ConceptNode node) {
  const auto [place, is_new] =
      theory_.numbers_.try_emplace(node, static_cast<Concept>(theory_.concepts_.size()));
  if (!is_new) return place->second;
  losses(node);
  theory_.concepts_.push_back(node);
  theory_.told_.emplace_back();
  theory_.conjunctions_.emplace_back();
  theory_.left_.emplace_back();
  theory_.groups_.emplace_back();
  theory_.goals_.emplace_back();
  if (node.kind == ConceptKind::Individual) theory_.individuals_.push_back(place->second);
  return place->second;
}

Role TheoryBuilder::new_role() {
  const auto role = static_cast<Role>(theory_.role_edges_.size());
  for (int direction = 0; direction < 2; ++direction) {
    theory_.role_edges_.emplace_back();
    theory_.domains_.emplace_back();
    theory_.ranges_.emplace_back();
    theory_.functional_.push_back(nothing_known);
    theory_.transitive_.push_back(nothing_known);
  }
  return role;
}

Role TheoryBuilder::role_of(owl::Iri iri, bool data) {
  const auto [place, is_new] = theory_.roles_.try_emplace((std::uint64_t{iri.id} << 1) | (data ? 1U : 0U));
  if (is_new) place->second = new_role();
  return place->second;
}

Concept TheoryBuilder::literal(const owl::Literal& literal) {
  const Theory::DataKey key = Theory::key_of(literal);
  const auto [place, is_new] =
      theory_.data_.try_emplace(key.text, static_cast<std::uint32_t>(theory_.data_.size()));
  const Concept c = intern({ConceptKind::Data, place->second, 0});
  const Concept type = data_range(owl::DataRange::datatype(key.datatype));
  if (type != top &&
      std::none_of(theory_.told_[c].begin(), theory_.told_[c].end(), [&](Told t) { return t.super == type; }))
    theory_.told_[c].push_back({type, 0});
  if (is_new && !key.family.empty()) families_[key.family].push_back(c);
  return c;
}

Concept TheoryBuilder::data_range(const owl::DataRange& range) {
  const std::string key = Theory::key_of(range);
  if (key.empty()) return top;
  const auto [place, is_new] =
      theory_.data_.try_emplace(key, static_cast<std::uint32_t>(theory_.data_.size()));
  const Concept c = intern({ConceptKind::Data, place->second, 0});
  if (range.kind() != owl::DataRange::Kind::Datatype)
    theory_.concepts_[c].loss_right = theory_.concepts_[c].loss_left = DataRangeLoss;
  else if (is_new)
    place_datatype(c, range.iri());
  return c;
}

/// Below the built-in datatypes that hold all its values, and below its primitive one, which excludes others.
void TheoryBuilder::place_datatype(Concept c, owl::Iri datatype) {
  std::string name(ontology_.text(datatype));
  for (std::string next = datatype_above(name); !next.empty(); next = datatype_above(name)) {
    name = std::move(next);
    const auto known = ontology_.find(name);
    if (!known) continue;
    const Concept super = data_range(owl::DataRange::datatype(*known));
    theory_.told_[c].push_back({super, 0});
  }
  if (!is_primitive_datatype(name)) return;
  const auto [place, is_new] =
      theory_.data_.try_emplace("primitive " + name, static_cast<std::uint32_t>(theory_.data_.size()));
  const Concept primitive = intern({ConceptKind::Data, place->second, 0});
  if (is_new) families_["primitive datatypes"].push_back(primitive);
  theory_.told_[c].push_back({primitive, 0});
}

void TheoryBuilder::add(const owl::Axiom& axiom) {
  axiom_ = &axiom;
  reason_ = axiom.id.number;
  std::visit(*this, axiom.content);
}

void TheoryBuilder::drop(const std::string& why) {
  theory_.dropped_.push_back({axiom_->id, why, {}});
}

void TheoryBuilder::drop_losses(unsigned loss) {
  static constexpr std::pair<unsigned, const char*> texts[] = {
      {UnionRight,
       "a union or enumeration on the right of an inclusion is used by cases, to a bounded depth"},
      {ComplementLeft, "a complement on the left of an inclusion is used by refutation, to a bounded depth"},
      {UniversalLeft,
       "a universal restriction on the left of an inclusion is used by refutation, to a bounded depth"},
      {NumberRight, "a number restriction other than `max 0`, `max 1` and `min 1`"},
      {NumberLeft,
       "a number restriction on the left of an inclusion is used only where successors that are told to "
       "differ reach it"},
      {DataRangeLoss, "a data range is only compared by its text"},
      {SelfLeft, "a self restriction on the left of an inclusion"},
      {KindLoss, "an expression over several data properties"}};
  for (const auto& [bit, text] : texts)
    if ((loss & bit) != 0) drop(text);
}

void TheoryBuilder::include(Concept sub, Concept super) {
  drop_losses(theory_.concepts_[sub].loss_left | theory_.concepts_[super].loss_right);
  if (super == top || sub == bottom || sub == super) return;
  theory_.told_[sub].push_back({super, reason_});
  place_left(sub);
  place_right(super);
  place();
}

void TheoryBuilder::place_right(Concept c) {
  if (theory_.concepts_[c].right) return;
  theory_.concepts_[c].right = true;
  pending_.emplace_back(c, true);
}

void TheoryBuilder::place_left(Concept c) {
  if (theory_.concepts_[c].left) return;
  theory_.concepts_[c].left = true;
  pending_.emplace_back(c, false);
  deny(c);
}

/// `not C` on the left holds where C cannot be, `only R C` where `some R not C` cannot.
void TheoryBuilder::deny(Concept goal) {
  const ConceptNode node = theory_.concepts_[goal];
  Concept denied = nothing_known;
  if (node.kind == ConceptKind::Not) denied = node.a;
  if (node.kind == ConceptKind::All) denied = some(node.a, negation(node.b));
  if (denied == nothing_known) return;
  theory_.denied_.emplace(goal, denied);
  place_right(denied);
}

/// Gives each concept the rules for the side on which it stands. What has no rule there was reported as a
/// loss.
void TheoryBuilder::place() {
  while (!pending_.empty()) {
    const auto [c, right] = pending_.back();
    pending_.pop_back();
    const ConceptNode node = theory_.concepts_[c];
    if (node.kind == ConceptKind::And) {
      if (right) {
        place_right(node.a), place_right(node.b);
      } else {
        theory_.conjunctions_[node.a].push_back({node.b, c});
        theory_.conjunctions_[node.b].push_back({node.a, c});
        place_left(node.a), place_left(node.b);
        if (theory_.denied(node.a) != nothing_known) theory_.goals_[node.b].push_back(node.a);
        if (theory_.denied(node.b) != nothing_known) theory_.goals_[node.a].push_back(node.b);
      }
    } else if (node.kind == ConceptKind::Some) {
      if (right) {
        place_right(node.b);
        if (right_roles_.size() <= node.a) right_roles_.resize(node.a + 64);
        right_roles_[node.a] = true;
      } else {
        theory_.left_[node.b].push_back({node.a, c});
        place_left(node.b);
      }
    } else if (node.kind == ConceptKind::Or) {
      if (right) {
        place_right(node.a), place_right(node.b);
      } else {
        theory_.told_[node.a].push_back({c, 0});
        theory_.told_[node.b].push_back({c, 0});
        place_left(node.a), place_left(node.b);
      }
    } else if (node.kind == ConceptKind::Not && right) {
      theory_.conjunctions_[node.a].push_back({c, bottom});
      theory_.conjunctions_[c].push_back({node.a, bottom});
      place_left(node.a);
    } else if (node.kind == ConceptKind::All && right) {
      place_right(node.b);
    } else if (node.kind == ConceptKind::AtLeast) {
      if (right) {
        theory_.told_[c].push_back({node.a, 0});
        place_right(node.a);
      } else {
        theory_.counted_.push_back(c);
        place_left(theory_.concepts_[node.a].b);
      }
    }
  }
}

void TheoryBuilder::disjoint(const std::vector<Concept>& members) {
  unsigned loss = 0;
  const std::uint32_t group = group_count_++;
  std::set<Concept> seen;
  for (const Concept member : members) {
    loss |= theory_.concepts_[member].loss_left;
    if (!seen.insert(member).second) {
      include(member, bottom);
      continue;
    }
    theory_.groups_[member].push_back({group, reason_});
    place_left(member);
  }
  place();
  if (axiom_ != nullptr) drop_losses(loss);
}

void TheoryBuilder::operator()(const owl::EquivalentClasses& a) {
  std::vector<Concept> members;
  for (const auto& c : a.classes) members.push_back(translate(c));
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members.size() < 2) break;
    include(members[i], members[(i + 1) % members.size()]);
  }
}

void TheoryBuilder::operator()(const owl::DisjointClasses& a) {
  std::vector<Concept> members;
  for (const auto& c : a.classes) members.push_back(translate(c));
  disjoint(members);
}

void TheoryBuilder::operator()(const owl::DisjointUnion& a) {
  std::vector<Concept> members;
  const Concept whole = intern({ConceptKind::Class, a.whole.id, 0});
  for (const auto& c : a.parts) members.push_back(translate(c));
  disjoint(members);
  for (const Concept member : members) include(member, whole);
  include(whole, disjunction(members));
}

void TheoryBuilder::role_edge(Role sub, Role super) {
  theory_.role_edges_[sub].push_back({super, reason_});
  theory_.role_edges_[inverse(sub)].push_back({inverse(super), reason_});
}

void TheoryBuilder::chain(Role first, Role second, Role super) {
  chains_.push_back({first, second, super, reason_});
  chains_.push_back({inverse(second), inverse(first), inverse(super), reason_});
}

void TheoryBuilder::operator()(const owl::SubObjectPropertyOf& a) {
  const Role super = role_of(a.super);
  std::vector<Role> roles;
  for (const auto& property : a.chain) roles.push_back(role_of(property));
  if (roles.size() == 1) return role_edge(roles.front(), super);
  Role front = roles.front();
  for (std::size_t i = 1; i < roles.size(); ++i) {
    const Role composed = i + 1 == roles.size() ? super : new_role();
    chain(front, roles[i], composed);
    front = composed;
  }
}

void TheoryBuilder::operator()(const owl::EquivalentObjectProperties& a) {
  for (std::size_t i = 0; i < a.properties.size(); ++i)
    role_edge(role_of(a.properties[i]), role_of(a.properties[(i + 1) % a.properties.size()]));
}

void TheoryBuilder::operator()(const owl::EquivalentDataProperties& a) {
  for (std::size_t i = 0; i < a.properties.size(); ++i)
    role_edge(role_of(a.properties[i], true), role_of(a.properties[(i + 1) % a.properties.size()], true));
}

void TheoryBuilder::operator()(const owl::InverseObjectProperties& a) {
  const Role first = role_of(a.first);
  const Role second = inverse(role_of(a.second));
  role_edge(first, second);
  role_edge(second, first);
}

void TheoryBuilder::domain(Role role, Concept c) {
  drop_losses(theory_.concepts_[c].loss_right);
  theory_.domains_[role].push_back({c, reason_});
  theory_.ranges_[inverse(role)].push_back({c, reason_});
  place_right(c);
  place();
}

void TheoryBuilder::range(Role role, Concept c) {
  domain(inverse(role), c);
}

void TheoryBuilder::operator()(const owl::ObjectPropertyCharacteristic& a) {
  const Role role = role_of(a.property);
  switch (a.characteristic) {
    case owl::Characteristic::Functional:
    case owl::Characteristic::InverseFunctional: {
      const Role which = a.characteristic == owl::Characteristic::Functional ? role : inverse(role);
      if (theory_.functional_[which] == nothing_known) theory_.functional_[which] = reason_;
      functional_axioms_.emplace_back(axiom_, which);
      break;
    }
    case owl::Characteristic::Transitive:
      chain(role, role, role);
      theory_.transitive_[role] = theory_.transitive_[inverse(role)] = reason_;
      break;
    case owl::Characteristic::Symmetric:
      role_edge(role, inverse(role));
      break;
    case owl::Characteristic::Reflexive:
      include(top, intern({ConceptKind::Self, role, 0}));
      break;
    case owl::Characteristic::Irreflexive:
      drop("irreflexive properties are not used");
      break;
    case owl::Characteristic::Asymmetric:
      drop("asymmetric properties are not used");
      break;
  }
}

void TheoryBuilder::operator()(const owl::SameIndividual& a) {
  for (std::size_t i = 0; i < a.individuals.size(); ++i)
    include(individual(a.individuals[i]), individual(a.individuals[(i + 1) % a.individuals.size()]));
}

void TheoryBuilder::operator()(const owl::DifferentIndividuals& a) {
  std::vector<Concept> members;
  for (const owl::Iri iri : a.individuals) members.push_back(individual(iri));
  disjoint(members);
}

void TheoryBuilder::operator()(const owl::ObjectPropertyAssertion& a) {
  const Role role = role_of(a.property);
  const Concept source = individual(a.source);
  const Concept target = individual(a.target);
  if (a.negative) return include(conjunction({source, some(role, target)}), bottom);
  include(source, some(role, target));
}

void TheoryBuilder::operator()(const owl::DataPropertyAssertion& a) {
  const Concept value = some(role_of(a.property, true), literal(a.value));
  const Concept source = individual(a.source);
  if (a.negative) return include(conjunction({source, value}), bottom);
  include(source, value);
}

void TheoryBuilder::operator()(const owl::Declaration& a) {
  if (a.kind == owl::EntityKind::Class && !owl::ClassExpression::named(a.entity).is_thing() &&
      !owl::ClassExpression::named(a.entity).is_nothing())
    intern({ConceptKind::Class, a.entity.id, 0});
  if (a.kind == owl::EntityKind::NamedIndividual) individual(a.entity);
}

}  // namespace heed::dl
