#pragma once

#include "iri_table.h"

#include <heed/owl/ontology.h>

#include <unordered_map>

namespace heed::owl {

/// What each name is used as: a set of EntityKind per Iri.
class KindTable {
 public:
  [[nodiscard]] bool has(EntityKind kind, Iri iri) const {
    return iri.id < bits_.size() && (bits_[iri.id] & mask(kind)) != 0;
  }
  [[nodiscard]] bool has_any(Iri iri) const { return iri.id < bits_.size() && bits_[iri.id] != 0; }
  [[nodiscard]] bool is_property(Iri iri) const {
    return has(EntityKind::ObjectProperty, iri) || has(EntityKind::DataProperty, iri) ||
           has(EntityKind::AnnotationProperty, iri);
  }
  /// \returns whether that is new.
  bool add(EntityKind kind, Iri iri) {
    if (iri.id >= bits_.size()) bits_.resize(iri.id + 256);
    const bool is_new = (bits_[iri.id] & mask(kind)) == 0;
    bits_[iri.id] = static_cast<std::uint8_t>(bits_[iri.id] | mask(kind));
    return is_new;
  }

 private:
  static std::uint8_t mask(EntityKind kind) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(kind));
  }
  std::vector<std::uint8_t> bits_;
};

/// What an Ontology shares; filled by the readers, then never changed.
struct OntologyData {
  IriTable iris;
  KindTable kinds;
  std::vector<Axiom> axioms;
  std::unordered_map<std::uint32_t, std::vector<Label>> labels;
  std::vector<Import> imports;
  std::vector<Annotation> annotations;
  std::vector<std::pair<std::string, std::string>> prefixes;
  std::string iri, version_iri;
};

}  // namespace heed::owl
