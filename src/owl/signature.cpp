#include <heed/owl/signature.h>
#include <heed/owl/vocabulary.h>

#include <algorithm>

namespace heed::owl {
namespace {

class Collector {
 public:
  std::vector<Iri> done() {
    std::sort(names_.begin(), names_.end());
    names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
    names_.erase(names_.begin(), std::lower_bound(names_.begin(), names_.end(), Iri{vocabulary::size}));
    return std::move(names_);
  }

  void operator()(const Declaration& a) { add(a.entity); }
  void operator()(const SubClassOf& a) { add(a.sub), add(a.super); }
  void operator()(const EquivalentClasses& a) { add(a.classes); }
  void operator()(const DisjointClasses& a) { add(a.classes); }
  void operator()(const DisjointUnion& a) { add(a.whole), add(a.parts); }
  void operator()(const SubObjectPropertyOf& a) { add(a.chain), add(a.super); }
  void operator()(const EquivalentObjectProperties& a) { add(a.properties); }
  void operator()(const DisjointObjectProperties& a) { add(a.properties); }
  void operator()(const InverseObjectProperties& a) { add(a.first), add(a.second); }
  void operator()(const ObjectPropertyDomain& a) { add(a.property), add(a.domain); }
  void operator()(const ObjectPropertyRange& a) { add(a.property), add(a.range); }
  void operator()(const ObjectPropertyCharacteristic& a) { add(a.property); }
  void operator()(const SubDataPropertyOf& a) { add(a.sub), add(a.super); }
  void operator()(const EquivalentDataProperties& a) { add(a.properties); }
  void operator()(const DisjointDataProperties& a) { add(a.properties); }
  void operator()(const DataPropertyDomain& a) { add(a.property), add(a.domain); }
  void operator()(const DataPropertyRange& a) { add(a.property), add(a.range); }
  void operator()(const FunctionalDataProperty& a) { add(a.property); }
  void operator()(const DatatypeDefinition& a) { add(a.datatype), add(a.range); }
  void operator()(const HasKey& a) { add(a.of), add(a.object_properties), add(a.data_properties); }
  void operator()(const SameIndividual& a) { add(a.individuals); }
  void operator()(const DifferentIndividuals& a) { add(a.individuals); }
  void operator()(const ClassAssertion& a) { add(a.of), add(a.individual); }
  void operator()(const ObjectPropertyAssertion& a) { add(a.property), add(a.source), add(a.target); }
  void operator()(const DataPropertyAssertion& a) { add(a.property), add(a.source), add(a.value.datatype); }
  void operator()(const AnnotationAssertion& a) { add(a.property), add(a.subject); }
  void operator()(const SubAnnotationPropertyOf& a) { add(a.sub), add(a.super); }
  void operator()(const AnnotationPropertyDomain& a) { add(a.property), add(a.domain); }
  void operator()(const AnnotationPropertyRange& a) { add(a.property), add(a.range); }

  void add(const ClassExpression& expression) {
    std::vector<const ClassExpression*> open = {&expression};
    while (!open.empty()) {
      const ClassExpression& e = *open.back();
      open.pop_back();
      using Kind = ClassExpression::Kind;
      if (e.is_named()) add(e.iri());
      const bool object = (e.kind() >= Kind::Some && e.kind() <= Kind::Exactly);
      if (object) add(e.property());
      add(e.individuals());
      if (e.kind() >= Kind::DataSome && e.kind() != Kind::DataHasValue) add(e.range());
      for (const ClassExpression& operand : e.operands()) open.push_back(&operand);
    }
  }

 private:
  void add(Iri iri) { names_.push_back(iri); }
  void add(ObjectProperty property) { names_.push_back(property.iri); }
  void add(const DataRange& range) {
    std::vector<const DataRange*> open = {&range};
    while (!open.empty()) {
      const DataRange& r = *open.back();
      open.pop_back();
      add(r.iri());
      for (const DataRange& operand : r.operands()) open.push_back(&operand);
    }
  }
  template <class T>
  void add(const std::vector<T>& parts) {
    for (const T& part : parts) add(part);
  }

  std::vector<Iri> names_;
};

}  // namespace

std::vector<Iri> signature(const AxiomContent& axiom) {
  Collector collector;
  std::visit(collector, axiom);
  return collector.done();
}

std::vector<Iri> signature(const ClassExpression& expression) {
  Collector collector;
  collector.add(expression);
  return collector.done();
}

}  // namespace heed::owl
