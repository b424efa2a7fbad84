#include <heed/owl/axiom.h>

#include <array>

namespace heed::owl {
namespace {

constexpr std::array<const char*, std::variant_size_v<AxiomContent>> names = {"Declaration",
                                                                              "SubClassOf",
                                                                              "EquivalentClasses",
                                                                              "DisjointClasses",
                                                                              "DisjointUnion",
                                                                              "SubObjectPropertyOf",
                                                                              "EquivalentObjectProperties",
                                                                              "DisjointObjectProperties",
                                                                              "InverseObjectProperties",
                                                                              "ObjectPropertyDomain",
                                                                              "ObjectPropertyRange",
                                                                              "",
                                                                              "SubDataPropertyOf",
                                                                              "EquivalentDataProperties",
                                                                              "DisjointDataProperties",
                                                                              "DataPropertyDomain",
                                                                              "DataPropertyRange",
                                                                              "FunctionalDataProperty",
                                                                              "DatatypeDefinition",
                                                                              "HasKey",
                                                                              "SameIndividual",
                                                                              "DifferentIndividuals",
                                                                              "ClassAssertion",
                                                                              "ObjectPropertyAssertion",
                                                                              "DataPropertyAssertion",
                                                                              "AnnotationAssertion",
                                                                              "SubAnnotationPropertyOf",
                                                                              "AnnotationPropertyDomain",
                                                                              "AnnotationPropertyRange"};

constexpr std::array<const char*, 7> characteristics = {
    "Functional", "InverseFunctional", "Reflexive", "Irreflexive", "Symmetric", "Asymmetric", "Transitive"};

}  // namespace

std::string to_string(AxiomId id) {
  return std::string(1, 'a').append(std::to_string(id.number));
}

std::string kind_name(const Axiom& axiom) {
  if (const auto* c = axiom.as<ObjectPropertyCharacteristic>())
    return std::string(characteristics[static_cast<std::size_t>(c->characteristic)]) + "ObjectProperty";
  const auto* object = axiom.as<ObjectPropertyAssertion>();
  const auto* data = axiom.as<DataPropertyAssertion>();
  const bool negative = (object != nullptr && object->negative) || (data != nullptr && data->negative);
  return std::string(negative ? "Negative" : "").append(names[axiom.content.index()]);
}

bool is_logical(const Axiom& axiom) {
  return !axiom.as<Declaration>() && !axiom.as<AnnotationAssertion>() &&
         !axiom.as<SubAnnotationPropertyOf>() && !axiom.as<AnnotationPropertyDomain>() &&
         !axiom.as<AnnotationPropertyRange>();
}

}  // namespace heed::owl
