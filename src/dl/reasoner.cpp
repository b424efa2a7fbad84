#include <heed/dl/reasoner.h>

#include "entailment.h"
#include "question.h"
#include "saturation.h"
#include "taxonomy.h"

#include <heed/owl/vocabulary.h>

#include <algorithm>

namespace heed::dl {

namespace v = owl::vocabulary;

class Reasoner::Impl {
 public:
  Impl(owl::Ontology given, util::Budget& budget)
      : ontology(std::move(given)), theory(ontology, nullptr), base(theory, budget, false) {
    contexts.assign(ontology.iri_count(), nothing_known);
    top_context = base.nonempty_context(top);
    for (const Concept individual : theory.individuals()) base.nonempty_context(individual);
    for (const owl::Iri iri : ontology.entities(owl::EntityKind::Class)) {
      const Concept c = theory.class_concept(iri);
      contexts[iri.id] = c == nothing_known ? top_context : base.context({c});
    }
    base.run();
    classify(budget);
  }

  void classify(util::Budget& budget) {
    const std::vector<owl::Iri> classes = ontology.entities(owl::EntityKind::Class);
    std::vector<std::vector<owl::Iri>> supers(classes.size());
    std::vector<bool> unsatisfiable(classes.size());
    for (std::size_t i = 0; i < classes.size(); ++i) {
      if (i % 256 == 0) budget.check();
      unsatisfiable[i] = base.inconsistent() || base.at(contexts[classes[i].id]).unsatisfiable;
      if (unsatisfiable[i]) continue;
      supers[i] = named(base.at(contexts[classes[i].id]));
      if (theory.class_concept(classes[i]) == nothing_known)
        supers[i].insert(std::upper_bound(supers[i].begin(), supers[i].end(), classes[i]), classes[i]);
    }
    const std::vector<owl::Iri> thing =
        base.inconsistent() ? std::vector<owl::Iri>{} : named(base.at(top_context));
    taxonomy = build_taxonomy(classes, supers, unsatisfiable, thing, ontology.iri_count());
  }

  /// The common questions need nothing new: is a named class below `some R D` with a named D? Nothing where
  /// that cannot be looked up.
  [[nodiscard]] std::optional<bool> look_up(const owl::ClassExpression& sub,
                                            const owl::ClassExpression& super) const {
    if (!sub.is_named() || super.kind() != owl::ClassExpression::Kind::Some || !super.filler().is_named())
      return std::nullopt;
    const bool known = sub.iri().id < contexts.size() && contexts[sub.iri().id] != nothing_known;
    const Role role = theory.role(super.property().iri, false);
    const bool thing = super.filler().is_thing();
    const Concept filler = thing ? top : theory.class_concept(super.filler().iri());
    if (!known || role == nothing_known || filler == nothing_known || base.inconsistent())
      return std::nullopt;
    const Context& x = base.at(contexts[sub.iri().id]);
    const Role wanted = super.property().inverse ? inverse(role) : role;
    return x.unsatisfiable || std::any_of(x.successors.begin(), x.successors.end(), [&](const Link& edge) {
             return base.is_subrole(edge.role, wanted) &&
                    (base.has(edge.other, filler) || base.at(edge.other).unsatisfiable);
           });
  }

  [[nodiscard]] std::vector<owl::Iri> named(const Context& x) const {
    std::vector<owl::Iri> out;
    for (const Concept c : x.subsumers)
      if (c < theory.size() && theory.node(c).kind == ConceptKind::Class)
        out.push_back(owl::Iri{theory.node(c).a});
    std::sort(out.begin(), out.end());
    return out;
  }

  owl::Ontology ontology;
  Theory theory;
  Saturation base;
  std::vector<ContextId> contexts;  ///< By Iri of a class.
  ContextId top_context = 0;
  Taxonomy taxonomy;
};

Reasoner::Reasoner(owl::Ontology ontology, util::Budget& budget)
    : impl_(std::make_unique<Impl>(std::move(ontology), budget)) {}
Reasoner::~Reasoner() = default;
Reasoner::Reasoner(Reasoner&&) noexcept = default;
Reasoner& Reasoner::operator=(Reasoner&&) noexcept = default;

const owl::Ontology& Reasoner::ontology() const {
  return impl_->ontology;
}
bool Reasoner::consistent() const {
  return !impl_->base.inconsistent();
}
const Taxonomy& Reasoner::taxonomy() const {
  return impl_->taxonomy;
}
const std::vector<Dropped>& Reasoner::incomplete() const {
  return impl_->theory.dropped();
}

bool Reasoner::satisfiable(owl::Iri named_class) const {
  if (!consistent() || named_class == v::owl_nothing) return false;
  if (named_class.id >= impl_->contexts.size() || impl_->contexts[named_class.id] == nothing_known)
    return true;
  return !impl_->base.at(impl_->contexts[named_class.id]).unsatisfiable;
}

bool Reasoner::subsumes(owl::Iri super, owl::Iri sub) const {
  if (super == sub || super == v::owl_thing || !satisfiable(sub)) return true;
  const bool known = sub.id < impl_->contexts.size() && impl_->contexts[sub.id] != nothing_known;
  const ContextId x = known ? impl_->contexts[sub.id] : impl_->top_context;
  const Concept c = impl_->theory.class_concept(super);
  return c != nothing_known && impl_->base.has(x, c);
}

std::vector<owl::Iri> Reasoner::superclasses(owl::Iri named_class) const {
  if (!satisfiable(named_class)) return impl_->ontology.entities(owl::EntityKind::Class);
  const bool known =
      named_class.id < impl_->contexts.size() && impl_->contexts[named_class.id] != nothing_known;
  std::vector<owl::Iri> out =
      impl_->named(impl_->base.at(known ? impl_->contexts[named_class.id] : impl_->top_context));
  const auto place = std::lower_bound(out.begin(), out.end(), named_class);
  if (named_class != v::owl_thing && (place == out.end() || *place != named_class))
    out.insert(place, named_class);
  return out;
}

std::vector<owl::Iri> Reasoner::types(owl::Iri individual, bool direct) const {
  if (!consistent()) return impl_->ontology.entities(owl::EntityKind::Class);
  util::Budget budget;
  Question question(impl_->base, budget);
  std::vector<owl::Iri> out =
      impl_->named(question.at(question.context_of(owl::ClassExpression::one_of({individual}))));
  if (!direct) return out;
  const std::vector<owl::Iri> all = out;
  std::erase_if(out, [&](owl::Iri general) {
    return std::any_of(all.begin(), all.end(), [&](owl::Iri special) {
      return subsumes(general, special) && !subsumes(special, general);
    });
  });
  return out;
}

bool Reasoner::satisfiable(const owl::ClassExpression& expression) const {
  util::Budget budget;
  return Question(impl_->base, budget).satisfiable(expression);
}

bool Reasoner::entails_subsumption(const owl::ClassExpression& sub, const owl::ClassExpression& super) const {
  if (sub.is_named() && super.is_named())
    return super.is_nothing() ? !satisfiable(sub.iri()) : subsumes(super.iri(), sub.iri());
  if (const auto known = impl_->look_up(sub, super)) return *known;
  util::Budget budget;
  return Question(impl_->base, budget).subsumption(sub, super);
}

std::optional<std::vector<owl::Iri>> Reasoner::superclasses(const owl::ClassExpression& expression) const {
  util::Budget budget;
  Question question(impl_->base, budget);
  const ContextId x = question.context_of(expression);
  if (!consistent() || question.at(x).unsatisfiable) return std::nullopt;
  return impl_->named(question.at(x));
}

bool Reasoner::entails(const owl::AxiomContent& axiom) const {
  util::Budget budget;
  return is_entailed(axiom, impl_->base, budget);
}

}  // namespace heed::dl
