#include "saturation.h"

#include <algorithm>

namespace heed::dl {

std::size_t Saturation::CoreHash::operator()(const std::vector<Concept>& core) const {
  std::uint64_t hash = core.size();
  for (const Concept c : core) hash = util::mix(hash, c);
  return hash;
}

Saturation::Saturation(const Theory& theory, util::Budget& budget, bool trace)
    : theory_(theory), budget_(budget), trace_(trace), targets_(theory.size(), nothing_known) {}

Saturation::Saturation(const Saturation& base, const ExtraTheory& extra, util::Budget& budget)
    : theory_(base.theory_),
      base_(&base),
      extra_(&extra),
      budget_(budget),
      trace_(base.trace_),
      first_(static_cast<ContextId>(base.contexts_.size())),
      first_fact_(static_cast<Fact>(base.inferences_.size())),
      first_why_(static_cast<std::uint32_t>(base.why_sets_.size())) {}

ContextId Saturation::context(std::vector<Concept> core) {
  if (core.size() > 1) core.erase(std::remove(core.begin(), core.end(), top), core.end());
  if (core.empty()) core.push_back(top);
  if (base_ != nullptr)
    if (const auto known = base_->cores_.find(core); known != base_->cores_.end()) return known->second;
  const auto [entry, is_new] =
      cores_.try_emplace(std::move(core), first_ + static_cast<ContextId>(contexts_.size()));
  if (!is_new) return entry->second;
  const ContextId id = entry->second;
  contexts_.emplace_back();
  contexts_.back().core = entry->first;
  derive(id, top, no_fact, no_fact, 0);
  for (const Concept c : entry->first) derive(id, c, no_fact, no_fact, 0);
  return id;
}

ContextId Saturation::nonempty_context(Concept core) {
  const ContextId id = context({core});
  make_nonempty(id);
  return id;
}

void Saturation::run() {
  do drain();
  while (count_successors());
}

void Saturation::drain() {
  for (std::size_t steps = 0; next_ < queue_.size(); ++steps) {
    if (steps % 256 == 0) budget_.check();
    const Item item = queue_[next_++];
    if (item.is_link)
      process_link(item.context, item.place);
    else
      process_subsumer(item.context, item.place);
    if (next_ > 65536 && next_ * 2 > queue_.size()) {
      queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(next_));
      next_ = 0;
    }
  }
  queue_.clear();
  next_ = 0;
}

bool Saturation::is_subrole(Role sub, Role super) const {
  return sub == super || (is_known(sub) && is_known(super) && theory_.is_subrole(sub, super));
}

Fact Saturation::fact_of(ContextId id, Concept c) const {
  const std::uint32_t where = place(at(id), c);
  return trace_ && where != IndexSet::none ? at(id).facts[where] : no_fact;
}

Fact Saturation::infer(Fact first, Fact second, std::uint32_t why) {
  if (!trace_) return no_fact;
  inferences_.push_back({first, second, why});
  return first_fact_ + static_cast<Fact>(inferences_.size() - 1);
}

void Saturation::derive(ContextId id, Concept c, Fact first, Fact second, std::uint32_t why) {
  if (!is_own(id)) return;
  Context& x = own(id);
  if (place(x, c) != IndexSet::none) return;
  x.subsumers.push_back(c);
  x.places.added(x.subsumers.size(), [&](std::uint32_t i) { return x.subsumers[i]; });
  if (trace_) x.facts.push_back(infer(first, second, why));
  queue_.push_back({id, static_cast<std::uint32_t>(x.subsumers.size() - 1), false});
}

void Saturation::process_subsumer(ContextId id, std::uint32_t where) {
  Context& x = own(id);
  const Concept c = x.subsumers[where];
  const Fact fact = trace_ ? x.facts[where] : no_fact;
  if (x.unsatisfiable) return;
  if (c == bottom) return process_bottom(id, fact);
  if (!x.cases.empty()) cases_process(id, c);
  if (c < theory_.size()) {
    for (const Told& told : theory_.told(c)) derive(id, told.super, fact, no_fact, told.reason);
    for (const Conjunction& rule : theory_.conjunctions(c)) {
      const std::uint32_t other = place(x, rule.other);
      if (other != IndexSet::none) derive(id, rule.result, fact, trace_ ? x.facts[other] : no_fact, 0);
    }
    for (const Concept goal : theory_.goals(c)) aim(id, goal);
    check_groups(id, c, fact);
    if (!theory_.left(c).empty()) {
      x.fillers.push_back(c);
      for (std::size_t i = 0; i < x.predecessors.size(); ++i) {
        const Link edge = x.predecessors[i];
        for (const LeftExistential& rule : theory_.left(c))
          if (is_subrole(edge.role, rule.role))
            derive(edge.other, rule.existential, edge.fact, fact, trace_ ? why(0, edge.role, rule.role) : 0);
      }
    }
  }
  if (extra_ != nullptr) check_negations(id, c, fact);
  decompose(id, c, fact);
  for (std::size_t i = 0; i < x.mirrors.size(); ++i) {
    const ContextId individual = x.mirrors[i];
    Context& y = own(individual);
    const std::size_t before = y.subsumers.size();
    derive(individual, c, fact, fact_of(id, y.core.front()), 0);
    if (y.subsumers.size() == before) continue;
    y.mirrored.push_back(c);
    for (const ContextId follower : y.followers)
      derive(follower, c, fact_of(individual, c), fact_of(follower, y.core.front()), 0);
  }
}

void Saturation::process_bottom(ContextId id, Fact fact) {
  Context& x = own(id);
  x.unsatisfiable = true;
  if (x.nonempty && !inconsistent_) {
    inconsistent_ = true;
    inconsistency_ = fact;
  }
  for (const Link& edge : x.predecessors) derive(edge.other, bottom, edge.fact, fact, 0);
  cases_bottom(id);
}

/// What a concept on the right says by itself. For one that only stands on the left nothing is done: it was
/// derived from what this would give.
void Saturation::decompose(ContextId id, Concept c, Fact fact) {
  const ConceptNode n = node(c);
  if (c < theory_.size() && !n.right && n.kind != ConceptKind::Individual) return;
  switch (n.kind) {
    case ConceptKind::And:
      derive(id, n.a, fact, no_fact, 0);
      return derive(id, n.b, fact, no_fact, 0);
    case ConceptKind::Some:
      return existential(id, c, fact);
    case ConceptKind::AtLeast:
      return derive(id, n.a, fact, no_fact, 0);
    case ConceptKind::Or:
      return split(id, c, fact);
    case ConceptKind::Self:
      return self(id, n.a, fact);
    case ConceptKind::Individual:
      return nominal(id, c, fact);
    case ConceptKind::All: {
      Context& x = own(id);
      x.universals.push_back({n.a, n.b, fact});
      for (std::size_t i = 0; i < x.successors.size(); ++i) apply_universals(id, Link(x.successors[i]));
      for (std::size_t i = 0; i < x.predecessors.size(); ++i)
        universal_backwards(Link(x.predecessors[i]), Universal(x.universals.back()));
      return;
    }
    case ConceptKind::AtMostOne: {
      Context& x = own(id);
      x.at_most_one.emplace_back(n.a, fact);
      for (std::size_t i = 0; i < x.successors.size(); ++i) merge_functional(id, Link(x.successors[i]));
      return;
    }
    default:
      return;
  }
}

void Saturation::check_groups(ContextId id, Concept c, Fact fact) {
  Context& x = own(id);
  for (const Membership& mine : theory_.groups(c)) {
    for (const auto& [group, other] : x.memberships)
      if (group == mine.group && other != c) derive(id, bottom, fact, fact_of(id, other), mine.reason);
    x.memberships.emplace_back(mine.group, c);
  }
}

void Saturation::check_negations(ContextId id, Concept c, Fact fact) {
  for (const auto& [positive, negative] : extra_->negations()) {
    if (c != positive && c != negative) continue;
    const Concept other = c == positive ? negative : positive;
    if (has(id, other)) derive(id, bottom, fact, fact_of(id, other), 0);
  }
}

void Saturation::existential(ContextId id, Concept c, Fact fact) {
  const ConceptNode n = node(c);
  const bool keep = base_ == nullptr;
  ContextId target = keep ? targets_[c] : nothing_known;
  std::vector<Reason> reasons;
  if (target == nothing_known || trace_) {
    std::vector<Concept> core = {n.b};
    if (is_known(n.a))
      for (const Role super : theory_.superroles(n.a))
        for (const Told& range : theory_.ranges(super)) {
          core.push_back(range.super);
          if (!trace_) continue;
          const auto steps = path(n.a, super);
          reasons.insert(reasons.end(), steps.begin(), steps.end());
          reasons.push_back(range.reason);
        }
    std::sort(core.begin(), core.end());
    core.erase(std::unique(core.begin(), core.end()), core.end());
    target = context(std::move(core));
    if (keep) targets_[c] = target;
  }
  link(id, n.a, target, reasons.empty() ? fact : infer(fact, no_fact, keep_why(std::move(reasons))));
}

void Saturation::self(ContextId id, Role role, Fact fact) {
  link(id, role, id, fact);
  if (!is_known(role)) return;
  for (const Role super : theory_.superroles(role))
    for (const Told& range : theory_.ranges(super))
      derive(id, range.super, fact, no_fact, trace_ ? why(range.reason, role, super) : 0);
}

void Saturation::nominal(ContextId id, Concept c, Fact fact) {
  const ContextId individual = context({c});
  if (individual == id) return;
  if (is_own(individual)) own(individual).followers.push_back(id);
  const Context& y = at(individual);
  for (std::size_t i = 0; i < y.mirrored.size(); ++i)
    derive(id, y.mirrored[i], fact_of(individual, y.mirrored[i]), fact, 0);
  if (at(id).nonempty) mirror(id, individual, fact);
}

void Saturation::mirror(ContextId id, ContextId individual, Fact nominal_fact) {
  if (!is_own(id) || !is_own(individual)) return;
  Context& x = own(id);
  if (std::find(x.mirrors.begin(), x.mirrors.end(), individual) != x.mirrors.end()) return;
  x.mirrors.push_back(individual);
  Context& y = own(individual);
  for (std::size_t i = 0; i < x.subsumers.size(); ++i) {
    const Concept c = x.subsumers[i];
    const std::size_t before = y.subsumers.size();
    derive(individual, c, fact_of(id, c), nominal_fact, 0);
    if (y.subsumers.size() == before) continue;
    y.mirrored.push_back(c);
    for (const ContextId follower : y.followers)
      derive(follower, c, fact_of(individual, c), fact_of(follower, y.core.front()), 0);
  }
}

void Saturation::make_nonempty(ContextId first) {
  std::vector<ContextId> open = {first};
  while (!open.empty()) {
    const ContextId id = open.back();
    open.pop_back();
    if (!is_own(id) || own(id).nonempty) continue;
    Context& x = own(id);
    x.nonempty = true;
    if (x.unsatisfiable && !inconsistent_) {
      inconsistent_ = true;
      inconsistency_ = fact_of(id, bottom);
    }
    for (const Link& edge : x.successors) open.push_back(edge.other);
    for (std::size_t i = 0; i < x.subsumers.size(); ++i) {
      const Concept c = x.subsumers[i];
      if (node(c).kind != ConceptKind::Individual) continue;
      const ContextId individual = context({c});
      if (individual != id) mirror(id, individual, fact_of(id, c));
    }
  }
}

}  // namespace heed::dl
