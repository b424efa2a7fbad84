#include "kinds.h"
#include "mapper.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

// Nodes of the graph as expressions. Class expressions may nest as deep as the input does, so they are built
// children first from a list of pending nodes; every blank node is built once and remembered.

namespace heed::owl {

namespace v = vocabulary;
using Kind = ClassExpression::Kind;

void Mapper::take_type(Term node) {
  for (const std::uint32_t at : statements_of(node))
    if (triple(at).predicate == v::rdf_type) used_[at] = true;
}

std::optional<std::vector<Term>> Mapper::list_of(Term head, std::uint32_t at) {
  std::vector<Term> out;
  while (!(head == v::rdf_nil)) {
    const std::uint32_t first = head.is_literal() ? none : find(head, v::rdf_first);
    const std::uint32_t rest = head.is_literal() ? none : find(head, v::rdf_rest);
    if (first == none || rest == none || out.size() > graph_.triples.size()) {
      report(at, "broken-list",
             out.size() > graph_.triples.size() ? "the list runs in a circle"
                                                : "the list does not end in rdf:nil",
             "each cell of a list needs one rdf:first and one rdf:rest");
      return std::nullopt;
    }
    used_[first] = used_[rest] = true;
    take_type(head);
    out.push_back(triple(first).object);
    head = triple(rest).object;
  }
  return out;
}

std::optional<Iri> Mapper::individual_of(Term node, std::uint32_t at) {
  if (node.is_literal()) {
    report(at, "literal-individual",
           fmt::format("the literal {} stands where an individual is expected", show(node)));
    return std::nullopt;
  }
  const Iri iri = node.is_iri() ? node.as_iri() : std::get<Iri>(annotation_value(node));
  use(EntityKind::NamedIndividual, iri);
  return iri;
}

std::optional<ObjectProperty> Mapper::property_of(Term node, std::uint32_t at) {
  if (node.is_iri()) {
    use(EntityKind::ObjectProperty, node.as_iri());
    return ObjectProperty{node.as_iri(), false};
  }
  const std::uint32_t inverse = node.is_blank() ? find(node, v::owl_inverse_of) : none;
  if (inverse == none || !triple(inverse).object.is_iri()) {
    report(at, "bad-property", fmt::format("{} stands where an object property is expected", show(node)));
    return std::nullopt;
  }
  used_[inverse] = true;
  take_type(node);
  use(EntityKind::ObjectProperty, triple(inverse).object.as_iri());
  return ObjectProperty{triple(inverse).object.as_iri(), true};
}

bool Mapper::is_data_property(Term node) const {
  return is(EntityKind::DataProperty, node) && !is(EntityKind::ObjectProperty, node);
}

bool Mapper::is_data_range(Term node) {
  if (node.is_iri()) return is_datatype(node.as_iri(), data_.kinds, data_.iris);
  if (node.is_literal()) return false;
  for (const std::uint32_t at : statements_of(node)) {
    const Triple& t = triple(at);
    if (t.predicate == v::rdf_type && (t.object == v::rdfs_datatype || t.object == v::owl_data_range))
      return true;
  }
  return false;
}

std::optional<DataRange> Mapper::facets_of(Term node, std::uint32_t at) {
  const auto base = take(node, v::owl_on_datatype);
  const auto head = take(node, v::owl_with_restrictions);
  const auto list = head ? list_of(*head, at) : std::nullopt;
  if (!base || !base->is_iri() || !list) return std::nullopt;
  std::vector<Facet> facets;
  for (const Term member : *list)
    for (const std::uint32_t inner : statements_of(member)) {
      if (!triple(inner).object.is_literal()) return std::nullopt;
      used_[inner] = true;
      facets.push_back({triple(inner).predicate, graph_.literals[triple(inner).object.number()]});
    }
  return DataRange::restriction(base->as_iri(), std::move(facets));
}

std::optional<DataRange> Mapper::range_of(Term node, std::uint32_t at, unsigned depth) {
  if (node.is_iri()) {
    use(EntityKind::Datatype, node.as_iri());
    return DataRange::datatype(node.as_iri());
  }
  std::optional<DataRange> out;
  take_type(node);
  if (depth > 200) {
    report(at, "nesting", "data ranges nest more than 200 deep",
           "give the inner range a name by a datatype definition");
    return std::nullopt;
  }
  if (find(node, v::owl_on_datatype) != none) {
    out = facets_of(node, at);
  } else if (const auto complement = take(node, v::owl_datatype_complement_of)) {
    if (auto inner = range_of(*complement, at, depth + 1)) out = DataRange::complement(std::move(*inner));
  } else if (const auto one_of = take(node, v::owl_one_of)) {
    std::vector<Literal> literals;
    const auto list = list_of(*one_of, at);
    const bool all = list && std::all_of(list->begin(), list->end(), [](Term t) { return t.is_literal(); });
    if (all) {
      for (const Term member : *list) literals.push_back(graph_.literals[member.number()]);
      out = DataRange::one_of(std::move(literals));
    }
  } else {
    const bool both = find(node, v::owl_intersection_of) != none;
    const auto head = take(node, both ? v::owl_intersection_of : v::owl_union_of);
    const auto list = head ? list_of(*head, at) : std::nullopt;
    std::vector<DataRange> parts;
    for (const Term member : list.value_or(std::vector<Term>{}))
      if (auto part = range_of(member, at, depth + 1)) parts.push_back(std::move(*part));
    if (list && parts.size() == list->size())
      out = both ? DataRange::intersection(std::move(parts)) : DataRange::union_of(std::move(parts));
  }
  if (!out)
    report(at, "bad-data-range", fmt::format("{} is no data range", show(node)), "the axiom was left out");
  return out;
}

/// Of a named class, or of a node that was built before.
std::optional<ClassExpression> Mapper::known_class(Term node) {
  if (node.is_iri()) {
    use(EntityKind::Class, node.as_iri());
    return ClassExpression::named(node.as_iri());
  }
  if (node.is_blank() && states_[node.number()] == State::Done) return classes_[node.number()];
  return std::nullopt;
}

/// The nodes that must be built before \p node.
std::vector<Term> Mapper::class_parts(Term node) {
  std::vector<Term> parts;
  for (const std::uint32_t at : statements_of(node)) {
    const Triple& t = triple(at);
    switch (t.predicate.id) {
      case v::owl_complement_of.id:
      case v::owl_some_values_from.id:
      case v::owl_all_values_from.id:
      case v::owl_on_class.id:
        if (t.object.is_blank() && !is_data_range(t.object)) parts.push_back(t.object);
        break;
      case v::owl_intersection_of.id:
      case v::owl_union_of.id:
        if (auto list = list_of(t.object, at))
          for (const Term member : *list)
            if (member.is_blank()) parts.push_back(member);
        break;
      default:
        break;
    }
  }
  return parts;
}

/// Builds \p node, the last of \p pending, or puts what it needs behind it.
void Mapper::visit(Term node, std::uint32_t at, std::vector<Term>& pending) {
  State& state = states_[node.number()];
  if (state == State::Done || state == State::Bad) {
    pending.pop_back();
    return;
  }
  bool bad = false;
  if (state == State::New) {
    state = State::Open;
    const std::vector<Term> parts = class_parts(node);
    for (const Term part : parts) bad |= states_[part.number()] == State::Open;
    if (!bad && !parts.empty()) {
      pending.insert(pending.end(), parts.rbegin(), parts.rend());
      return;
    }
    if (bad) report(at, "cyclic-class", "a class expression contains itself", "the axiom was left out");
  }
  std::optional<ClassExpression> built;
  if (!bad) built = build_class(node, at);
  if (built && limits_.nesting != 0 && built->depth() > limits_.nesting) {
    report(at, "nesting", fmt::format("class expressions nest more than {} deep", limits_.nesting),
           "give the inner expression a name of its own");
    built.reset();
  }
  state = built ? State::Done : State::Bad;
  if (built) classes_[node.number()] = std::move(*built);
  pending.pop_back();
}

std::optional<ClassExpression> Mapper::class_of(Term root, std::uint32_t at) {
  if (root.is_literal()) {
    report(at, "literal-class", fmt::format("the literal {} stands where a class is expected", show(root)));
    return std::nullopt;
  }
  const std::size_t before = diagnostics_.size();
  if (root.is_blank()) {
    std::vector<Term> pending = {root};
    while (!pending.empty()) visit(pending.back(), at, pending);
  }
  auto out = known_class(root);
  if (!out && diagnostics_.size() == before)
    report(at, "bad-class", "a part of the class expression was not understood", "the axiom was left out");
  if (!out) used_[at] = true;
  return out;
}

std::optional<std::vector<ClassExpression>> Mapper::classes_of(Term list, std::uint32_t at) {
  const auto members = list_of(list, at);
  if (!members) return std::nullopt;
  std::vector<ClassExpression> out;
  for (const Term member : *members) {
    auto part = class_of(member, at);
    if (!part) return std::nullopt;
    out.push_back(std::move(*part));
  }
  return out;
}

std::optional<ClassExpression> Mapper::build_class(Term node, std::uint32_t at) {
  if (find(node, v::owl_on_property) != none || find(node, v::owl_on_properties) != none)
    return build_restriction(node, at);
  for (const Iri connective : {v::owl_intersection_of, v::owl_union_of, v::owl_complement_of, v::owl_one_of})
    if (find(node, connective) != none) return build_connective(node, connective.id, at);
  report(at, "bad-class", fmt::format("{} is no class expression", show(node)), "the axiom was left out");
  return std::nullopt;
}

std::optional<ClassExpression> Mapper::build_connective(Term node, std::uint32_t connective,
                                                        std::uint32_t at) {
  if (node.is_blank()) take_type(node);
  const std::uint32_t own = find(node, Iri{connective});
  used_[own] = true;
  const Term object = triple(own).object;
  if (connective == v::owl_complement_of.id) {
    auto inner = known_class(object);
    return inner ? std::optional(ClassExpression::complement(std::move(*inner))) : std::nullopt;
  }
  const auto members = list_of(object, at);
  if (!members) return std::nullopt;
  if (connective == v::owl_one_of.id) {
    std::vector<Iri> individuals;
    for (const Term member : *members)
      if (const auto individual = individual_of(member, at)) individuals.push_back(*individual);
    return individuals.size() == members->size()
               ? std::optional(ClassExpression::one_of(std::move(individuals)))
               : std::nullopt;
  }
  std::vector<ClassExpression> parts;
  for (const Term member : *members) {
    auto part = member.is_literal() ? std::nullopt : known_class(member);
    if (!part) return std::nullopt;
    parts.push_back(std::move(*part));
  }
  return connective == v::owl_intersection_of.id ? ClassExpression::intersection(std::move(parts))
                                                 : ClassExpression::union_of(std::move(parts));
}

std::optional<std::uint32_t> Mapper::number_of(Term term, std::uint32_t at) {
  std::uint32_t n = 0;
  if (term.is_literal()) {
    const std::string& text = graph_.literals[term.number()].value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (error == std::errc() && end == text.data() + text.size()) return n;
  }
  report(at, "bad-cardinality", fmt::format("{} is no cardinality", show(term)), "write a natural number");
  return std::nullopt;
}

std::optional<ClassExpression> Mapper::build_restriction(Term node, std::uint32_t at) {
  static constexpr std::array kinds = {v::owl_some_values_from,
                                       v::owl_all_values_from,
                                       v::owl_has_value,
                                       v::owl_has_self,
                                       v::owl_min_cardinality,
                                       v::owl_max_cardinality,
                                       v::owl_cardinality,
                                       v::owl_min_qualified_cardinality,
                                       v::owl_max_qualified_cardinality,
                                       v::owl_qualified_cardinality};
  take_type(node);
  std::uint32_t what = none;
  for (const Iri kind : kinds) {
    const std::uint32_t found = find(node, kind);
    if (found == none || (what != none && kind != triple(what).predicate)) continue;
    what = found;
  }
  if (what == none) {
    report(at, "bad-restriction", "a restriction says nothing about its property",
           "it needs owl:someValuesFrom, owl:allValuesFrom, owl:hasValue or a cardinality");
    return std::nullopt;
  }
  used_[what] = true;
  std::vector<Iri> data;
  if (const auto several = take(node, v::owl_on_properties)) {
    for (const Term member : list_of(*several, at).value_or(std::vector<Term>{}))
      if (member.is_iri()) data.push_back(member.as_iri());
    return data_restriction(node, std::move(data), what);
  }
  const Term property = *take(node, v::owl_on_property);
  const bool literal = triple(what).object.is_literal() && triple(what).predicate == v::owl_has_value;
  if (property.is_iri() && (is_data_property(property) || literal)) {
    use(EntityKind::DataProperty, property.as_iri());
    return data_restriction(node, {property.as_iri()}, what);
  }
  const auto object = property_of(property, at);
  return object ? object_restriction(node, *object, what) : std::nullopt;
}

std::optional<ClassExpression> Mapper::object_restriction(Term node, ObjectProperty property,
                                                          std::uint32_t what) {
  const Triple t = triple(what);
  switch (t.predicate.id) {
    case v::owl_some_values_from.id:
    case v::owl_all_values_from.id: {
      auto filler = t.object.is_literal() ? std::nullopt : known_class(t.object);
      if (!filler) return std::nullopt;
      return t.predicate == v::owl_some_values_from ? ClassExpression::some(property, std::move(*filler))
                                                    : ClassExpression::only(property, std::move(*filler));
    }
    case v::owl_has_value.id: {
      const auto value = individual_of(t.object, what);
      return value ? std::optional(ClassExpression::has_value(property, *value)) : std::nullopt;
    }
    case v::owl_has_self.id:
      return ClassExpression::has_self(property);
    default:
      break;
  }
  const auto n = number_of(t.object, what);
  const auto on = take(node, v::owl_on_class);
  const auto filler = on ? known_class(*on) : std::optional(ClassExpression::thing());
  if (!n || !filler) return std::nullopt;
  const bool min = t.predicate == v::owl_min_cardinality || t.predicate == v::owl_min_qualified_cardinality;
  const bool max = t.predicate == v::owl_max_cardinality || t.predicate == v::owl_max_qualified_cardinality;
  return ClassExpression::cardinality_of(min   ? Kind::Min
                                         : max ? Kind::Max
                                               : Kind::Exactly,
                                         *n, property, *filler);
}

std::optional<ClassExpression> Mapper::data_restriction(Term node, std::vector<Iri> properties,
                                                        std::uint32_t what) {
  const Triple t = triple(what);
  if (properties.empty()) return std::nullopt;
  if (t.predicate == v::owl_some_values_from || t.predicate == v::owl_all_values_from) {
    auto range = range_of(t.object, what);
    const Kind kind = t.predicate == v::owl_some_values_from ? Kind::DataSome : Kind::DataOnly;
    return range ? std::optional(
                       ClassExpression::data_quantified(kind, std::move(properties), std::move(*range)))
                 : std::nullopt;
  }
  if (t.predicate == v::owl_has_value && t.object.is_literal())
    return ClassExpression::data_has_value(properties.front(), graph_.literals[t.object.number()]);
  if (t.predicate == v::owl_has_value || t.predicate == v::owl_has_self) {
    report(what, "bad-restriction", "a data property has an individual as its value");
    return std::nullopt;
  }
  const auto n = number_of(t.object, what);
  const auto on = take(node, v::owl_on_data_range);
  const auto range = on ? range_of(*on, what) : std::optional(DataRange::datatype(v::rdfs_literal));
  if (!n || !range) return std::nullopt;
  const bool min = t.predicate == v::owl_min_cardinality || t.predicate == v::owl_min_qualified_cardinality;
  const bool max = t.predicate == v::owl_max_cardinality || t.predicate == v::owl_max_qualified_cardinality;
  return ClassExpression::data_cardinality(min   ? Kind::DataMin
                                           : max ? Kind::DataMax
                                                 : Kind::DataExactly,
                                           *n, properties.front(), *range);
}

}  // namespace heed::owl
