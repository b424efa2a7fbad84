#include "told.h"

#include <algorithm>
#include <deque>
#include <iterator>

namespace heed::awareness {

Axioms join(const Axioms& a, const Axioms& b) {
  Axioms result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

std::map<owl::Iri, Axioms> ToldGraph::above(owl::Iri sub) const {
  std::map<owl::Iri, Axioms> found{{sub, {}}};
  std::deque<owl::Iri> queue{sub};
  while (!queue.empty()) {
    const owl::Iri node = queue.front();
    queue.pop_front();
    const auto edges = edges_.find(node);
    if (edges == edges_.end()) continue;
    for (const Edge& edge : edges->second)
      if (!found.contains(edge.super)) {
        found[edge.super] = join(found[node], {edge.axiom});
        queue.push_back(edge.super);
      }
  }
  return found;
}

std::optional<Axioms> ToldGraph::path(owl::Iri sub, owl::Iri super) const {
  if (sub == super) return Axioms{};
  const auto all = above(sub);
  const auto found = all.find(super);
  if (found == all.end()) return std::nullopt;
  return found->second;
}

std::vector<owl::ClassExpression> conjuncts(const owl::ClassExpression& expression) {
  std::vector<owl::ClassExpression> result;
  std::vector<owl::ClassExpression> stack{expression};
  while (!stack.empty()) {
    const owl::ClassExpression top = stack.back();
    stack.pop_back();
    if (top.kind() != owl::ClassExpression::Kind::Intersection) {
      result.push_back(top);
      continue;
    }
    const auto& parts = top.operands();
    stack.insert(stack.end(), parts.rbegin(), parts.rend());
  }
  return result;
}

namespace {

bool binds(owl::ClassExpression::Kind kind) {
  using Kind = owl::ClassExpression::Kind;
  return kind == Kind::Some || kind == Kind::HasValue || kind == Kind::Min || kind == Kind::Exactly;
}

}  // namespace

Told::Told(const owl::Ontology& ontology, std::optional<owl::Iri> subclass_role) {
  for (const owl::Axiom& axiom : ontology.axioms()) read_axiom(axiom, subclass_role);
  const std::set<owl::Iri> stated = derived;
  for (const owl::Iri role : stated)
    for (const auto& [super, why] : roles.above(role)) derived.insert(super);
}

std::optional<Axioms> Told::functional_because(owl::Iri role) const {
  for (const auto& [super, why] : roles.above(role))
    if (const auto found = functional.find(super); found != functional.end())
      return join(why, {found->second});
  return std::nullopt;
}

std::optional<Axioms> Told::functional_because(owl::Iri a, owl::Iri b) const {
  if (a == b) return functional_because(a);
  const auto above_b = roles.above(b);
  for (const auto& [super, why] : roles.above(a)) {
    const auto common = above_b.find(super);
    const auto found = functional.find(super);
    if (common != above_b.end() && found != functional.end())
      return join(join(why, common->second), {found->second});
  }
  return std::nullopt;
}

void Told::add_disjoint(owl::Iri a, owl::Iri b, owl::AxiomId axiom) {
  disjoint.emplace(std::pair(a, b), axiom);
  disjoint.emplace(std::pair(b, a), axiom);
}

void Told::read_axiom(const owl::Axiom& axiom, std::optional<owl::Iri> subclass_role) {
  if (const auto* declaration = axiom.as<owl::Declaration>())
    declared.emplace(declaration->entity, axiom.location);
  else if (owl::is_logical(axiom)) {
    read_class_axiom(axiom);
    read_role_axiom(axiom);
    read_assertion(axiom, subclass_role);
  }
}

void Told::read_class_axiom(const owl::Axiom& axiom) {
  if (const auto* inclusion = axiom.as<owl::SubClassOf>())
    read_inclusion(inclusion->sub, inclusion->super, axiom.id);
  if (const auto* equivalence = axiom.as<owl::EquivalentClasses>())
    for (const auto& sub : equivalence->classes)
      for (const auto& super : equivalence->classes)
        if (!sub.identical(super) && sub.is_named()) read_inclusion(sub, super, axiom.id);
  if (const auto* whole = axiom.as<owl::DisjointUnion>()) {
    for (const auto& part : whole->parts)
      read_inclusion(part, owl::ClassExpression::named(whole->whole), axiom.id);
    for (const auto& a : whole->parts)
      for (const auto& b : whole->parts)
        if (a.is_named() && b.is_named() && a.iri() < b.iri()) add_disjoint(a.iri(), b.iri(), axiom.id);
  }
  if (const auto* apart = axiom.as<owl::DisjointClasses>())
    for (std::size_t i = 0; i < apart->classes.size(); ++i)
      for (std::size_t j = i + 1; j < apart->classes.size(); ++j)
        if (apart->classes[i].is_named() && apart->classes[j].is_named())
          add_disjoint(apart->classes[i].iri(), apart->classes[j].iri(), axiom.id);
}

void Told::read_role_axiom(const owl::Axiom& axiom) {
  if (const auto* inclusion = axiom.as<owl::SubObjectPropertyOf>()) {
    if (inclusion->chain.size() != 1)
      derived.insert(inclusion->super.iri);
    else if (!inclusion->chain[0].inverse && !inclusion->super.inverse)
      roles.add(inclusion->chain[0].iri, inclusion->super.iri, axiom.id);
  }
  if (const auto* equivalence = axiom.as<owl::EquivalentObjectProperties>())
    for (const auto& a : equivalence->properties)
      for (const auto& b : equivalence->properties)
        if (a != b && !a.inverse && !b.inverse) roles.add(a.iri, b.iri, axiom.id);
  if (const auto* is = axiom.as<owl::ObjectPropertyCharacteristic>()) {
    if (is->characteristic == owl::Characteristic::Functional && !is->property.inverse)
      functional.emplace(is->property.iri, axiom.id);
    if (is->characteristic == owl::Characteristic::Transitive) derived.insert(is->property.iri);
  }
  if (const auto* range = axiom.as<owl::ObjectPropertyRange>())
    if (range->range.is_named() && !range->property.inverse)
      ranges[range->property.iri].push_back(range->range.iri());
}

void Told::read_assertion(const owl::Axiom& axiom, std::optional<owl::Iri> subclass_role) {
  if (const auto* type = axiom.as<owl::ClassAssertion>())
    for (const auto& part : conjuncts(type->of)) read_conjunct(type->individual, part, axiom.id);
  if (const auto* role = axiom.as<owl::ObjectPropertyAssertion>(); role && !role->negative) {
    const owl::Iri source = role->property.inverse ? role->target : role->source;
    const owl::Iri target = role->property.inverse ? role->source : role->target;
    if (role->property.iri == subclass_role)
      concepts.add(source, target, axiom.id);
    else
      bindings[source].push_back({role->property.iri, target, true, axiom.id});
  }
  if (const auto* different = axiom.as<owl::DifferentIndividuals>())
    for (std::size_t i = 0; i < different->individuals.size(); ++i)
      for (std::size_t j = i + 1; j < different->individuals.size(); ++j)
        add_disjoint(different->individuals[i], different->individuals[j], axiom.id);
}

void Told::read_inclusion(const owl::ClassExpression& sub, const owl::ClassExpression& super,
                          owl::AxiomId axiom) {
  if (!sub.is_named()) {
    for (const auto& part : conjuncts(super))
      if (binds(part.kind())) derived.insert(part.property().iri);
    return;
  }
  for (const auto& part : conjuncts(super)) read_conjunct(sub.iri(), part, axiom);
}

void Told::read_conjunct(owl::Iri holder, const owl::ClassExpression& conjunct, owl::AxiomId axiom) {
  using Kind = owl::ClassExpression::Kind;
  const Kind kind = conjunct.kind();
  if (conjunct.is_named() && !conjunct.is_thing()) concepts.add(holder, conjunct.iri(), axiom);
  const bool counted = (kind == Kind::Min || kind == Kind::Exactly) && conjunct.cardinality() >= 1;
  if (kind == Kind::HasValue && !conjunct.property().inverse)
    bindings[holder].push_back({conjunct.property().iri, conjunct.individuals()[0], true, axiom});
  if ((kind != Kind::Some && !counted) || conjunct.property().inverse) return;
  for (const auto& part : conjuncts(conjunct.filler())) {
    if (part.is_named() && !part.is_thing())
      bindings[holder].push_back({conjunct.property().iri, part.iri(), false, axiom});
    if (part.kind() == Kind::OneOf && part.individuals().size() == 1)
      bindings[holder].push_back({conjunct.property().iri, part.individuals()[0], true, axiom});
  }
}

}  // namespace heed::awareness
