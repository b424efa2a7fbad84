#include "builder.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {
namespace {

std::string quoted(const std::string& s) {
  return "'" + s + "'";
}

std::string enumerate(const std::vector<std::string>& items) {
  if (items.size() < 2) return items.empty() ? "nothing" : items.front();
  const std::vector<std::string> head(items.begin(), items.end() - 1);
  return fmt::format("{} and {}", fmt::join(head, ", "), items.back());
}

}  // namespace

void Builder::warn(std::string code, std::string message, Axioms axioms, std::vector<std::size_t> entities) {
  catalogue_.warnings.push_back(
      {std::move(code), std::move(message), std::move(axioms), std::move(entities)});
}

/// Of the entities that cannot exist the one from which it follows that \p entity cannot: its axioms are some
/// of those of \p entity. Nothing for a root cause.
std::optional<std::size_t> Builder::impossible_because_of(std::size_t entity) const {
  const Axioms& all = catalogue_.entities[entity].impossible;
  std::optional<std::size_t> cause;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    const Axioms& some = catalogue_.entities[e].impossible;
    if (catalogue_.entities[e].satisfiable || some.size() >= all.size()) continue;
    if (!std::includes(all.begin(), all.end(), some.begin(), some.end())) continue;
    if (!cause || some.size() < catalogue_.entities[*cause].impossible.size()) cause = e;
  }
  return cause;
}

/// Root causes first: what follows from them goes with them.
void Builder::warn_unsatisfiable() {
  std::vector<std::size_t> found;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    Entity& entity = catalogue_.entities[e];
    if (entity.satisfiable) continue;
    entity.impossible = justifier_.unsatisfiable(owl::ClassExpression::named(entity.iri)).value_or(Axioms{});
    found.push_back(e);
  }
  std::stable_partition(found.begin(), found.end(),
                        [&](std::size_t e) { return !impossible_because_of(e).has_value(); });
  for (const std::size_t e : found) {
    const auto cause = impossible_because_of(e);
    warn("unsatisfiable-entity",
         fmt::format("Nothing can be a '{}': what the ontology says of it contradicts itself, so it will "
                     "never be recognised and every statement about it holds emptily.{}",
                     label(e),
                     cause ? fmt::format(" This follows from what is said of '{}'.", label(*cause)) : ""),
         catalogue_.entities[e].impossible, {e});
  }
}

/// Behaviours of \p entity along what single axioms state: what its authors could see.
std::set<std::size_t> Builder::told_behaviours(std::size_t entity) const {
  std::set<std::size_t> result;
  for (const auto& [holder, why] : told_.concepts.above(catalogue_.entities[entity].iri))
    if (const auto bindings = told_.bindings.find(holder); bindings != told_.bindings.end())
      for (const Binding& binding : bindings->second)
        if (const auto b = behaviour_index_.find(binding.filler);
            b != behaviour_index_.end() && role_counts(binding.role, action_roles_)) {
          result.insert(b->second);
          for (const Entailed& up : catalogue_.behaviours[b->second].general) result.insert(up.index);
        }
  return result;
}

/// Who prescribes what only because \p entity is below \p ancestor.
std::string Builder::gained_behaviours(std::size_t entity, std::size_t ancestor) const {
  const auto offered = told_behaviours(ancestor);
  std::map<std::string, std::vector<std::string>> gained;
  for (std::size_t d = 0; d < catalogue_.entities.size(); ++d) {
    if (d != entity && catalogue_.is_below(d, entity) == nullptr) continue;
    if (d == ancestor || !catalogue_.entities[d].satisfiable) continue;
    const auto own = told_behaviours(d);
    for (const std::size_t b : offered)
      if (!own.contains(b) && catalogue_.prescribes(d, b) != nullptr &&
          told_.concepts.path(catalogue_.entities[d].iri, catalogue_.entities[ancestor].iri) == std::nullopt)
        gained[quoted(catalogue_.behaviours[b].label)].push_back(quoted(label(d)));
  }
  std::string text;
  for (const auto& [behaviour, who] : gained)
    text += fmt::format(" So {} {} {}, which nobody wrote.", enumerate(who),
                        who.size() == 1 ? "prescribes" : "prescribe", behaviour);
  return text;
}

/// Only the outermost pairs: what follows from an unasserted subsumption by asserted ones is not repeated.
void Builder::warn_subsumptions() {
  const auto& entities = catalogue_.entities;
  std::vector<std::map<owl::Iri, Axioms>> told_above;
  told_above.reserve(entities.size());
  for (const Entity& entity : entities) told_above.push_back(told_.concepts.above(entity.iri));
  const auto told = [&](std::size_t d, std::size_t e) { return told_above[d].contains(entities[e].iri); };
  for (std::size_t d = 0; d < entities.size(); ++d)
    for (const Entailed& up : entities[d].ancestors) {
      if (!entities[d].satisfiable || told(d, up.index)) continue;
      const bool inner =
          std::any_of(entities[d].ancestors.begin(), entities[d].ancestors.end(), [&](const Entailed& x) {
            if (x.index == up.index) return false;
            const bool by_parent =
                told(d, x.index) && !told(x.index, d) && catalogue_.is_below(x.index, up.index);
            const bool by_child = !told(d, x.index) && told(x.index, up.index) && !told(up.index, x.index);
            return by_parent || by_child;
          });
      if (inner) continue;
      const bool equivalent = catalogue_.is_below(up.index, d) != nullptr;
      if (equivalent && !told(up.index, d) && up.index < d) continue;
      const std::string what =
          equivalent
              ? fmt::format("'{}' and '{}' are the same thing to a reasoner, although nobody wrote so.",
                            label(d), label(up.index))
              : fmt::format("Every '{}' is taken for a '{}', although nobody wrote so.", label(d),
                            label(up.index));
      warn(equivalent ? "unasserted-equivalence" : "unasserted-subsumption",
           what + gained_behaviours(d, up.index), up.axioms, {d, up.index});
    }
}

void Builder::warn_no_prescription(std::size_t entity) {
  warn("no-prescription", fmt::format("'{}' prescribes nothing.", label(entity)), {}, {entity});
  catalogue_.warnings.back().hint =
      "where that is not meant, say what it prescribes, or what it is a kind of";
}

void Builder::warn_conflicts() {
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    const Entity& entity = catalogue_.entities[e];
    if (entity.is_leaf() && entity.behaviours.empty() && entity.satisfiable) warn_no_prescription(e);
    for (const Entailed& a : entity.behaviours)
      for (const Entailed& b : entity.behaviours) {
        if (a.index >= b.index) continue;
        // Two individuals that differ are two names, not two deeds that exclude each other.
        if (catalogue_.behaviours[a.index].individual && catalogue_.behaviours[b.index].individual) continue;
        const auto apart =
            concepts_apart(catalogue_.behaviours[a.index].iri, catalogue_.behaviours[b.index].iri);
        const bool inherited =
            std::any_of(entity.ancestors.begin(), entity.ancestors.end(), [&](const Entailed& up) {
              return catalogue_.prescribes(up.index, a.index) != nullptr &&
                     catalogue_.prescribes(up.index, b.index) != nullptr;
            });
        if (!apart || inherited) continue;
        warn("conflicting-prescriptions",
             fmt::format("'{}' prescribes both '{}' and '{}', which exclude each other.", entity.label,
                         catalogue_.behaviours[a.index].label, catalogue_.behaviours[b.index].label),
             join(join(a.axioms, b.axioms), *apart), {e});
      }
  }
}

void Builder::warn_never_recognised() {
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    const Entity& entity = catalogue_.entities[e];
    if (!entity.satisfiable || entity.sufficiency != Sufficiency::Never) continue;
    Axioms axioms;
    std::vector<std::string> features;
    for (const Entailed& has : catalogue_.described(e)) {
      axioms = join(axioms, has.axioms);
      features.push_back(quoted(catalogue_.features[has.index].label));
    }
    const std::string message =
        features.empty()
            ? fmt::format("'{}' is never recognised: the ontology says nothing perceivable of it.",
                          entity.label)
            : fmt::format(
                  "'{}' is never recognised: every such thing has {}, but nothing says that whatever has "
                  "these is "
                  "one. Define it (EquivalentTo), or say that its description is sufficient.",
                  entity.label, enumerate(features));
    warn("never-recognised", message, axioms, {e});
  }
}

void Builder::warn_indistinguishable() {
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> groups;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    if (!catalogue_.entities[e].is_leaf() || !catalogue_.entities[e].satisfiable) continue;
    std::vector<std::size_t> features;
    for (const Entailed& has : catalogue_.described(e)) features.push_back(has.index);
    if (!features.empty()) groups[features].push_back(e);
  }
  for (const auto& [features, members] : groups) {
    if (members.size() < 2) continue;
    Axioms axioms;
    std::vector<std::string> names;
    std::set<std::vector<std::size_t>> reactions;
    for (const std::size_t e : members) {
      names.push_back(quoted(label(e)));
      for (const Entailed& has : catalogue_.described(e)) axioms = join(axioms, has.axioms);
      std::vector<std::size_t> acts;
      for (const Entailed& act : catalogue_.entities[e].behaviours) acts.push_back(act.index);
      reactions.insert(acts);
    }
    warn("indistinguishable",
         fmt::format("{} have the same features and can never be told apart{}.", enumerate(names),
                     reactions.size() > 1 ? ", although they prescribe different behaviours" : ""),
         axioms, members);
  }
}

/// The half that is there: why the role has one value, or that its values are disjoint.
Axioms Builder::half_exclusive(const std::set<std::size_t>& members) {
  const Feature& first = catalogue_.features[*members.begin()];
  if (!first.functional.empty()) return first.functional;
  for (const std::size_t f : members)
    for (const std::size_t g : members)
      if (f < g)
        if (auto apart = concepts_apart(catalogue_.features[f].filler, catalogue_.features[g].filler))
          return *std::move(apart);
  return {};
}

void Builder::warn_excludes_nothing() {
  std::map<owl::Iri, std::set<std::size_t>> by_role;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
    for (const Entailed& has : catalogue_.described(e))
      if (catalogue_.features[has.index].kind != Feature::Kind::Class)
        by_role[catalogue_.features[has.index].role].insert(has.index);
  for (const auto& [role, members] : by_role) {
    if (members.size() < 2) continue;
    std::vector<std::string> idle;
    for (const std::size_t f : members) {
      const bool excludes = std::any_of(members.begin(), members.end(), [&](std::size_t g) {
        return catalogue_.exclusive.contains({std::min(f, g), std::max(f, g)});
      });
      if (!excludes) idle.push_back(quoted(catalogue_.features[f].label));
    }
    if (idle.empty()) continue;
    const bool functional = !catalogue_.features[*members.begin()].functional.empty();
    warn("excludes-nothing",
         fmt::format("Seeing {} never rules anything out: {}, so no candidate ever falls away by it.",
                     enumerate(idle),
                     functional ? "nothing is declared disjoint with it"
                                : fmt::format("nothing says that a thing has at most one value of '{}'",
                                              label_of(role))),
         half_exclusive(members), {});
    catalogue_.warnings.back().hint =
        functional
            ? fmt::format("where it is so, declare the values of '{}' disjoint", label_of(role))
            : fmt::format("where it is so, declare '{}' functional, and its values disjoint", label_of(role));
  }
}

void Builder::warn_unused() {
  std::set<owl::Iri> used;
  for (const Entity& entity : catalogue_.entities)
    for (const Entailed& has : entity.features)
      for (const auto& [up, why] : above_filler(catalogue_.features[has.index].filler)) used.insert(up);
  std::vector<std::string> unused;
  Axioms why;
  for (const owl::Iri filler : features_.members) {
    const bool root =
        std::find(features_.roots.begin(), features_.roots.end(), filler) != features_.roots.end();
    if (root || used.contains(filler) || entities_.contains(filler)) continue;
    unused.push_back(quoted(label_of(filler)));
    for (const owl::Iri up : features_.roots)
      if (const auto above = above_filler(filler).find(up); above != above_filler(filler).end())
        why = join(why, above->second);
  }
  if (unused.empty()) return;
  warn("unused-feature",
       fmt::format("No entity is described by {}: reporting it changes nothing.", enumerate(unused)), why,
       {});
  catalogue_.warnings.back().hint = "describe an entity by it, or leave it out of what is perceived";
}

}  // namespace heed::awareness
