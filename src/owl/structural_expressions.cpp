#include "structural.h"

#include <heed/owl/vocabulary.h>

namespace heed::owl {

namespace v = vocabulary;
using Kind = ClassExpression::Kind;

const std::vector<std::string_view>& class_words() {
  static const std::vector<std::string_view> words = {
      "ObjectIntersectionOf", "ObjectUnionOf",        "ObjectComplementOf",     "ObjectOneOf",
      "ObjectSomeValuesFrom", "ObjectAllValuesFrom",  "ObjectHasValue",         "ObjectHasSelf",
      "ObjectMinCardinality", "ObjectMaxCardinality", "ObjectExactCardinality", "DataSomeValuesFrom",
      "DataAllValuesFrom",    "DataHasValue",         "DataMinCardinality",     "DataMaxCardinality",
      "DataExactCardinality"};
  return words;
}

const std::vector<std::string_view>& range_words() {
  static const std::vector<std::string_view> words = {"DataIntersectionOf", "DataUnionOf", "DataComplementOf",
                                                      "DataOneOf", "DatatypeRestriction"};
  return words;
}

namespace {

/// Data properties and the range behind them.
ClassExpression data_quantified(Kind kind, Arguments& in) {
  std::vector<Iri> properties = {in.data_property()};
  // Several names: the last one is a datatype. A range that is no name ends the properties itself.
  std::vector<Iri> names;
  while (const auto* name = in.peek<StructuralBuilder::Name>()) {
    if (name->typed && name->kind == EntityKind::Datatype) break;
    names.push_back(in.iri());
  }
  if (in.at_end() && names.empty()) in.wrong("a data range");
  std::optional<DataRange> range;
  if (!in.at_end()) {
    range = in.range();
  } else {
    in.names().use(EntityKind::Datatype, names.back());
    range = DataRange::datatype(names.back());
    names.pop_back();
  }
  for (const Iri name : names) {
    in.names().use(EntityKind::DataProperty, name);
    properties.push_back(name);
  }
  return ClassExpression::data_quantified(kind, std::move(properties), std::move(*range));
}

ClassExpression counted(Kind kind, Arguments& in) {
  const std::uint32_t n = in.number();
  if (kind >= Kind::DataMin) {
    const Iri property = in.data_property();
    return ClassExpression::data_cardinality(kind, n, property,
                                             in.at_end() ? DataRange::datatype(v::rdfs_literal) : in.range());
  }
  const ObjectProperty property = in.property();
  return ClassExpression::cardinality_of(kind, n, property,
                                         in.at_end() ? ClassExpression::thing() : in.class_expression());
}

}  // namespace

ClassExpression build_class(unsigned code, Arguments& in) {
  const auto kind = static_cast<Kind>(code);
  switch (kind) {
    case Kind::Intersection:
      return ClassExpression::intersection(in.classes(1));
    case Kind::Union:
      return ClassExpression::union_of(in.classes(1));
    case Kind::Complement:
      return ClassExpression::complement(in.class_expression());
    case Kind::OneOf:
      return ClassExpression::one_of(in.entities(EntityKind::NamedIndividual, 1));
    case Kind::Some: {
      const ObjectProperty property = in.property();
      return ClassExpression::some(property, in.class_expression());
    }
    case Kind::Only: {
      const ObjectProperty property = in.property();
      return ClassExpression::only(property, in.class_expression());
    }
    case Kind::HasValue: {
      const ObjectProperty property = in.property();
      return ClassExpression::has_value(property, in.individual());
    }
    case Kind::HasSelf:
      return ClassExpression::has_self(in.property());
    case Kind::DataSome:
    case Kind::DataOnly:
      return data_quantified(kind, in);
    case Kind::DataHasValue: {
      const Iri property = in.data_property();
      return ClassExpression::data_has_value(property, in.literal());
    }
    default:
      return counted(kind, in);
  }
}

DataRange build_range(unsigned code, Arguments& in) {
  std::vector<DataRange> operands;
  std::vector<Literal> literals;
  std::vector<Facet> facets;
  switch (static_cast<DataRange::Kind>(code)) {
    case DataRange::Kind::Complement:
      return DataRange::complement(in.range());
    case DataRange::Kind::OneOf:
      do literals.push_back(in.literal());
      while (!in.at_end());
      return DataRange::one_of(std::move(literals));
    case DataRange::Kind::Restriction: {
      const Iri base = in.entity(EntityKind::Datatype);
      do {
        if (in.peek<Facet>()) {
          facets.push_back(in.take<Facet>());
          continue;
        }
        const Iri facet = in.iri();
        facets.push_back({facet, in.literal()});
      } while (!in.at_end());
      return DataRange::restriction(base, std::move(facets));
    }
    default:
      do operands.push_back(in.range());
      while (!in.at_end());
      return static_cast<DataRange::Kind>(code) == DataRange::Kind::Union
                 ? DataRange::union_of(std::move(operands))
                 : DataRange::intersection(std::move(operands));
  }
}

}  // namespace heed::owl
