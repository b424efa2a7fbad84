#pragma once

#include <heed/owl/expression.h>
#include <heed/util/source.h>

#include <string>
#include <variant>
#include <vector>

namespace heed::owl {

/// The place of an axiom in its ontology: a1, a2, ... in document order (imported documents after the one
/// that imports).
struct AxiomId {
  std::uint32_t number = 0;  ///< From 1; 0 is no axiom.
  friend auto operator<=>(const AxiomId&, const AxiomId&) = default;
};

/// "a12"
[[nodiscard]] std::string to_string(AxiomId id);

/// An IRI (or anonymous individual) or a literal.
using AnnotationValue = std::variant<Iri, Literal>;

struct Annotation {
  Iri property;
  AnnotationValue value;
  std::vector<Annotation> annotations;  ///< Of the annotation itself.
};

struct Declaration {
  EntityKind kind;
  Iri entity;
};
struct SubClassOf {
  ClassExpression sub, super;
};
struct EquivalentClasses {
  std::vector<ClassExpression> classes;
};
struct DisjointClasses {
  std::vector<ClassExpression> classes;
};
struct DisjointUnion {
  Iri whole;
  std::vector<ClassExpression> parts;
};
/// A chain of one property is plain inclusion.
struct SubObjectPropertyOf {
  std::vector<ObjectProperty> chain;
  ObjectProperty super;
};
struct EquivalentObjectProperties {
  std::vector<ObjectProperty> properties;
};
struct DisjointObjectProperties {
  std::vector<ObjectProperty> properties;
};
struct InverseObjectProperties {
  ObjectProperty first, second;
};
struct ObjectPropertyDomain {
  ObjectProperty property;
  ClassExpression domain;
};
struct ObjectPropertyRange {
  ObjectProperty property;
  ClassExpression range;
};
enum class Characteristic : std::uint8_t {
  Functional,
  InverseFunctional,
  Reflexive,
  Irreflexive,
  Symmetric,
  Asymmetric,
  Transitive
};
struct ObjectPropertyCharacteristic {
  Characteristic characteristic;
  ObjectProperty property;
};
struct SubDataPropertyOf {
  Iri sub, super;
};
struct EquivalentDataProperties {
  std::vector<Iri> properties;
};
struct DisjointDataProperties {
  std::vector<Iri> properties;
};
struct DataPropertyDomain {
  Iri property;
  ClassExpression domain;
};
struct DataPropertyRange {
  Iri property;
  DataRange range;
};
struct FunctionalDataProperty {
  Iri property;
};
struct DatatypeDefinition {
  Iri datatype;
  DataRange range;
};
struct HasKey {
  ClassExpression of;
  std::vector<ObjectProperty> object_properties;
  std::vector<Iri> data_properties;
};
struct SameIndividual {
  std::vector<Iri> individuals;
};
struct DifferentIndividuals {
  std::vector<Iri> individuals;
};
struct ClassAssertion {
  ClassExpression of;
  Iri individual;
};
struct ObjectPropertyAssertion {
  ObjectProperty property;
  Iri source, target;
  bool negative = false;
};
struct DataPropertyAssertion {
  Iri property;
  Iri source;
  Literal value;
  bool negative = false;
};
struct AnnotationAssertion {
  Iri property;
  Iri subject;
  AnnotationValue value;
};
struct SubAnnotationPropertyOf {
  Iri sub, super;
};
struct AnnotationPropertyDomain {
  Iri property, domain;
};
struct AnnotationPropertyRange {
  Iri property, range;
};

using AxiomContent =
    std::variant<Declaration, SubClassOf, EquivalentClasses, DisjointClasses, DisjointUnion,
                 SubObjectPropertyOf, EquivalentObjectProperties, DisjointObjectProperties,
                 InverseObjectProperties, ObjectPropertyDomain, ObjectPropertyRange,
                 ObjectPropertyCharacteristic, SubDataPropertyOf, EquivalentDataProperties,
                 DisjointDataProperties, DataPropertyDomain, DataPropertyRange, FunctionalDataProperty,
                 DatatypeDefinition, HasKey, SameIndividual, DifferentIndividuals, ClassAssertion,
                 ObjectPropertyAssertion, DataPropertyAssertion, AnnotationAssertion, SubAnnotationPropertyOf,
                 AnnotationPropertyDomain, AnnotationPropertyRange>;

/// One axiom with its place. Immutable by convention: an Ontology only hands out const ones.
struct Axiom {
  AxiomId id;
  AxiomContent content;
  util::Location location;
  std::vector<Annotation> annotations;

  /// The content when it is of kind \p T, else nullptr.
  template <class T>
  [[nodiscard]] const T* as() const {
    return std::get_if<T>(&content);
  }
};

/// "SubClassOf", "FunctionalObjectProperty", ... as the functional-style syntax calls it.
[[nodiscard]] std::string kind_name(const Axiom& axiom);

/// Whether it says something about the models: all but declarations and annotation axioms.
[[nodiscard]] bool is_logical(const Axiom& axiom);

}  // namespace heed::owl
