#include "horn.h"

#include "told.h"

#include <algorithm>

namespace heed::awareness {
namespace {

constexpr std::uint32_t no_rule = static_cast<std::uint32_t>(-1);
const std::vector<owl::AxiomId> no_axioms{};

}  // namespace

HornBase::HornBase(const Catalogue& catalogue)
    : features_(catalogue.features.size()),
      entities_(catalogue.entities.size()),
      behaviours_(catalogue.behaviours.size()) {
  for (const auto& [pair, why] : catalogue.exclusive)
    add_rule({feature(pair.first), feature(pair.second)}, nothing(), why);
  for (std::size_t f = 0; f < features_; ++f) add_rule({feature(f), excluded(f)}, nothing(), no_axioms);
  add_features(catalogue);
  add_entities(catalogue);
  add_implications(catalogue);
  rules_with_.resize(size());
  for (const bool to_nothing : {true, false})
    for (std::uint32_t r = 0; r < rules_.size(); ++r)
      if ((rules_[r].head == nothing()) == to_nothing)
        for (const Prop p : rules_[r].body) rules_with_[p].push_back(r);
}

void HornBase::add_rule(std::vector<Prop> body, Prop head, const std::vector<owl::AxiomId>& axioms) {
  std::sort(body.begin(), body.end());
  rules_.push_back({std::move(body), head, &axioms});
}

void HornBase::add_features(const Catalogue& catalogue) {
  for (std::size_t f = 0; f < features_; ++f) {
    const Feature& it = catalogue.features[f];
    for (const Entailed& more : it.implies) add_rule({feature(f)}, feature(more.index), more.axioms);
    if (!it.entity) continue;
    add_rule({feature(f)}, entity(*it.entity), no_axioms);
    add_rule({entity(*it.entity)}, feature(f), no_axioms);
  }
  for (std::size_t b = 0; b < behaviours_; ++b)
    for (const Entailed& up : catalogue.behaviours[b].general)
      add_rule({behaviour(b)}, behaviour(up.index), up.axioms);
}

void HornBase::add_entities(const Catalogue& catalogue) {
  for (std::size_t e = 0; e < entities_; ++e) {
    const Entity& it = catalogue.entities[e];
    if (!it.satisfiable) {
      add_rule({entity(e)}, nothing(), it.impossible);
      continue;
    }
    for (const Entailed& has : it.features) add_rule({entity(e)}, feature(has.index), has.axioms);
    for (const Entailed& up : it.ancestors) add_rule({entity(e)}, entity(up.index), up.axioms);
    for (const Entailed& act : it.behaviours) add_rule({entity(e)}, behaviour(act.index), act.axioms);
  }
}

void HornBase::add_implications(const Catalogue& catalogue) {
  for (const Implication& it : catalogue.implications) {
    std::vector<Prop> body;
    for (const std::size_t f : it.features) body.push_back(feature(f));
    for (const std::size_t e : it.entities) body.push_back(entity(e));
    Prop head = nothing();
    if (it.head == Implication::Head::Entity) head = entity(it.index);
    if (it.head == Implication::Head::Feature) head = feature(it.index);
    if (it.head == Implication::Head::Behaviour) head = behaviour(it.index);
    add_rule(std::move(body), head, it.axioms);
  }
}

std::vector<char> HornBase::chain(const std::vector<Prop>& facts, std::vector<std::uint32_t>* by) const {
  std::vector<char> holds(size(), 0);
  std::vector<std::uint32_t> missing(rules_.size());
  for (std::size_t r = 0; r < rules_.size(); ++r)
    missing[r] = static_cast<std::uint32_t>(rules_[r].body.size());
  std::vector<Prop> queue;
  const auto derive = [&](Prop p, std::uint32_t rule) {
    if (holds[p] != 0) return;
    holds[p] = 1;
    if (by != nullptr) (*by)[p] = rule;
    queue.push_back(p);
  };
  for (const Prop p : facts) derive(p, no_rule);
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const std::uint32_t r : rules_with_[queue[i]])
      if (--missing[r] == 0) derive(rules_[r].head, r);
  return holds;
}

std::vector<char> HornBase::closure(const std::vector<Prop>& facts) const {
  return chain(facts, nullptr);
}

std::optional<std::vector<owl::AxiomId>> HornBase::why(const std::vector<Prop>& facts, Prop goal) const {
  std::vector<std::uint32_t> by(size(), no_rule);
  if (chain(facts, &by)[goal] == 0) return std::nullopt;
  std::vector<owl::AxiomId> axioms;
  std::vector<char> seen(size(), 0);
  std::vector<Prop> open{goal};
  while (!open.empty()) {
    const Prop p = open.back();
    open.pop_back();
    if (seen[p] != 0 || by[p] == no_rule) continue;
    seen[p] = 1;
    axioms = join(axioms, *rules_[by[p]].axioms);
    open.insert(open.end(), rules_[by[p]].body.begin(), rules_[by[p]].body.end());
  }
  leave_out(axioms, facts, goal);
  return axioms;
}

/// The first derivation found may be a detour: takes out every axiom without which the others still derive \p
/// goal. Only rules that rest on \p axioms are looked at, and they are few.
void HornBase::leave_out(std::vector<owl::AxiomId>& axioms, const std::vector<Prop>& facts, Prop goal) const {
  if (axioms.size() < 2) return;
  const auto rests_on = [](const Rule& rule, const std::vector<owl::AxiomId>& some) {
    return std::includes(some.begin(), some.end(), rule.axioms->begin(), rule.axioms->end());
  };
  std::vector<const Rule*> usable;
  for (const Rule& rule : rules_)
    if (rests_on(rule, axioms)) usable.push_back(&rule);
  const auto derives = [&](const std::vector<owl::AxiomId>& some) {
    std::vector<char> holds(size(), 0);
    for (const Prop p : facts) holds[p] = 1;
    for (bool more = true; more && holds[goal] == 0;) {
      more = false;
      for (const Rule* rule : usable) {
        if (holds[rule->head] != 0 || !rests_on(*rule, some)) continue;
        if (!std::all_of(rule->body.begin(), rule->body.end(), [&](Prop p) { return holds[p] != 0; }))
          continue;
        holds[rule->head] = 1;
        more = true;
      }
    }
    return holds[goal] != 0;
  };
  const auto all = axioms;
  for (const owl::AxiomId axiom : all) {
    auto fewer = axioms;
    std::erase(fewer, axiom);
    if (derives(fewer)) axioms = std::move(fewer);
  }
}

}  // namespace heed::awareness
