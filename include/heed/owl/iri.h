#pragma once

#include <compare>
#include <cstdint>

namespace heed::owl {

/// The name of an entity or of an anonymous individual, as its number in the table of an Ontology. Two names
/// are equal exactly when their numbers are; numbers of different ontologies do not compare, apart from those
/// of vocabulary.h.
struct Iri {
  std::uint32_t id = 0;
  friend auto operator<=>(const Iri&, const Iri&) = default;
};

enum class EntityKind : std::uint8_t {
  Class,
  Datatype,
  ObjectProperty,
  DataProperty,
  AnnotationProperty,
  NamedIndividual
};

}  // namespace heed::owl
