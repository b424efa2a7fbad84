#include "structural.h"

#include <array>

// One row per word: how its arguments become an axiom. In braces they are taken from left to right.

namespace heed::owl {
namespace {

using In = Arguments&;
using Out = AxiomContent;

template <Characteristic characteristic>
Out having(In in) {
  return ObjectPropertyCharacteristic{characteristic, in.property()};
}

Out declaration(In in) {
  const auto* name = in.peek<StructuralBuilder::Name>();
  if (name == nullptr || !name->typed) in.wrong("a word such as Class(...)");
  const EntityKind kind = name->kind;
  return Declaration{kind, in.entity(kind)};
}

/// The properties stand in two brackets, or (OWL/XML) one behind the other with their kinds.
Out has_key(In in) {
  HasKey key{in.class_expression(), {}, {}};
  if (!in.peek<StructuralBuilder::Properties>()) {
    while (!in.at_end()) {
      const auto* name = in.peek<StructuralBuilder::Name>();
      if (name != nullptr && name->typed && name->kind == EntityKind::DataProperty)
        key.data_properties.push_back(in.data_property());
      else
        key.object_properties.push_back(in.property());
    }
    return key;
  }
  key.object_properties = in.take<StructuralBuilder::Properties>().members;
  for (const ObjectProperty p : key.object_properties) in.names().use(EntityKind::ObjectProperty, p.iri);
  if (!in.peek<StructuralBuilder::Properties>()) in.wrong("a bracket with data properties");
  for (const ObjectProperty p : in.take<StructuralBuilder::Properties>().members) {
    in.names().use(EntityKind::DataProperty, p.iri);
    key.data_properties.push_back(p.iri);
  }
  return key;
}

Out object_assertion(In in, bool negative) {
  const ObjectProperty property = in.property();
  const Iri source = in.individual();
  return ObjectPropertyAssertion{property, source, in.individual(), negative};
}

Out data_assertion(In in, bool negative) {
  const Iri property = in.data_property();
  const Iri source = in.individual();
  return DataPropertyAssertion{property, source, in.literal(), negative};
}

struct Row {
  std::string_view word;
  Out (*build)(In);
};

constexpr auto data = EntityKind::DataProperty;
constexpr auto individual = EntityKind::NamedIndividual;

constexpr std::array rows = {
    Row{"Declaration", declaration},
    Row{"SubClassOf",
        [](In in) -> Out {
          return SubClassOf{in.class_expression(), in.class_expression()};
        }},
    Row{"EquivalentClasses", [](In in) -> Out { return EquivalentClasses{in.classes(2)}; }},
    Row{"DisjointClasses", [](In in) -> Out { return DisjointClasses{in.classes(2)}; }},
    Row{"DisjointUnion",
        [](In in) -> Out {
          return DisjointUnion{in.named_class(), in.classes(1)};
        }},
    Row{"SubObjectPropertyOf",
        [](In in) -> Out {
          return SubObjectPropertyOf{in.chain(), in.property()};
        }},
    Row{"EquivalentObjectProperties",
        [](In in) -> Out { return EquivalentObjectProperties{in.properties(2)}; }},
    Row{"DisjointObjectProperties", [](In in) -> Out { return DisjointObjectProperties{in.properties(2)}; }},
    Row{"InverseObjectProperties",
        [](In in) -> Out {
          return InverseObjectProperties{in.property(), in.property()};
        }},
    Row{"ObjectPropertyDomain",
        [](In in) -> Out {
          return ObjectPropertyDomain{in.property(), in.class_expression()};
        }},
    Row{"ObjectPropertyRange",
        [](In in) -> Out {
          return ObjectPropertyRange{in.property(), in.class_expression()};
        }},
    Row{"FunctionalObjectProperty", having<Characteristic::Functional>},
    Row{"InverseFunctionalObjectProperty", having<Characteristic::InverseFunctional>},
    Row{"ReflexiveObjectProperty", having<Characteristic::Reflexive>},
    Row{"IrreflexiveObjectProperty", having<Characteristic::Irreflexive>},
    Row{"SymmetricObjectProperty", having<Characteristic::Symmetric>},
    Row{"AsymmetricObjectProperty", having<Characteristic::Asymmetric>},
    Row{"TransitiveObjectProperty", having<Characteristic::Transitive>},
    Row{"SubDataPropertyOf",
        [](In in) -> Out {
          return SubDataPropertyOf{in.data_property(), in.data_property()};
        }},
    Row{"EquivalentDataProperties",
        [](In in) -> Out { return EquivalentDataProperties{in.entities(data, 2)}; }},
    Row{"DisjointDataProperties", [](In in) -> Out { return DisjointDataProperties{in.entities(data, 2)}; }},
    Row{"DataPropertyDomain",
        [](In in) -> Out {
          return DataPropertyDomain{in.data_property(), in.class_expression()};
        }},
    Row{"DataPropertyRange",
        [](In in) -> Out {
          return DataPropertyRange{in.data_property(), in.range()};
        }},
    Row{"FunctionalDataProperty", [](In in) -> Out { return FunctionalDataProperty{in.data_property()}; }},
    Row{"DatatypeDefinition",
        [](In in) -> Out {
          return DatatypeDefinition{in.entity(EntityKind::Datatype), in.range()};
        }},
    Row{"HasKey", has_key},
    Row{"SameIndividual", [](In in) -> Out { return SameIndividual{in.entities(individual, 2)}; }},
    Row{"DifferentIndividuals",
        [](In in) -> Out { return DifferentIndividuals{in.entities(individual, 2)}; }},
    Row{"ClassAssertion",
        [](In in) -> Out {
          return ClassAssertion{in.class_expression(), in.individual()};
        }},
    Row{"ObjectPropertyAssertion", [](In in) { return object_assertion(in, false); }},
    Row{"NegativeObjectPropertyAssertion", [](In in) { return object_assertion(in, true); }},
    Row{"DataPropertyAssertion", [](In in) { return data_assertion(in, false); }},
    Row{"NegativeDataPropertyAssertion", [](In in) { return data_assertion(in, true); }},
    Row{"AnnotationAssertion",
        [](In in)
            -> Out { return AnnotationAssertion{in.annotation_property(), in.iri(), in.annotation_value()}; }},
    Row{"SubAnnotationPropertyOf",
        [](In in)
            -> Out { return SubAnnotationPropertyOf{in.annotation_property(), in.annotation_property()}; }},
    Row{"AnnotationPropertyDomain",
        [](In in) -> Out { return AnnotationPropertyDomain{in.annotation_property(), in.iri()}; }},
    Row{"AnnotationPropertyRange", [](In in) -> Out {
          return AnnotationPropertyRange{in.annotation_property(), in.iri()};
        }}};

}  // namespace

const std::vector<std::string_view>& axiom_words() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> out;
    for (const Row& row : rows) out.push_back(row.word);
    return out;
  }();
  return words;
}

AxiomContent build_axiom(unsigned word, Arguments& arguments) {
  return rows[word].build(arguments);
}

}  // namespace heed::owl
