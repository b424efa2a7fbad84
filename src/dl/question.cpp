#include "question.h"

#include <heed/util/limits.h>

#include <algorithm>

namespace heed::dl {

using Kind = owl::ClassExpression::Kind;
using owl::ClassExpression;

ContextId Question::saturated(std::vector<Concept> core) {
  std::sort(core.begin(), core.end());
  core.erase(std::unique(core.begin(), core.end()), core.end());
  const ContextId id = saturation_.context(std::move(core));
  saturation_.run();
  return id;
}

ContextId Question::context_of(const ClassExpression& sub) {
  return saturated({extra_.translate(sub)});
}

/// A class of which nothing is known.
Concept Question::fresh() {
  return extra_.intern({ConceptKind::Unknown, ++fresh_count_, 0});
}

bool Question::unsatisfiable(ContextId x) {
  if (base_.inconsistent()) {
    facts_.push_back(base_.inconsistency());
    return true;
  }
  if (!at(x).unsatisfiable) return false;
  facts_.push_back(saturation_.fact_of(x, bottom));
  return true;
}

bool Question::satisfiable(const ClassExpression& expression) {
  return !unsatisfiable(context_of(expression));
}

bool Question::subsumption(const ClassExpression& sub, const ClassExpression& super) {
  return ask({extra_.translate(sub)}, super);
}

bool Question::type(owl::Iri individual, const ClassExpression& of) {
  return ask({extra_.intern({ConceptKind::Individual, individual.id, 0})}, of);
}

/// Splits conjunctions, moves complements to the left; the rest is looked up.
bool Question::ask(const std::vector<Concept>& core, const ClassExpression& super) {
  if (super.depth() > 1000)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                              "a class expression that is asked for nests more than 1000 deep");
  std::vector<const ClassExpression*> open = {&super};
  while (!open.empty()) {
    const ClassExpression& next = *open.back();
    open.pop_back();
    if (next.kind() == Kind::Intersection) {
      for (const ClassExpression& part : next.operands()) open.push_back(&part);
    } else if (!ask_simple(core, next)) {
      return false;
    }
  }
  return true;
}

bool Question::ask_simple(const std::vector<Concept>& core, const ClassExpression& super) {
  const auto with = [&](Concept c) {
    std::vector<Concept> more = core;
    more.push_back(c);
    return more;
  };
  switch (super.kind()) {
    case Kind::Complement:
      return unsatisfiable(saturated(with(extra_.translate(super.filler()))));
    case Kind::Max:
      if (super.cardinality() == 0)
        return unsatisfiable(
            saturated(with(extra_.some(extra_.role_of(super.property()), extra_.translate(super.filler())))));
      break;
    case Kind::Exactly:
      return ask_simple(core, ClassExpression::cardinality_of(Kind::Min, super.cardinality(),
                                                              super.property(), super.filler())) &&
             ask_simple(core, ClassExpression::cardinality_of(Kind::Max, super.cardinality(),
                                                              super.property(), super.filler()));
    case Kind::Only:
      return ask_universal(core, extra_.role_of(super.property()), &super.filler(), top);
    case Kind::DataOnly:
      if (super.data_properties().size() != 1) return false;
      return ask_universal(core, extra_.role_of(super.data_properties().front(), true), nullptr,
                           extra_.data_range(super.range()));
    default:
      break;
  }
  return holds(saturated(core), super);
}

/// X is below `only R C` when any successor along R, of which nothing else is known, is a C.
bool Question::ask_universal(std::vector<Concept> core, Role role, const ClassExpression* filler,
                             Concept value) {
  const Concept successor = fresh();
  core.push_back(extra_.some(role, successor));
  const ContextId x = saturated(std::move(core));
  if (unsatisfiable(x)) return true;
  for (const Link& edge : std::vector<Link>(at(x).successors)) {
    if (edge.role != role || !saturation_.has(edge.other, successor)) continue;
    const std::size_t before = facts_.size();
    facts_.push_back(edge.fact);
    if (filler != nullptr ? holds(edge.other, *filler) : holds_concept(edge.other, value)) return true;
    facts_.resize(before);
  }
  return false;
}

bool Question::holds_concept(ContextId x, Concept c) {
  if (unsatisfiable(x)) return true;
  if (c == nothing_known || !saturation_.has(x, c)) return false;
  facts_.push_back(saturation_.fact_of(x, c));
  return true;
}

bool Question::holds_link(ContextId x, Role role, const ClassExpression* filler, Concept value) {
  for (const Link& edge : at(x).successors) {
    if (!saturation_.is_subrole(edge.role, role)) continue;
    const std::size_t before = facts_.size();
    facts_.push_back(edge.fact);
    facts_.push_back(saturation_.subrole_fact(edge.role, role));
    if (filler != nullptr ? holds(edge.other, *filler) : holds_concept(edge.other, value)) return true;
    facts_.resize(before);
  }
  return false;
}

bool Question::holds_at_most(ContextId x, Role role) {
  for (const auto& [local, fact] : at(x).at_most_one)
    if (saturation_.is_subrole(role, local)) {
      facts_.push_back(fact);
      facts_.push_back(saturation_.subrole_fact(role, local));
      return true;
    }
  const Theory& theory = base_.theory();
  if (role >= theory.role_count()) return false;
  for (const Role super : theory.superroles(role))
    if (theory.functional(super) != nothing_known) {
      facts_.push_back(saturation_.subrole_fact(role, super));
      facts_.push_back(saturation_.axiom_fact(theory.functional(super)));
      return true;
    }
  return false;
}

/// Told as it is asked, or by so many successors that differ.
bool Question::holds_count(ContextId x, const ClassExpression& e) {
  const Role role = extra_.role_of(e.property());
  const Concept filler = extra_.translate(e.filler());
  const Concept told =
      base_.theory().find({ConceptKind::AtLeast, extra_.some(role, filler), e.cardinality()});
  if (told != nothing_known && saturation_.has(x, told)) return holds_concept(x, told);
  const auto fact = saturation_.distinct_successors(x, role, filler, e.cardinality());
  if (fact) facts_.push_back(*fact);
  return fact.has_value();
}

/// Told, or a named thing that is its own successor.
bool Question::holds_self(ContextId x, Role role) {
  const Concept told = base_.theory().find({ConceptKind::Self, role, 0});
  if (told != nothing_known && saturation_.has(x, told)) return holds_concept(x, told);
  for (const Concept c : at(x).subsumers)
    if (c < base_.theory().size() && base_.theory().node(c).kind == ConceptKind::Individual &&
        holds_link(x, role, nullptr, c)) {
      facts_.push_back(saturation_.fact_of(x, c));
      return true;
    }
  return false;
}

bool Question::holds_every(ContextId x, const std::vector<ClassExpression>& parts) {
  return std::all_of(parts.begin(), parts.end(), [&](const ClassExpression& part) { return holds(x, part); });
}

/// Recurses over \p e, whose depth ask() bounds.
bool Question::holds(ContextId x, const ClassExpression& e) {
  if (unsatisfiable(x)) return true;
  const auto data_role = [&] { return extra_.role_of(e.data_properties().front(), true); };
  switch (e.kind()) {
    case Kind::Class:
      return e.is_thing() || (!e.is_nothing() && holds_concept(x, extra_.translate(e)));
    case Kind::Intersection:
      return holds_every(x, e.operands());
    case Kind::Union:
      return std::any_of(e.operands().begin(), e.operands().end(),
                         [&](const auto& part) { return holds(x, part); });
    case Kind::OneOf:
      return std::any_of(e.individuals().begin(), e.individuals().end(), [&](owl::Iri iri) {
        return holds_concept(x, extra_.intern({ConceptKind::Individual, iri.id, 0}));
      });
    case Kind::Some:
      return holds_link(x, extra_.role_of(e.property()), &e.filler(), top);
    case Kind::HasValue: {
      const Concept value = extra_.intern({ConceptKind::Individual, e.individuals().front().id, 0});
      return holds_link(x, extra_.role_of(e.property()), nullptr, value);
    }
    case Kind::Min:
      if (e.cardinality() == 0) return true;
      if (e.cardinality() == 1) return holds_link(x, extra_.role_of(e.property()), &e.filler(), top);
      return holds_count(x, e);
    case Kind::Max:
      return e.cardinality() >= 1 && holds_at_most(x, extra_.role_of(e.property()));
    case Kind::DataSome:
      return e.data_properties().size() == 1 &&
             holds_link(x, data_role(), nullptr, extra_.data_range(e.range()));
    case Kind::DataHasValue: {
      const Concept known = base_.theory().data_concept(Theory::key_of(e.literal()).text);
      return known != nothing_known ? holds_link(x, data_role(), nullptr, known)
                                    : holds_link(x, data_role(), nullptr, extra_.literal_alone(e.literal()));
    }
    case Kind::DataMin:
      return e.cardinality() == 0 ||
             (e.cardinality() == 1 && holds_link(x, data_role(), nullptr, extra_.data_range(e.range())));
    case Kind::DataMax:
      return e.cardinality() >= 1 && holds_at_most(x, data_role());
    case Kind::HasSelf:
      return holds_self(x, extra_.role_of(e.property()));
    default:
      return false;
  }
}

bool Question::role_inclusion(const std::vector<owl::ObjectProperty>& chain, owl::ObjectProperty super) {
  const Concept end = fresh();
  Concept path = end;
  for (auto step = chain.rbegin(); step != chain.rend(); ++step)
    path = extra_.some(extra_.role_of(*step), path);
  const ContextId x = saturated({fresh(), path});
  return unsatisfiable(x) || holds_link(x, extra_.role_of(super), nullptr, end);
}

bool Question::data_role_inclusion(owl::Iri sub, owl::Iri super) {
  const Concept end = fresh();
  const ContextId x = saturated({fresh(), extra_.some(extra_.role_of(sub, true), end)});
  return unsatisfiable(x) || holds_link(x, extra_.role_of(super, true), nullptr, end);
}

bool Question::functional(owl::ObjectProperty property) {
  return holds_at_most(saturated({top}), extra_.role_of(property));
}

}  // namespace heed::dl
