#include "entailment.h"

#include "question.h"

#include <heed/owl/vocabulary.h>

namespace heed::dl {
namespace {

using owl::ClassExpression;

class Entailment {
 public:
  Entailment(const Saturation& base, util::Budget& budget) : base_(base), budget_(budget) {}

  bool operator()(const owl::Declaration&) { return true; }
  bool operator()(const owl::SubClassOf& a) { return below(a.sub, a.super); }
  bool operator()(const owl::EquivalentClasses& a) {
    for (std::size_t i = 0; i + 1 < a.classes.size(); ++i)
      if (!below(a.classes[i], a.classes[i + 1]) || !below(a.classes[i + 1], a.classes[i])) return false;
    return true;
  }
  bool operator()(const owl::DisjointClasses& a) { return disjoint(a.classes); }
  bool operator()(const owl::DisjointUnion& a) {
    const ClassExpression whole = ClassExpression::named(a.whole);
    const ClassExpression parts = ClassExpression::union_of(a.parts);
    return disjoint(a.parts) && below(whole, parts) && below(parts, whole);
  }
  bool operator()(const owl::SubObjectPropertyOf& a) { return ask().role_inclusion(a.chain, a.super); }
  bool operator()(const owl::EquivalentObjectProperties& a) {
    for (std::size_t i = 0; i + 1 < a.properties.size(); ++i)
      if (!ask().role_inclusion({a.properties[i]}, a.properties[i + 1]) ||
          !ask().role_inclusion({a.properties[i + 1]}, a.properties[i]))
        return false;
    return true;
  }
  bool operator()(const owl::InverseObjectProperties& a) {
    const owl::ObjectProperty second{a.second.iri, !a.second.inverse};
    return ask().role_inclusion({a.first}, second) && ask().role_inclusion({second}, a.first);
  }
  bool operator()(const owl::ObjectPropertyDomain& a) {
    return below(ClassExpression::some(a.property, ClassExpression::thing()), a.domain);
  }
  bool operator()(const owl::ObjectPropertyRange& a) {
    return below(ClassExpression::thing(), ClassExpression::only(a.property, a.range));
  }
  bool operator()(const owl::ObjectPropertyCharacteristic& a) {
    const owl::ObjectProperty against{a.property.iri, !a.property.inverse};
    switch (a.characteristic) {
      case owl::Characteristic::Functional:
        return ask().functional(a.property);
      case owl::Characteristic::InverseFunctional:
        return ask().functional(against);
      case owl::Characteristic::Transitive:
        return ask().role_inclusion({a.property, a.property}, a.property);
      case owl::Characteristic::Symmetric:
        return ask().role_inclusion({a.property}, against);
      case owl::Characteristic::Reflexive:
        return below(ClassExpression::thing(), ClassExpression::has_self(a.property));
      default:
        return base_.inconsistent();
    }
  }
  bool operator()(const owl::SubDataPropertyOf& a) { return ask().data_role_inclusion(a.sub, a.super); }
  bool operator()(const owl::DataPropertyDomain& a) {
    using Kind = ClassExpression::Kind;
    const auto any = owl::DataRange::datatype(literal_type);
    return below(ClassExpression::data_quantified(Kind::DataSome, {a.property}, any), a.domain);
  }
  bool operator()(const owl::DataPropertyRange& a) {
    using Kind = ClassExpression::Kind;
    return below(ClassExpression::thing(),
                 ClassExpression::data_quantified(Kind::DataOnly, {a.property}, a.range));
  }
  bool operator()(const owl::SameIndividual& a) {
    for (std::size_t i = 0; i + 1 < a.individuals.size(); ++i)
      if (!ask().type(a.individuals[i], ClassExpression::one_of({a.individuals[i + 1]}))) return false;
    return true;
  }
  bool operator()(const owl::DifferentIndividuals& a) {
    for (std::size_t i = 0; i < a.individuals.size(); ++i)
      for (std::size_t j = i + 1; j < a.individuals.size(); ++j) {
        const auto other = ClassExpression::complement(ClassExpression::one_of({a.individuals[j]}));
        if (!ask().type(a.individuals[i], other)) return false;
      }
    return true;
  }
  bool operator()(const owl::ClassAssertion& a) { return ask().type(a.individual, a.of); }
  bool operator()(const owl::ObjectPropertyAssertion& a) {
    const auto value = ClassExpression::has_value(a.property, a.target);
    return ask().type(a.source, a.negative ? ClassExpression::complement(value) : value);
  }
  bool operator()(const owl::DataPropertyAssertion& a) {
    const auto value = ClassExpression::data_has_value(a.property, a.value);
    return ask().type(a.source, a.negative ? ClassExpression::complement(value) : value);
  }
  /// Keys, disjoint properties, datatypes and annotations are outside of what is reasoned about.
  template <class Other>
  bool operator()(const Other&) {
    return base_.inconsistent();
  }

 private:
  static constexpr owl::Iri literal_type = owl::vocabulary::rdfs_literal;
  Question ask() { return {base_, budget_}; }
  bool below(const ClassExpression& sub, const ClassExpression& super) {
    return ask().subsumption(sub, super);
  }
  bool disjoint(const std::vector<ClassExpression>& classes) {
    for (std::size_t i = 0; i < classes.size(); ++i)
      for (std::size_t j = i + 1; j < classes.size(); ++j)
        if (ask().satisfiable(ClassExpression::intersection({classes[i], classes[j]}))) return false;
    return true;
  }

  const Saturation& base_;
  util::Budget& budget_;
};

}  // namespace

bool is_entailed(const owl::AxiomContent& axiom, const Saturation& base, util::Budget& budget) {
  return std::visit(Entailment(base, budget), axiom);
}

}  // namespace heed::dl
