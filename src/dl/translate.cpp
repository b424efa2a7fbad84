#include "translate.h"

#include <algorithm>

namespace heed::dl {

using Kind = owl::ClassExpression::Kind;

/// What must be refuted to be known (see Theory::goals) stands last, so that what is known leads to it.
Concept ConceptSink::conjunction(std::vector<Concept> parts) {
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  std::stable_partition(parts.begin(), parts.end(), [&](Concept part) {
    const ConceptKind kind = node_of(part).kind;
    return kind != ConceptKind::Not && kind != ConceptKind::All;
  });
  Concept out = top;
  for (const Concept part : parts) {
    if (part == bottom) return bottom;
    if (part != top) out = out == top ? part : intern({ConceptKind::And, out, part});
  }
  return out;
}

Concept ConceptSink::disjunction(std::vector<Concept> parts) {
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  Concept out = bottom;
  for (const Concept part : parts) {
    if (part == top) return top;
    if (part != bottom) out = out == bottom ? part : intern({ConceptKind::Or, out, part});
  }
  return out;
}

/// Negation goes inwards where that leads into the fragment: over unions, universals and double negations.
Concept ConceptSink::negation(Concept c) {
  std::vector<Concept> conjuncts;
  std::vector<Concept> open = {c};
  while (!open.empty()) {
    const Concept next = open.back();
    open.pop_back();
    const ConceptNode node = node_of(next);
    if (node.kind == ConceptKind::Or) {
      open.push_back(node.b);
      open.push_back(node.a);
    } else if (next == top || next == bottom) {
      conjuncts.push_back(next == top ? bottom : top);
    } else if (node.kind == ConceptKind::Not) {
      conjuncts.push_back(node.a);
    } else if (node.kind == ConceptKind::All) {
      const ConceptNode inner = node_of(node.b);
      const bool simple = inner.kind != ConceptKind::All && inner.kind != ConceptKind::Or;
      const Concept negated =
          inner.kind == ConceptKind::Not ? inner.a : intern({ConceptKind::Not, node.b, 0});
      conjuncts.push_back(simple ? some(node.a, negated) : intern({ConceptKind::Not, next, 0}));
    } else {
      conjuncts.push_back(intern({ConceptKind::Not, next, 0}));
    }
  }
  return conjunction(std::move(conjuncts));
}

Concept ConceptSink::some(Role role, Concept filler) {
  return filler == bottom ? bottom : intern({ConceptKind::Some, role, filler});
}

Concept ConceptSink::all(Role role, Concept filler) {
  if (filler == top) return top;
  if (filler == bottom) return negation(some(role, top));
  return intern({ConceptKind::All, role, filler});
}

Concept ConceptSink::counted(const owl::ClassExpression& e, Concept existential, bool unqualified,
                             Role role) {
  const std::uint32_t n = e.cardinality();
  const auto at_least = [&] {
    if (n == 0) return top;
    return n == 1 || existential == bottom ? existential : intern({ConceptKind::AtLeast, existential, n});
  };
  const auto at_most = [&] {
    if (existential == bottom) return top;
    if (n == 0) return negation(existential);
    if (n == 1 && unqualified) return intern({ConceptKind::AtMostOne, role, 0});
    return intern({ConceptKind::AtMost, existential, n});
  };
  if (e.kind() == Kind::Min || e.kind() == Kind::DataMin) return at_least();
  if (e.kind() == Kind::Max || e.kind() == Kind::DataMax) return at_most();
  return conjunction({at_least(), at_most()});
}

/// \param parts  The translated operands of \p e.
Concept ConceptSink::build(const owl::ClassExpression& e, const std::vector<Concept>& parts) {
  switch (e.kind()) {
    case Kind::Class:
      if (e.is_thing()) return top;
      return e.is_nothing() ? bottom : intern({ConceptKind::Class, e.iri().id, 0});
    case Kind::Intersection:
      return conjunction(parts);
    case Kind::Union:
      return disjunction(parts);
    case Kind::Complement:
      return negation(parts.front());
    case Kind::OneOf: {
      std::vector<Concept> nominals;
      for (const owl::Iri individual : e.individuals())
        nominals.push_back(intern({ConceptKind::Individual, individual.id, 0}));
      return disjunction(std::move(nominals));
    }
    case Kind::Some:
      return some(role_of(e.property()), parts.front());
    case Kind::Only:
      return all(role_of(e.property()), parts.front());
    case Kind::HasValue: {
      const Role role = role_of(e.property());
      return some(role, intern({ConceptKind::Individual, e.individuals().front().id, 0}));
    }
    case Kind::HasSelf:
      return intern({ConceptKind::Self, role_of(e.property()), 0});
    case Kind::Min:
    case Kind::Max:
    case Kind::Exactly: {
      const Role role = role_of(e.property());
      return counted(e, some(role, parts.front()), parts.front() == top, role);
    }
    default:
      break;
  }
  if (e.data_properties().size() != 1) return intern({ConceptKind::Unknown, 0, 0});
  const Role role = role_of(e.data_properties().front(), true);
  if (e.kind() == Kind::DataHasValue) return some(role, literal(e.literal()));
  const Concept range = data_range(e.range());
  if (e.kind() == Kind::DataSome) return some(role, range);
  if (e.kind() == Kind::DataOnly) return all(role, range);
  return counted(e, some(role, range), range == top, role);
}

Concept ConceptSink::translate(const owl::ClassExpression& expression) {
  struct Open {
    const owl::ClassExpression* expression;
    std::vector<Concept> parts;
  };
  std::vector<Open> open;
  open.push_back({&expression, {}});
  for (;;) {
    const auto& operands = open.back().expression->operands();
    if (open.back().parts.size() < operands.size()) {
      open.push_back({&operands[open.back().parts.size()], {}});
      continue;
    }
    const Concept built = build(*open.back().expression, open.back().parts);
    open.pop_back();
    if (open.empty()) return built;
    open.back().parts.push_back(built);
  }
}

}  // namespace heed::dl
