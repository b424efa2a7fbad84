#pragma once

#include <heed/owl/iri.h>

#include <cstddef>
#include <string_view>

/// The built-in names. They have the same small ids in every Ontology, so that code may switch over them.
#define HEED_RDF "http://www.w3.org/1999/02/22-rdf-syntax-ns#"
#define HEED_RDFS "http://www.w3.org/2000/01/rdf-schema#"
#define HEED_OWL "http://www.w3.org/2002/07/owl#"
#define HEED_XSD "http://www.w3.org/2001/XMLSchema#"

#define HEED_OWL_VOCABULARY(X)                                             \
  X(owl_thing, HEED_OWL "Thing")                                           \
  X(owl_nothing, HEED_OWL "Nothing")                                       \
  X(owl_top_object_property, HEED_OWL "topObjectProperty")                 \
  X(owl_bottom_object_property, HEED_OWL "bottomObjectProperty")           \
  X(owl_top_data_property, HEED_OWL "topDataProperty")                     \
  X(owl_bottom_data_property, HEED_OWL "bottomDataProperty")               \
  X(rdfs_literal, HEED_RDFS "Literal")                                     \
  X(xsd_string, HEED_XSD "string")                                         \
  X(xsd_integer, HEED_XSD "integer")                                       \
  X(xsd_decimal, HEED_XSD "decimal")                                       \
  X(xsd_double, HEED_XSD "double")                                         \
  X(xsd_float, HEED_XSD "float")                                           \
  X(xsd_boolean, HEED_XSD "boolean")                                       \
  X(xsd_non_negative_integer, HEED_XSD "nonNegativeInteger")               \
  X(rdf_lang_string, HEED_RDF "langString")                                \
  X(rdf_plain_literal, HEED_RDF "PlainLiteral")                            \
  X(rdf_xml_literal, HEED_RDF "XMLLiteral")                                \
  X(rdf_type, HEED_RDF "type")                                             \
  X(rdf_first, HEED_RDF "first")                                           \
  X(rdf_rest, HEED_RDF "rest")                                             \
  X(rdf_nil, HEED_RDF "nil")                                               \
  X(rdf_list, HEED_RDF "List")                                             \
  X(rdf_property, HEED_RDF "Property")                                     \
  X(rdf_statement, HEED_RDF "Statement")                                   \
  X(rdf_subject, HEED_RDF "subject")                                       \
  X(rdf_predicate, HEED_RDF "predicate")                                   \
  X(rdf_object, HEED_RDF "object")                                         \
  X(rdfs_class, HEED_RDFS "Class")                                         \
  X(rdfs_datatype, HEED_RDFS "Datatype")                                   \
  X(rdfs_resource, HEED_RDFS "Resource")                                   \
  X(rdfs_sub_class_of, HEED_RDFS "subClassOf")                             \
  X(rdfs_sub_property_of, HEED_RDFS "subPropertyOf")                       \
  X(rdfs_domain, HEED_RDFS "domain")                                       \
  X(rdfs_range, HEED_RDFS "range")                                         \
  X(rdfs_label, HEED_RDFS "label")                                         \
  X(rdfs_comment, HEED_RDFS "comment")                                     \
  X(rdfs_see_also, HEED_RDFS "seeAlso")                                    \
  X(rdfs_is_defined_by, HEED_RDFS "isDefinedBy")                           \
  X(owl_version_info, HEED_OWL "versionInfo")                              \
  X(owl_prior_version, HEED_OWL "priorVersion")                            \
  X(owl_backward_compatible_with, HEED_OWL "backwardCompatibleWith")       \
  X(owl_incompatible_with, HEED_OWL "incompatibleWith")                    \
  X(owl_deprecated, HEED_OWL "deprecated")                                 \
  X(owl_ontology, HEED_OWL "Ontology")                                     \
  X(owl_version_iri, HEED_OWL "versionIRI")                                \
  X(owl_imports, HEED_OWL "imports")                                       \
  X(owl_class, HEED_OWL "Class")                                           \
  X(owl_restriction, HEED_OWL "Restriction")                               \
  X(owl_data_range, HEED_OWL "DataRange")                                  \
  X(owl_object_property, HEED_OWL "ObjectProperty")                        \
  X(owl_datatype_property, HEED_OWL "DatatypeProperty")                    \
  X(owl_annotation_property, HEED_OWL "AnnotationProperty")                \
  X(owl_ontology_property, HEED_OWL "OntologyProperty")                    \
  X(owl_named_individual, HEED_OWL "NamedIndividual")                      \
  X(owl_deprecated_class, HEED_OWL "DeprecatedClass")                      \
  X(owl_deprecated_property, HEED_OWL "DeprecatedProperty")                \
  X(owl_functional_property, HEED_OWL "FunctionalProperty")                \
  X(owl_inverse_functional_property, HEED_OWL "InverseFunctionalProperty") \
  X(owl_reflexive_property, HEED_OWL "ReflexiveProperty")                  \
  X(owl_irreflexive_property, HEED_OWL "IrreflexiveProperty")              \
  X(owl_symmetric_property, HEED_OWL "SymmetricProperty")                  \
  X(owl_asymmetric_property, HEED_OWL "AsymmetricProperty")                \
  X(owl_transitive_property, HEED_OWL "TransitiveProperty")                \
  X(owl_equivalent_class, HEED_OWL "equivalentClass")                      \
  X(owl_disjoint_with, HEED_OWL "disjointWith")                            \
  X(owl_disjoint_union_of, HEED_OWL "disjointUnionOf")                     \
  X(owl_equivalent_property, HEED_OWL "equivalentProperty")                \
  X(owl_property_disjoint_with, HEED_OWL "propertyDisjointWith")           \
  X(owl_inverse_of, HEED_OWL "inverseOf")                                  \
  X(owl_property_chain_axiom, HEED_OWL "propertyChainAxiom")               \
  X(owl_has_key, HEED_OWL "hasKey")                                        \
  X(owl_same_as, HEED_OWL "sameAs")                                        \
  X(owl_different_from, HEED_OWL "differentFrom")                          \
  X(owl_all_different, HEED_OWL "AllDifferent")                            \
  X(owl_all_disjoint_classes, HEED_OWL "AllDisjointClasses")               \
  X(owl_all_disjoint_properties, HEED_OWL "AllDisjointProperties")         \
  X(owl_members, HEED_OWL "members")                                       \
  X(owl_distinct_members, HEED_OWL "distinctMembers")                      \
  X(owl_negative_property_assertion, HEED_OWL "NegativePropertyAssertion") \
  X(owl_source_individual, HEED_OWL "sourceIndividual")                    \
  X(owl_assertion_property, HEED_OWL "assertionProperty")                  \
  X(owl_target_individual, HEED_OWL "targetIndividual")                    \
  X(owl_target_value, HEED_OWL "targetValue")                              \
  X(owl_axiom, HEED_OWL "Axiom")                                           \
  X(owl_annotation, HEED_OWL "Annotation")                                 \
  X(owl_annotated_source, HEED_OWL "annotatedSource")                      \
  X(owl_annotated_property, HEED_OWL "annotatedProperty")                  \
  X(owl_annotated_target, HEED_OWL "annotatedTarget")                      \
  X(owl_intersection_of, HEED_OWL "intersectionOf")                        \
  X(owl_union_of, HEED_OWL "unionOf")                                      \
  X(owl_complement_of, HEED_OWL "complementOf")                            \
  X(owl_datatype_complement_of, HEED_OWL "datatypeComplementOf")           \
  X(owl_one_of, HEED_OWL "oneOf")                                          \
  X(owl_on_property, HEED_OWL "onProperty")                                \
  X(owl_on_properties, HEED_OWL "onProperties")                            \
  X(owl_some_values_from, HEED_OWL "someValuesFrom")                       \
  X(owl_all_values_from, HEED_OWL "allValuesFrom")                         \
  X(owl_has_value, HEED_OWL "hasValue")                                    \
  X(owl_has_self, HEED_OWL "hasSelf")                                      \
  X(owl_min_cardinality, HEED_OWL "minCardinality")                        \
  X(owl_max_cardinality, HEED_OWL "maxCardinality")                        \
  X(owl_cardinality, HEED_OWL "cardinality")                               \
  X(owl_min_qualified_cardinality, HEED_OWL "minQualifiedCardinality")     \
  X(owl_max_qualified_cardinality, HEED_OWL "maxQualifiedCardinality")     \
  X(owl_qualified_cardinality, HEED_OWL "qualifiedCardinality")            \
  X(owl_on_class, HEED_OWL "onClass")                                      \
  X(owl_on_data_range, HEED_OWL "onDataRange")                             \
  X(owl_on_datatype, HEED_OWL "onDatatype")                                \
  X(owl_with_restrictions, HEED_OWL "withRestrictions")

namespace heed::owl::vocabulary {

namespace detail {
enum Position : std::uint32_t {
#define HEED_POSITION(name, text) position_##name,
  HEED_OWL_VOCABULARY(HEED_POSITION)
#undef HEED_POSITION
      Count
};
}  // namespace detail

#define HEED_CONSTANT(name, text) inline constexpr Iri name{detail::position_##name};
HEED_OWL_VOCABULARY(HEED_CONSTANT)
#undef HEED_CONSTANT

inline constexpr std::size_t size = detail::Count;

/// \pre iri.id < size
[[nodiscard]] std::string_view text(Iri iri);

}  // namespace heed::owl::vocabulary
