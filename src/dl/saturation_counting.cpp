#include "saturation.h"

// Minimum cardinalities on the left. Contexts are apart when they are in different members of one group of
// disjoint classes or different individuals: a sufficient sign that costs nothing to look for.

namespace heed::dl {

std::optional<Fact> Saturation::apart(ContextId a, ContextId b) {
  const Context& x = at(a);
  const Context& y = at(b);
  for (const auto& [group, mine] : x.memberships)
    for (const auto& [other_group, other] : y.memberships) {
      if (group != other_group || mine == other) continue;
      Reason reason = 0;
      for (const Membership& membership : theory_.groups(mine))
        if (membership.group == group) reason = membership.reason;
      return infer(fact_of(a, mine), fact_of(b, other), reason);
    }
  return std::nullopt;
}

std::optional<Fact> Saturation::distinct_successors(ContextId id, Role role, Concept filler,
                                                    std::uint32_t n) {
  std::vector<ContextId> chosen;
  Fact fact = no_fact;
  for (const Link& edge : std::vector<Link>(at(id).successors)) {
    if (!is_subrole(edge.role, role) || (filler != top && !has(edge.other, filler))) continue;
    std::vector<Fact> reasons;
    for (const ContextId other : chosen)
      if (const auto why_apart = apart(edge.other, other)) reasons.push_back(*why_apart);
    if (reasons.size() < chosen.size()) continue;
    chosen.push_back(edge.other);
    if (trace_) {
      fact = infer(fact, edge.fact, why(0, edge.role, role));
      fact = infer(fact, fact_of(edge.other, filler), 0);
      for (const Fact reason : reasons) fact = infer(fact, reason, 0);
    }
    if (chosen.size() == n) return fact;
  }
  return std::nullopt;
}

bool Saturation::count_successors(ContextId id, Concept at_least) {
  const ConceptNode wanted = theory_.node(at_least);
  const ConceptNode some = theory_.node(wanted.a);
  const auto fact = distinct_successors(id, some.a, some.b, wanted.b);
  if (fact) derive(id, at_least, *fact, no_fact, 0);
  return fact.has_value();
}

/// Once over all contexts, since neither links nor memberships tell whom they make countable.
bool Saturation::count_successors() {
  bool found = false;
  if (theory_.counted().empty()) return found;
  for (ContextId id = first_; id < first_ + contexts_.size(); ++id) {
    if (at(id).unsatisfiable || at(id).successors.size() < 2) continue;
    budget_.check();
    for (const Concept at_least : theory_.counted())
      if (!has(id, at_least)) found |= count_successors(id, at_least);
  }
  return found;
}

}  // namespace heed::dl
