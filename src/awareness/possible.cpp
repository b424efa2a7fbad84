#include "possible.h"

#include "told.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace heed::awareness {
namespace {

const char* const something_seen = "something_seen";
const char* const conflict = "observation_conflict";
const char* const unknown = "unknown_entity";

/// Evidence behind situations is for people: a handful shows the idea.
constexpr std::size_t listed_against = evidence_cap;

}  // namespace

Possibilities::Possibilities(const Catalogue& catalogue, const Perception& perception, bool closed,
                             bool whole)
    : catalogue_(catalogue),
      perception_(perception),
      closed_(closed),
      base_(catalogue),
      which_(catalogue, closed) {
  observe(whole);
  for (const std::size_t e : which_.entities) add_unit(e);
  build_tree();
}

/// Values of one enumerated input are never seen together, nor is what a full view says to be missing.
void Possibilities::observe(bool whole) {
  std::vector<char> observable(base_.size(), 0);
  const auto add = [&](HornBase::Prop p, const std::string& atom, bool seen) {
    if (atom.empty()) return;
    observable[p] = 1;
    atoms_[p] = atom;
    if (!seen) return;
    seen_.push_back(atom);
    any_seen_.push_back({p});
  };
  for (std::size_t f = 0; f < catalogue_.features.size(); ++f) {
    add(base_.feature(f), perception_.feature_atom[f], true);
    if (f < perception_.excluded_atom.size()) add(base_.excluded(f), perception_.excluded_atom[f], false);
  }
  for (std::size_t e = 0; whole && e < catalogue_.entities.size(); ++e)
    add(base_.entity(e), perception_.whole_atom[e], true);
  std::vector<std::pair<HornBase::Prop, HornBase::Prop>> never;
  for (const PerceptionInput& input : perception_.inputs)
    for (std::size_t i = 0; i < input.meanings.size(); ++i)
      for (std::size_t j = i + 1; j < input.meanings.size(); ++j)
        never.emplace_back(base_.feature(*input.meanings[i].feature),
                           base_.feature(*input.meanings[j].feature));
  for (std::size_t f = 0; !perception_.absences.empty() && f < catalogue_.features.size(); ++f)
    never.emplace_back(base_.feature(f), base_.excluded(f));
  labels_ = std::make_unique<Labels>(base_, std::move(observable), std::move(never));
}

void Possibilities::add_unit(std::size_t entity) {
  const Labels labels(*labels_, entity);
  Unit unit{entity, "possible_" + catalogue_.entities[entity].atom, labels.contradictions(), {}};
  for (std::size_t b = 0; b < catalogue_.behaviours.size(); ++b)
    if (auto prompts = labels.of(base_.behaviour(b)); !prompts.empty()) unit.prompts[b] = std::move(prompts);
  at_[entity] = units_.size();
  units_.push_back(std::move(unit));
}

/// Per power of two the conjunctions over aligned runs of units, so that "no other" is short for each of
/// many.
void Possibilities::build_tree() {
  none_.emplace_back();
  for (const Unit& unit : units_) none_[0].push_back(!is_candidate(unit));
  while (none_.back().size() > 1) {
    const auto& below = none_.back();
    std::vector<logic::Formula> level;
    for (std::size_t i = 0; i + 1 < below.size(); i += 2) level.push_back(below[i] && below[i + 1]);
    if (below.size() % 2 == 1) level.push_back(below.back());
    none_.push_back(std::move(level));
  }
}

logic::Formula Possibilities::no_candidate(std::size_t from, std::size_t to) const {
  std::vector<logic::Formula> parts;
  while (from < to) {
    std::size_t k = from == 0 ? std::bit_width(to) : static_cast<std::size_t>(std::countr_zero(from));
    while ((std::size_t{1} << k) > to - from) --k;
    parts.push_back(none_[k][from >> k]);
    from += std::size_t{1} << k;
  }
  return logic::all_of(std::move(parts));
}

logic::Formula Possibilities::is_candidate(const Unit& unit) const {
  std::vector<logic::Formula> parts{logic::name(unit.name)};
  if (!closed_)
    for (const std::size_t child : which_.children[unit.entity])
      parts.push_back(!logic::name(units_[at_.at(child)].name));
  return logic::all_of(std::move(parts));
}

logic::Formula Possibilities::formula_of(const Environment& environment) const {
  std::vector<logic::Formula> parts;
  parts.reserve(environment.size());
  for (const HornBase::Prop p : environment) parts.push_back(logic::name(atoms_.at(p)));
  return logic::all_of(std::move(parts));
}

logic::Formula Possibilities::formula_of(const std::vector<Environment>& environments) const {
  std::vector<logic::Formula> cases;
  cases.reserve(environments.size());
  for (const Environment& environment : environments) cases.push_back(formula_of(environment));
  return logic::any_of(std::move(cases));
}

Evidence Possibilities::evidence_of(const Environment& environment,
                                    const std::vector<owl::AxiomId>& axioms) const {
  Evidence evidence{{}, axioms};
  for (const HornBase::Prop p : environment) evidence.atoms.push_back(atoms_.at(p));
  std::sort(evidence.atoms.begin(), evidence.atoms.end());
  return evidence;
}

/// With the axioms by which each leads to \p goal, given \p known.
std::vector<Evidence> Possibilities::list(const std::vector<Environment>& environments,
                                          std::optional<HornBase::Prop> known, HornBase::Prop goal) const {
  std::vector<Evidence> result;
  for (const Environment& environment : environments) {
    if (result.size() == listed_against) break;
    auto facts = environment;
    if (known) facts.push_back(*known);
    result.push_back(evidence_of(environment, base_.why(facts, goal).value_or(Axioms{})));
  }
  return result;
}

std::vector<Situation> Possibilities::situations() const {
  using Kind = Situation::Kind;
  std::vector<Situation> result;
  std::vector<logic::Formula> any;
  for (const std::string& atom : seen_) any.push_back(logic::name(atom));
  result.push_back({Kind::Seen, something_seen, logic::any_of(std::move(any)), "something is seen", {}, {}});
  const auto& general = labels_->contradictions();
  result.push_back({Kind::Conflict,
                    conflict,
                    formula_of(general),
                    "what is seen contradicts itself",
                    {},
                    list(general, std::nullopt, base_.nothing())});
  std::vector<logic::Formula> none{logic::name(something_seen), !logic::name(conflict)};
  for (const Unit& unit : units_) {
    result.push_back(
        {Kind::Possible, unit.name, !logic::name(conflict) && !formula_of(unit.against),
         fmt::format("'{}' is still possible", catalogue_.entities[unit.entity].label), unit.entity,
         units_.size() > listed_against ? std::vector<Evidence>{}
                                        : list(unit.against, base_.entity(unit.entity), base_.nothing())});
    none.push_back(!logic::name(unit.name));
  }
  result.push_back({Kind::Unknown,
                    unknown,
                    logic::all_of(std::move(none)),
                    "something is seen that nothing in the catalogue fits",
                    {},
                    {}});
  return result;
}

Rule Possibilities::recognised(std::size_t entity) const {
  const auto sets = labels_->of(base_.entity(entity));
  return {formula_of(sets), list(sets, std::nullopt, base_.entity(entity)), sets.size() <= evidence_cap};
}

Rule Possibilities::called_for(std::size_t behaviour) const {
  const auto sets = labels_->of(base_.behaviour(behaviour));
  return {formula_of(sets), list(sets, std::nullopt, base_.behaviour(behaviour)),
          sets.size() <= evidence_cap};
}

std::vector<owl::AxiomId> Possibilities::why_identified(std::size_t entity, const Environment& seen) const {
  std::vector<owl::AxiomId> axioms;
  for (const Unit& unit : units_) {
    if (within(catalogue_, unit.entity, entity)) continue;
    auto facts = seen;
    facts.push_back(base_.entity(unit.entity));
    axioms = join(axioms, base_.why(facts, base_.nothing()).value_or(Axioms{}));
  }
  return axioms;
}

/// The candidates outside \p entity have all fallen away and one inside has not. In an open catalogue a group
/// above \p entity is no candidate then, since \p entity is possible; any other group has to be ruled out.
Rule Possibilities::identified(std::size_t entity, std::size_t& work) const {
  HittingTask task{{}, {}, labels_.get()};
  std::vector<logic::Formula> parts{logic::name(something_seen), !logic::name(conflict),
                                    !logic::name(unknown)};
  std::size_t from = 0;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    const bool inside = within(catalogue_, units_[i].entity, entity);
    const bool above = catalogue_.is_below(entity, units_[i].entity) != nullptr;
    if (!inside && !above) task.duties.push_back(&units_[i].against);
    if (!inside) continue;
    task.inside.push_back(&units_[i].against);
    parts.push_back(no_candidate(from, i));
    from = i + 1;
  }
  if (task.inside.empty()) return {};
  parts.push_back(no_candidate(from, units_.size()));
  const bool hopeless = std::any_of(task.duties.begin(), task.duties.end(),
                                    [](const auto* against) { return against->empty(); });
  if (hopeless) return {};
  Rule rule{logic::all_of(std::move(parts)), {}, false};
  task.duties.push_back(&any_seen_);
  for (const Environment& set : minimal_hitting_sets(task, work, rule.complete))
    rule.evidence.push_back(
        evidence_of(set, units_.size() > listed_against ? Axioms{} : why_identified(entity, set)));
  return rule;
}

logic::Formula Possibilities::common(std::size_t behaviour) const {
  std::vector<logic::Formula> parts{logic::name(something_seen), !logic::name(conflict),
                                    !logic::name(unknown)};
  for (const Unit& unit : units_) {
    const auto prompts = unit.prompts.find(behaviour);
    const auto when = prompts == unit.prompts.end() ? logic::truth(false) : formula_of(prompts->second);
    parts.push_back(!is_candidate(unit) || when);
  }
  return logic::all_of(std::move(parts));
}

logic::Formula Possibilities::brave(std::size_t behaviour) const {
  std::vector<logic::Formula> cases;
  for (const Unit& unit : units_)
    if (const auto prompts = unit.prompts.find(behaviour); prompts != unit.prompts.end())
      cases.push_back(is_candidate(unit) && formula_of(prompts->second));
  return logic::name(something_seen) && logic::any_of(std::move(cases));
}

logic::Formula Possibilities::nothing_fits() const {
  return logic::name(conflict) || logic::name(unknown);
}

}  // namespace heed::awareness
