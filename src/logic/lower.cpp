// From LTL to the parts of GR(1). An obligation says: whenever its trigger (a local formula) holds, one of
// its disjuncts holds from there on. Each step takes an obligation apart by one law; in the end only local
// formulas are left, to hold always or again and again. The usual way, a deterministic Buechi automaton per
// requirement, loses the names that the user gave, and is exponential where these laws give one monitor per
// operator. \cite manna.90.podc

#include <heed/logic/lower.h>

#include "local.h"
#include "normal_form.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace heed::logic {
namespace {

struct Obligation {
  Formula trigger;  ///< Local.
  bool single;      ///< The trigger holds at most once in any run.
  std::vector<Formula> disjuncts;
};

/// Local formulas; `initial` hold at the first step.
struct Parts {
  std::vector<Formula> initial, safety, justice;
};

/// The disjuncts of an obligation by kind, after its local ones went into the trigger.
struct Kinds {
  std::vector<Formula> repeated;  ///< b of G F b
  std::vector<Formula> eventual;  ///< b of F b
  std::vector<Formula> weak;      ///< a W b, and G a
};

class Lowering {
 public:
  explicit Lowering(std::size_t most) : most_(most) {}

  Parts lower(Obligation obligation, std::size_t depth = 0);
  Formula normal_form(const Formula& formula) { return negation_normal_form(formula, locality_); }

 private:
  using Open = std::vector<Obligation>;
  struct Step {
    Open& open;
    Parts& parts;
    std::size_t depth;
  };

  void take_apart(Obligation obligation, Step step);
  bool flatten(Obligation& obligation);
  bool split_conjunction(const Obligation& obligation, Step step);
  bool split_local(Obligation& obligation, Step step);
  bool look_back_from_end(const Obligation& obligation, Step step);
  bool unroll_next(const Obligation& obligation, Step step);
  bool split_until(const Obligation& obligation, Step step);
  void handle_kinds(const Obligation& obligation, Step step);
  void handle_repeated(const Obligation& obligation, const Kinds& kinds, Step step);
  void handle_eventual(const Obligation& obligation, const Formula& goal, Step step);
  void handle_weak(const Obligation& obligation, const Kinds& kinds, Step step);
  void handle_case_distinction(const Obligation& obligation, Step step);
  bool chain(const Obligation& obligation, const Formula& goal, Step step);
  [[nodiscard]] std::optional<Formula> chained_goal(const Formula& trigger, const Formula& goal);
  [[nodiscard]] bool all_local(const std::vector<Formula>& formulas);
  void push(Step step, Obligation obligation);

  Locality locality_;
  std::size_t most_;
  std::size_t count_ = 0;
};

bool is_first(const Formula& trigger) {
  return trigger == first_step();
}

/// Once it holds it holds for ever.
bool is_persistent(const Formula& trigger) {
  return trigger.is_true() || trigger.op() == Op::Once;
}

bool is_repeated(const Formula& formula) {
  return formula.op() == Op::Always && formula[0].op() == Op::Eventually;
}

/// "open and not yet closed": \p trigger held, and \p end has not since.
Formula pending(const Formula& trigger, const Formula& end) {
  if (end.is_false()) return once(trigger);
  return since(!end, trigger && !end);
}

void Lowering::push(Step step, Obligation obligation) {
  if (++count_ > most_) refuse(any_of(obligation.disjuncts), "it splits into too many cases");
  step.open.push_back(std::move(obligation));
}

Parts Lowering::lower(Obligation obligation, std::size_t depth) {
  constexpr std::size_t deepest = 64;
  if (depth > deepest) refuse(any_of(obligation.disjuncts), "case distinctions are nested too deep");
  Parts parts;
  Open open{std::move(obligation)};
  while (!open.empty()) {
    Obligation next = std::move(open.back());
    open.pop_back();
    take_apart(std::move(next), {open, parts, depth});
  }
  return parts;
}

void Lowering::take_apart(Obligation obligation, Step step) {
  if (obligation.trigger.is_false() || flatten(obligation)) return;
  if (look_back_from_end(obligation, step)) return;
  if (split_conjunction(obligation, step)) return;
  if (split_local(obligation, step)) return;
  if (unroll_next(obligation, step)) return;
  if (split_until(obligation, step)) return;
  handle_kinds(obligation, step);
}

/// Splices disjunctions in and applies laws. \returns whether a disjunct is `true`, so that nothing is left
/// to do
bool Lowering::flatten(Obligation& obligation) {
  std::vector<Formula> open(obligation.disjuncts.rbegin(), obligation.disjuncts.rend());
  obligation.disjuncts.clear();
  while (!open.empty()) {
    const Formula disjunct = std::move(open.back());
    open.pop_back();
    if (disjunct.is_true()) return true;
    if (disjunct.is_false()) continue;
    const Formula law = apply_law(disjunct, locality_);
    if (law.identity() != disjunct.identity())
      open.push_back(law);
    else if (disjunct.op() == Op::Or &&
             (!locality_.is_local(disjunct) || !open.empty() || !obligation.disjuncts.empty()))
      for (std::size_t i = disjunct.operands().size(); i-- > 0;) open.push_back(disjunct[i]);
    else
      obligation.disjuncts.push_back(disjunct);
  }
  return false;
}

/// match: t -> f & g, t -> (f & g) | h. A local conjunction is split only where it stands alone or is known
/// late: what is known at the next step may stay as the user wrote it.
bool Lowering::split_conjunction(const Obligation& obligation, Step step) {
  const bool late = all_local(obligation.disjuncts) && lookahead(any_of(obligation.disjuncts)) > 1;
  for (std::size_t i = 0; i < obligation.disjuncts.size(); ++i) {
    const Formula& disjunct = obligation.disjuncts[i];
    if (disjunct.op() != Op::And) continue;
    if (obligation.disjuncts.size() > 1 && locality_.is_local(disjunct) && !late) continue;
    for (std::size_t k = disjunct.operands().size(); k-- > 0;) {
      Obligation part = obligation;
      part.disjuncts[i] = disjunct[k];
      push(step, std::move(part));
    }
    return true;
  }
  if (!late || obligation.disjuncts.size() != 1) return false;
  const Formula only = obligation.disjuncts.front();
  if (only.op() != Op::Implies) return false;
  push(step, {obligation.trigger, obligation.single, {!only[0], only[1]}});
  return true;
}

/// match: t -> l | f. result: t & !l -> f; where nothing else is left, a safety.
bool Lowering::split_local(Obligation& obligation, Step step) {
  std::vector<Formula> local, other;
  for (const Formula& disjunct : obligation.disjuncts)
    (locality_.is_local(disjunct) ? local : other).push_back(disjunct);
  if (!other.empty()) {
    for (const Formula& disjunct : local) obligation.trigger = obligation.trigger && !disjunct;
    obligation.disjuncts = std::move(other);
    return obligation.trigger.is_false();
  }
  if (is_first(obligation.trigger))
    step.parts.initial.push_back(any_of(local));
  else
    step.parts.safety.push_back(implies(obligation.trigger, any_of(local)));
  return true;
}

bool Lowering::all_local(const std::vector<Formula>& formulas) {
  return std::all_of(formulas.begin(), formulas.end(),
                     [this](const Formula& f) { return locality_.is_local(f); });
}

bool has_disjunct(const Formula& formula, const Formula& part) {
  if (formula == part) return true;
  const auto operands = formula.operands();
  return formula.op() == Op::Or && std::find(operands.begin(), operands.end(), part) != operands.end();
}

/// `l | (x U d)` with local l, d: what a request inside an interval asks for.
struct Response {
  Formula excused, response;
};

std::optional<Response> match_response(const Formula& formula, const Formula& outside_end,
                                       Locality& locality) {
  const std::vector<Formula> parts =
      formula.op() == Op::Or ? std::vector<Formula>(formula.operands().begin(), formula.operands().end())
                             : std::vector<Formula>{formula};
  std::vector<Formula> excused;
  std::optional<Formula> response;
  for (const Formula& part : parts) {
    if (locality.is_local(part))
      excused.push_back(part);
    else if (!response && part.op() == Op::Until && part[0] == outside_end && locality.is_local(part[1]))
      response = part[1];
    else
      return std::nullopt;
  }
  if (!response) return std::nullopt;
  return Response{any_of(excused), *response};
}

// match:  t -> G !r | (a U c) with c = r or c = ... | r, all local: Dwyer's "before r" and "between q and r".
// result: at r, looking back: since t no c came first and yet a failed -> G !(r & Y (!r S (!a & (!c S (t &
// !c))))). With a = l | (!r U d): no request (!l) is left without its d when r comes.
bool Lowering::look_back_from_end(const Obligation& obligation, Step step) {
  std::vector<Formula> other;
  Formula trigger = obligation.trigger;
  for (const Formula& disjunct : obligation.disjuncts) {
    if (locality_.is_local(disjunct))
      trigger = trigger && !disjunct;
    else
      other.push_back(disjunct);
  }
  if (other.size() != 2) return false;
  if (other[0].op() != Op::Always) std::swap(other[0], other[1]);
  const Op second = other[1].op();
  if (other[0].op() != Op::Always || !locality_.is_local(other[0][0])) return false;
  if (second != Op::Until && second != Op::WeakUntil) return false;
  const Formula& outside_end = other[0][0];
  const Formula end = !outside_end;
  const Formula &required = other[1][0], &release = other[1][1];
  if (!locality_.is_local(release) || !has_disjunct(release, end)) return false;
  const Formula inside = pending(trigger, release);
  if (locality_.is_local(required)) {
    step.parts.safety.push_back(!(end && previous(since(!end, !required && inside))));
    return true;
  }
  const auto request = match_response(required, outside_end, locality_);
  if (!request) return false;
  const Formula waiting = !request->response && !request->excused && inside;
  step.parts.safety.push_back(
      !(end && !request->response && previous(since(!end && !request->response, waiting))));
  return true;
}

/// One step of a formula: F b = b | X F b, a W b = b | (a & X (a W b)), ... \pre not local
Formula unrolled(const Formula& formula) {
  const Formula later = Formula::make(Op::Next, {formula}, formula.location());
  switch (formula.op()) {
    case Op::Next:
      return formula;
    case Op::Eventually:
      return formula[0] || later;
    case Op::Always:
      return is_repeated(formula) ? later : formula[0] && later;
    default:
      return formula[1] || (formula[0] && later);
  }
}

/// match: t -> X f. result: Y t -> f. Beside others, these are unrolled until all say X.
bool Lowering::unroll_next(const Obligation& obligation, Step step) {
  const auto& disjuncts = obligation.disjuncts;
  const auto is_next = [](const Formula& f) { return f.op() == Op::Next; };
  if (std::none_of(disjuncts.begin(), disjuncts.end(), is_next)) return false;
  const bool all = std::all_of(disjuncts.begin(), disjuncts.end(), is_next);
  Obligation next{all ? previous(obligation.trigger) : obligation.trigger, obligation.single, {}};
  for (const Formula& disjunct : disjuncts) next.disjuncts.push_back(all ? disjunct[0] : unrolled(disjunct));
  push(step, std::move(next));
  return true;
}

/// `a U b` at the one step where \p trigger holds, as F: b is reached, and a held at every step before it.
Formula reached(const Formula& trigger, const Formula& a, const Formula& b) {
  const Formula failed = previous(once(!a && once(trigger)));
  return Formula::make(Op::Eventually, {once(trigger) && !failed && b}, b.location());
}

/// match: t -> (a U b) | f. result: t -> (a W b) | f and t -> F b | f; where b speaks of the future, t -> F
/// (... & b) | f.
bool Lowering::split_until(const Obligation& obligation, Step step) {
  for (std::size_t i = 0; i < obligation.disjuncts.size(); ++i) {
    const Formula disjunct = obligation.disjuncts[i];
    if (disjunct.op() != Op::Until) continue;
    Obligation part = obligation;
    if (obligation.single && locality_.is_local(disjunct[0]) && !locality_.is_local(disjunct[1])) {
      part.disjuncts[i] = reached(obligation.trigger, disjunct[0], disjunct[1]);
      push(step, std::move(part));
      return true;
    }
    part.disjuncts[i] = Formula::make(Op::Eventually, {disjunct[1]}, disjunct.location());
    push(step, part);
    part.disjuncts[i] = Formula::make(Op::WeakUntil, {disjunct[0], disjunct[1]}, disjunct.location());
    push(step, std::move(part));
    return true;
  }
  return false;
}

void Lowering::handle_kinds(const Obligation& obligation, Step step) {
  Kinds kinds;
  for (const Formula& disjunct : obligation.disjuncts) {
    if (is_repeated(disjunct))
      kinds.repeated.push_back(disjunct[0][0]);
    else if (disjunct.op() == Op::Eventually)
      kinds.eventual.push_back(disjunct[0]);
    else
      kinds.weak.push_back(disjunct);
  }
  if (!kinds.repeated.empty()) return handle_repeated(obligation, kinds, step);
  if (kinds.weak.empty() && all_local(kinds.eventual))
    return handle_eventual(obligation, any_of(kinds.eventual), step);
  if (kinds.weak.empty() && kinds.eventual.size() == 1) {
    if (!chain(obligation, kinds.eventual.front(), step))
      refuse(obligation.disjuncts.front(), "what follows the eventual step depends on which step is meant");
    return;
  }
  if (kinds.weak.size() == 1 && all_local(kinds.eventual)) return handle_weak(obligation, kinds, step);
  handle_case_distinction(obligation, step);
}

/// match: t -> GF b | f. GF b is the same at every step, hence result: GF b | G (t -> f).
void Lowering::handle_repeated(const Obligation& obligation, const Kinds& kinds, Step step) {
  for (const Formula& goal : kinds.repeated)
    if (!locality_.is_local(goal)) refuse(goal, "it would have to be chosen again and again");
  const Formula goal = any_of(kinds.repeated);
  Obligation rest{obligation.trigger, obligation.single, {}};
  for (const Formula& disjunct : obligation.disjuncts)
    if (!is_repeated(disjunct)) rest.disjuncts.push_back(disjunct);
  if (rest.disjuncts.empty()) {
    step.parts.justice.push_back(implies(once(rest.trigger), goal));
    return;
  }
  const Parts others = lower(std::move(rest), step.depth + 1);
  for (const Formula& initial : others.initial)
    step.parts.justice.push_back(goal || once(first_step() && initial));
  for (const Formula& safety : others.safety) step.parts.justice.push_back(goal || historically(safety));
  for (const Formula& justice : others.justice) step.parts.justice.push_back(goal || justice);
}

/// match: t -> F b. result: again and again no request is pending.
void Lowering::handle_eventual(const Obligation& obligation, const Formula& goal, Step step) {
  if (is_first(obligation.trigger))
    step.parts.justice.push_back(once(goal));
  else if (is_persistent(obligation.trigger))
    step.parts.justice.push_back(implies(obligation.trigger, goal));
  else
    step.parts.justice.push_back(!pending(obligation.trigger, goal));
}

/// match: t -> (a W b) | F q, with G a = a W false. result: a | F q at every step since t without b or q.
void Lowering::handle_weak(const Obligation& obligation, const Kinds& kinds, Step step) {
  const Formula& weak = kinds.weak.front();
  const Formula release = weak.op() == Op::Always ? truth(false) : weak[1];
  if (!locality_.is_local(release)) {
    if (obligation.single && locality_.is_local(weak[0])) {
      Obligation cases{obligation.trigger, true, {Formula::make(Op::Always, {weak[0]}, weak.location())}};
      cases.disjuncts.push_back(reached(obligation.trigger, weak[0], release));
      for (const Formula& goal : kinds.eventual)
        cases.disjuncts.push_back(Formula::make(Op::Eventually, {goal}, goal.location()));
      return push(step, std::move(cases));
    }
    refuse(weak, "when its right side becomes true is not known at that step");
  }
  const Formula goal = any_of(kinds.eventual);
  Obligation rest{pending(obligation.trigger, release || goal), false, {weak[0]}};
  if (!goal.is_false()) rest.disjuncts.push_back(Formula::make(Op::Eventually, {goal}, weak.location()));
  push(step, std::move(rest));
}

// match:  t -> f | g where t holds once, or f and g stay true once they are (G).
// result: (t -> f) | (t -> g): H of safeties, disjunctions of justices.
void Lowering::handle_case_distinction(const Obligation& obligation, Step step) {
  const auto always = [](const Formula& f) { return f.op() == Op::Always; };
  const bool monotone = std::all_of(obligation.disjuncts.begin(), obligation.disjuncts.end(), always);
  if (!obligation.single && !monotone)
    refuse(any_of(obligation.disjuncts), "which side is meant may differ from step to step");
  if (obligation.disjuncts.size() < 2) refuse(any_of(obligation.disjuncts), "no law applies");
  Obligation first = obligation, rest = obligation;
  first.disjuncts.resize(1);
  rest.disjuncts.erase(rest.disjuncts.begin());
  Parts a = lower(std::move(first), step.depth + 1), b = lower(std::move(rest), step.depth + 1);
  for (Parts* parts : {&a, &b})
    for (const Formula& initial : parts->initial) parts->safety.push_back(implies(first_step(), initial));
  count_ += (a.safety.size() + a.justice.size()) * (b.safety.size() + b.justice.size());
  if (count_ > most_) refuse(any_of(obligation.disjuncts), "it splits into too many cases");
  for (const Formula& left : a.safety) {
    for (const Formula& right : b.safety)
      step.parts.safety.push_back(historically(left) || historically(right));
    for (const Formula& right : b.justice) step.parts.justice.push_back(historically(left) || right);
  }
  for (const Formula& left : a.justice) {
    for (const Formula& right : b.safety) step.parts.justice.push_back(left || historically(right));
    for (const Formula& right : b.justice) step.parts.justice.push_back(left || right);
  }
}

/// match: t -> F f where f is a conjunction that speaks of the future again.
bool Lowering::chain(const Obligation& obligation, const Formula& goal, Step step) {
  if (goal.op() != Op::And) return false;
  std::vector<Formula> repeated, rest;
  for (const Formula& part : goal.operands()) (is_repeated(part) ? repeated : rest).push_back(part);
  const auto eventually_of = [&](const Formula& f) {
    return Formula::make(Op::Eventually, {f}, goal.location());
  };
  if (!repeated.empty()) {
    for (const Formula& part : repeated) push(step, {obligation.trigger, obligation.single, {part}});
    push(step, {obligation.trigger, obligation.single, {eventually_of(all_of(rest))}});
    return true;
  }
  for (const Formula& part : rest) {
    if (part.op() != Op::Or || locality_.is_local(part)) continue;
    std::vector<Formula> cases;
    for (const Formula& option : part.operands()) {
      std::vector<Formula> chosen = rest;
      *std::find(chosen.begin(), chosen.end(), part) = option;
      cases.push_back(eventually_of(all_of(chosen)));
    }
    push(step, {obligation.trigger, obligation.single, std::move(cases)});
    return true;
  }
  if (!obligation.single) return false;
  const auto chained = chained_goal(obligation.trigger, goal);
  if (chained) push(step, {obligation.trigger, true, {eventually_of(*chained)}});
  return chained.has_value();
}

/// What F may ask for instead of `l & F b & ...`, `l & X b` or `l & (a U b)`, seen from the step where b
/// holds.
std::optional<Formula> Lowering::chained_goal(const Formula& trigger, const Formula& goal) {
  Formula local = once(trigger);
  std::vector<Formula> other;
  for (const Formula& part : goal.operands()) {
    if (locality_.is_local(part))
      local = local && part;
    else
      other.push_back(part);
  }
  if (other.size() == 1) {
    const Formula& part = other.front();
    if (part.op() == Op::Eventually) return once(local) && part[0];
    if (part.op() == Op::Next) return previous(local) && part[0];
    if (part.op() == Op::Until && locality_.is_local(part[0]))
      return (local || previous(since(part[0], local && part[0]))) && part[1];
    return std::nullopt;
  }
  std::vector<Formula> reached;
  for (const Formula& part : other) {
    if (part.op() != Op::Eventually || !locality_.is_local(part[0])) return std::nullopt;
    reached.push_back(once(once(local) && part[0]));
  }
  return all_of(std::move(reached));
}

}  // namespace

Lowered lower(const Formula& requirement, const LowerOptions& options) {
  Lowering lowering(options.parts);
  const Parts parts = lowering.lower({first_step(), true, {lowering.normal_form(requirement)}});
  LocalCompiler compiler(options.prefix);
  for (const Formula& part : parts.initial) compiler.add_initial(part);
  for (const Formula& part : parts.safety) compiler.add_safety(part);
  for (const Formula& part : parts.justice) compiler.add_justice(part);
  return compiler.finish();
}

}  // namespace heed::logic
