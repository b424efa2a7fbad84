#include "saturation.h"

#include <algorithm>

namespace heed::dl {
namespace {

std::uint64_t link_key(const Link& edge) {
  return (std::uint64_t{edge.role} << 32) | edge.other;
}

std::vector<Concept> united(const std::vector<Concept>& a, const std::vector<Concept>& b) {
  std::vector<Concept> out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

}  // namespace

void Saturation::link(ContextId id, Role role, ContextId target, Fact fact) {
  if (!is_own(id)) return;
  Context& x = own(id);
  const Link edge{role, target, fact};
  const auto key_at = [&](std::uint32_t i) { return link_key(x.successors[i]); };
  if (x.successor_places.find(link_key(edge), x.successors.size(), key_at) != IndexSet::none) return;
  x.successors.push_back(edge);
  x.successor_places.added(x.successors.size(), key_at);
  queue_.push_back({id, static_cast<std::uint32_t>(x.successors.size() - 1), true});
}

void Saturation::process_link(ContextId id, std::uint32_t where) {
  Context& x = own(id);
  if (x.unsatisfiable) return;
  const Link edge = x.successors[where];
  if (is_own(edge.other)) own(edge.other).predecessors.push_back({edge.role, id, edge.fact});
  if (x.nonempty) make_nonempty(edge.other);
  link_rules(id, edge);
  if (is_known(edge.role)) compose(id, edge);
  if (!x.universals.empty()) apply_universals(id, edge);
  if (!x.at_most_one.empty() || (is_known(edge.role) && theory_.has_functional(edge.role)))
    merge_functional(id, edge);
}

void Saturation::link_rules(ContextId id, const Link& edge) {
  const Context& k = at(edge.other);
  if (k.unsatisfiable) derive(id, bottom, edge.fact, fact_of(edge.other, bottom), 0);
  for (std::size_t i = 0; i < k.fillers.size(); ++i) {
    const Concept filler = k.fillers[i];
    for (const LeftExistential& rule : theory_.left(filler))
      if (is_subrole(edge.role, rule.role))
        derive(id, rule.existential, edge.fact, fact_of(edge.other, filler),
               trace_ ? why(0, edge.role, rule.role) : 0);
  }
  for (std::size_t i = 0; i < k.universals.size(); ++i)
    universal_backwards({edge.role, id, edge.fact}, Universal(k.universals[i]));
  if (!is_known(edge.role)) return;
  for (const Role super : theory_.superroles(edge.role))
    for (const Told& domain : theory_.domains(super))
      derive(id, domain.super, edge.fact, no_fact, trace_ ? why(domain.reason, edge.role, super) : 0);
}

void Saturation::compose(ContextId id, const Link& edge) {
  const auto reasons = [&](const Chain& chain, Role first, Role second) {
    if (!trace_) return 0U;
    std::vector<Reason> all = path(first, chain.first);
    const auto more = path(second, chain.second);
    all.insert(all.end(), more.begin(), more.end());
    all.push_back(chain.reason);
    return keep_why(std::move(all));
  };
  for (const Chain& chain : theory_.chains_from(edge.role)) {
    const Context& k = at(edge.other);
    for (std::size_t i = 0; i < k.successors.size(); ++i) {
      const Link next = k.successors[i];
      if (is_subrole(next.role, chain.second))
        link(id, chain.super, next.other, infer(edge.fact, next.fact, reasons(chain, edge.role, next.role)));
    }
  }
  for (const Chain& chain : theory_.chains_into(edge.role)) {
    const Context& x = at(id);
    for (std::size_t i = 0; i < x.predecessors.size(); ++i) {
      const Link before = x.predecessors[i];
      if (is_subrole(before.role, chain.first))
        link(before.other, chain.super, edge.other,
             infer(before.fact, edge.fact, reasons(chain, before.role, edge.role)));
    }
  }
}

Concept Saturation::universal_concept(Role role, Concept filler) const {
  const ConceptNode wanted{ConceptKind::All, role, filler};
  const Concept mine = extra_ != nullptr ? extra_->find(wanted) : nothing_known;
  return mine != nothing_known ? mine : theory_.find(wanted);
}

/// \param back  The link to where \p u holds, seen from there: `other` is its source.
void Saturation::universal_backwards(const Link& back, const Universal& u) {
  const Role role = inverse(back.role);
  if (is_subrole(role, u.role))
    derive(back.other, u.filler, back.fact, u.fact, trace_ ? why(0, role, u.role) : 0);
  if (!is_known(u.role)) return;
  for (const Role through : theory_.transitive_below(u.role)) {
    const Concept onwards = universal_concept(through, u.filler);
    if (onwards == nothing_known || !is_subrole(role, through)) continue;
    Fact fact = u.fact;
    if (trace_ && through != u.role) fact = infer(fact, no_fact, why(0, through, u.role));
    derive(back.other, onwards, back.fact, fact,
           trace_ ? why(theory_.transitive(through), role, through) : 0);
  }
}

/// Moves the link to a context whose core has all that the universals of x say of it.
void Saturation::apply_universals(ContextId id, const Link& edge) {
  const Context& x = at(id);
  std::vector<Concept> missing;
  Fact fact = edge.fact;
  const auto need = [&](Concept c, const Universal& u, Role through, Reason transitive) {
    if (c == nothing_known || has(edge.other, c) ||
        std::find(missing.begin(), missing.end(), c) != missing.end())
      return;
    missing.push_back(c);
    if (!trace_) return;
    std::uint32_t reasons = why(transitive, edge.role, through);
    if (through != u.role) fact = infer(fact, no_fact, why(0, through, u.role));
    fact = infer(fact, u.fact, reasons);
  };
  for (std::size_t i = 0; i < x.universals.size(); ++i) {
    const Universal u = x.universals[i];
    if (is_subrole(edge.role, u.role)) need(u.filler, u, u.role, 0);
    if (!is_known(u.role)) continue;
    for (const Role through : theory_.transitive_below(u.role))
      if (is_subrole(edge.role, through))
        need(universal_concept(through, u.filler), u, through, theory_.transitive(through));
  }
  if (missing.empty()) return;
  std::sort(missing.begin(), missing.end());
  const ContextId target = context(united(at(edge.other).core, missing));
  link(id, edge.role, target, fact);
}

std::vector<Role> Saturation::functions_of(const Context& x, Role role) const {
  std::vector<Role> out;
  if (is_known(role))
    for (const Role super : theory_.superroles(role))
      if (theory_.functional(super) != nothing_known) out.push_back(super);
  for (const auto& [local, fact] : x.at_most_one)
    if (is_subrole(role, local)) out.push_back(local);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void Saturation::merge_functional(ContextId id, const Link& edge) {
  Context& x = own(id);
  Group merged{{edge.role}, functions_of(x, edge.role), at(edge.other).core, edge.fact};
  if (merged.functions.empty()) return;
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < x.groups.size(); ++i) {
    std::vector<Role> common;
    std::set_intersection(merged.functions.begin(), merged.functions.end(), x.groups[i].functions.begin(),
                          x.groups[i].functions.end(), std::back_inserter(common));
    if (!common.empty()) hit.push_back(i);
  }
  if (hit.empty()) {
    x.groups.push_back(std::move(merged));
    return;
  }
  if (hit.size() == 1) {
    const Group& group = x.groups[hit.front()];
    const bool includes =
        std::includes(group.core.begin(), group.core.end(), merged.core.begin(), merged.core.end()) &&
        std::includes(group.roles.begin(), group.roles.end(), merged.roles.begin(), merged.roles.end()) &&
        std::includes(group.functions.begin(), group.functions.end(), merged.functions.begin(),
                      merged.functions.end());
    if (includes) return;
  }
  absorb(id, std::move(merged), hit, edge);
}

/// Unites \p merged with the groups \p hit and links all their properties to the common successor.
void Saturation::absorb(ContextId id, Group merged, const std::vector<std::size_t>& hit, const Link& edge) {
  Context& x = own(id);
  std::vector<Reason> reasons;
  std::vector<Group> rest;
  for (std::size_t i = 0; i < x.groups.size(); ++i) {
    if (std::find(hit.begin(), hit.end(), i) == hit.end()) {
      rest.push_back(std::move(x.groups[i]));
      continue;
    }
    merged.core = united(merged.core, x.groups[i].core);
    merged.roles = united(merged.roles, x.groups[i].roles);
    merged.functions = united(merged.functions, x.groups[i].functions);
    if (trace_) merged.fact = infer(merged.fact, x.groups[i].fact, 0);
  }
  if (trace_) {
    for (const Role role : merged.roles)
      for (const Role function : merged.functions) {
        if (!is_subrole(role, function)) continue;
        const auto steps = path(role, function);
        reasons.insert(reasons.end(), steps.begin(), steps.end());
        if (is_known(function) && theory_.functional(function) != nothing_known)
          reasons.push_back(theory_.functional(function));
      }
    for (const auto& local : x.at_most_one) merged.fact = infer(merged.fact, local.second, 0);
    merged.fact = infer(merged.fact, edge.fact, keep_why(std::move(reasons)));
  }
  const std::vector<Role> roles = merged.roles;
  const Fact fact = merged.fact;
  const std::vector<Concept> core = merged.core;
  rest.push_back(std::move(merged));
  x.groups = std::move(rest);
  const ContextId target = context(core);
  for (const Role role : roles) link(id, role, target, fact);
}

std::uint32_t Saturation::keep_why(std::vector<Reason> reasons) {
  if (!trace_) return 0;
  std::sort(reasons.begin(), reasons.end());
  reasons.erase(std::unique(reasons.begin(), reasons.end()), reasons.end());
  if (!reasons.empty() && reasons.front() == 0) reasons.erase(reasons.begin());
  if (reasons.empty()) return 0;
  if (reasons.size() == 1) return reasons.front();
  why_sets_.push_back(std::move(reasons));
  return (first_why_ + static_cast<std::uint32_t>(why_sets_.size() - 1)) | (1U << 31);
}

std::uint32_t Saturation::why(Reason reason, Role sub, Role super) {
  std::vector<Reason> reasons = path(sub, super);
  reasons.push_back(reason);
  return keep_why(std::move(reasons));
}

/// The axioms of one shortest way from \p sub up to \p super.
std::vector<Reason> Saturation::path(Role sub, Role super) {
  if (sub == super || !is_known(sub)) return {};
  const auto known = paths_.find({sub, super});
  if (known != paths_.end()) return known->second;
  std::map<Role, std::pair<Role, Reason>> from = {{sub, {sub, 0}}};
  std::vector<Role> open = {sub};
  for (std::size_t i = 0; i < open.size() && from.find(super) == from.end(); ++i)
    for (const RoleEdge edge : theory_.role_edges(open[i]))
      if (from.try_emplace(edge.super, open[i], edge.reason).second) open.push_back(edge.super);
  std::vector<Reason> out;
  for (Role role = super; role != sub;) {
    const auto step = from.find(role);
    if (step == from.end()) break;
    out.push_back(step->second.second);
    role = step->second.first;
  }
  return paths_[{sub, super}] = out;
}

Fact Saturation::subrole_fact(Role sub, Role super) {
  return infer(no_fact, no_fact, why(0, sub, super));
}

std::vector<owl::AxiomId> Saturation::axioms_of(std::vector<Fact> facts) const {
  std::vector<bool> seen(first_fact_ + inferences_.size());
  std::vector<owl::AxiomId> out;
  while (!facts.empty()) {
    const Fact fact = facts.back();
    facts.pop_back();
    if (fact == no_fact || seen[fact]) continue;
    seen[fact] = true;
    const Inference& step = fact < first_fact_ ? base_->inferences_[fact] : inferences_[fact - first_fact_];
    facts.push_back(step.first);
    facts.push_back(step.second);
    if (step.why == 0) continue;
    if (step.why >> 31 == 0) {
      out.push_back({step.why});
      continue;
    }
    const std::uint32_t set = step.why & ~(1U << 31);
    for (const Reason reason : set < first_why_ ? base_->why_sets_[set] : why_sets_[set - first_why_])
      out.push_back({reason});
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace heed::dl
