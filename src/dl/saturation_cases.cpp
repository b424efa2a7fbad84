#include "saturation.h"

#include <algorithm>

// Reasoning by cases and by refutation, as far as it is cheap. A supposition is a context of its own, whose
// core has one concept more; whatever follows there follows from the supposition. Caps on how many there may
// be make it cheap and incomplete; they count work, so that the same input gives the same answer.

namespace heed::dl {
namespace {

/// Suppositions on suppositions, and all together: enough for definitions that people write.
constexpr std::uint8_t most_nested = 2;
constexpr std::size_t most_suppositions = 20'000;
constexpr std::size_t most_of_a_question = 500;
constexpr std::size_t most_cases = 24;

}  // namespace

/// The context of the things of \p x that are \p c; nothing_known when that looks too far ahead.
ContextId Saturation::supposed(ContextId id, Concept c) {
  const Context& x = own(id);
  const std::size_t most = base_ == nullptr ? most_suppositions : most_of_a_question;
  if (x.supposed >= most_nested || suppositions_ >= most) return nothing_known;
  std::vector<Concept> core = x.core;
  core.insert(std::upper_bound(core.begin(), core.end(), c), c);
  const auto nested = static_cast<std::uint8_t>(x.supposed + 1);
  const std::size_t before = contexts_.size();
  const ContextId out = context(std::move(core));
  if (contexts_.size() > before) {
    ++suppositions_;
    own(out).supposed = nested;
  }
  return out;
}

void Saturation::split(ContextId id, Concept c, Fact fact) {
  std::vector<Concept> alternatives;
  std::vector<Concept> open = {c};
  while (!open.empty()) {
    const Concept next = open.back();
    open.pop_back();
    const ConceptNode n = node(next);
    if (n.kind == ConceptKind::Or) {
      open.push_back(n.b);
      open.push_back(n.a);
    } else if (has(id, next)) {
      return;
    } else {
      alternatives.push_back(next);
    }
  }
  if (alternatives.size() > most_cases) return;
  Split out{id, fact, {}};
  for (const Concept alternative : alternatives) {
    const ContextId one = supposed(id, alternative);
    if (one == nothing_known) return;
    out.cases.push_back(one);
  }
  const auto place = static_cast<std::uint32_t>(splits_.size());
  for (const ContextId one : out.cases)
    if (is_own(one)) own(one).cases.push_back(place);
  splits_.push_back(std::move(out));
  settle_all(splits_[place]);
}

/// Gives the whole what all possible cases have.
void Saturation::settle(const Split& given, Concept c) {
  const auto agrees = [&](ContextId one) { return at(one).unsatisfiable || has(one, c); };
  if (has(given.whole, c) || !std::all_of(given.cases.begin(), given.cases.end(), agrees)) return;
  Fact fact = given.fact;
  if (trace_)
    for (const ContextId one : given.cases)
      fact = infer(fact, fact_of(one, at(one).unsatisfiable ? bottom : c), 0);
  derive(given.whole, c, fact, no_fact, 0);
}

void Saturation::settle_all(const Split& given) {
  const auto possible = std::find_if(given.cases.begin(), given.cases.end(),
                                     [&](ContextId one) { return !at(one).unsatisfiable; });
  if (possible == given.cases.end()) return settle(given, bottom);
  for (std::size_t i = 0; i < at(*possible).subsumers.size(); ++i) settle(given, at(*possible).subsumers[i]);
}

void Saturation::cases_process(ContextId id, Concept c) {
  for (std::size_t i = 0; i < own(id).cases.size(); ++i) settle(splits_[own(id).cases[i]], c);
}

void Saturation::cases_bottom(ContextId id) {
  for (std::size_t i = 0; i < own(id).cases.size(); ++i) settle_all(splits_[own(id).cases[i]]);
  const Fact fact = fact_of(id, bottom);
  for (std::size_t i = 0; i < own(id).tests.size(); ++i) {
    const Trial& trial = trials_[own(id).tests[i]];
    derive(trial.whole, trial.goal, fact, no_fact, 0);
  }
}

/// Tries whether all things of \p id are \p goal.
void Saturation::aim(ContextId id, Concept goal) {
  const Concept denied = theory_.denied(goal);
  if (has(id, goal) || has(id, denied)) return;
  const ContextId refuted = supposed(id, denied);
  if (refuted == nothing_known) return;
  if (at(refuted).unsatisfiable) return derive(id, goal, fact_of(refuted, bottom), no_fact, 0);
  if (!is_own(refuted)) return;
  own(refuted).tests.push_back(static_cast<std::uint32_t>(trials_.size()));
  trials_.push_back({id, refuted, goal});
}

}  // namespace heed::dl
