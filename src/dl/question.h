#pragma once

#include "extra.h"
#include "saturation.h"

#include <heed/owl/axiom.h>

#include <optional>
#include <vector>

namespace heed::dl {

/// One question over a finished saturation. Everything new lives here and goes with it.
class Question {
 public:
  Question(const Saturation& base, util::Budget& budget)
      : base_(base), extra_(base.theory()), saturation_(base, extra_, budget) {}

  /// The context of the things that are \p sub.
  ContextId context_of(const owl::ClassExpression& sub);
  [[nodiscard]] const Context& at(ContextId id) const { return saturation_.at(id); }
  bool satisfiable(const owl::ClassExpression& expression);
  bool subsumption(const owl::ClassExpression& sub, const owl::ClassExpression& super);
  bool type(owl::Iri individual, const owl::ClassExpression& of);
  /// The composition of \p chain is below \p super.
  bool role_inclusion(const std::vector<owl::ObjectProperty>& chain, owl::ObjectProperty super);
  bool data_role_inclusion(owl::Iri sub, owl::Iri super);
  bool functional(owl::ObjectProperty property);

  /// The axioms behind the last answer `true`. \pre the base records derivations
  [[nodiscard]] std::vector<owl::AxiomId> axioms() const { return saturation_.axioms_of(facts_); }

 private:
  bool ask(const std::vector<Concept>& core, const owl::ClassExpression& super);
  bool ask_simple(const std::vector<Concept>& core, const owl::ClassExpression& super);
  bool ask_universal(std::vector<Concept> core, Role role, const owl::ClassExpression* filler, Concept value);
  bool holds(ContextId x, const owl::ClassExpression& e);
  bool holds_every(ContextId x, const std::vector<owl::ClassExpression>& parts);
  bool holds_concept(ContextId x, Concept c);
  bool holds_link(ContextId x, Role role, const owl::ClassExpression* filler, Concept value);
  bool holds_count(ContextId x, const owl::ClassExpression& e);
  bool holds_self(ContextId x, Role role);
  bool holds_at_most(ContextId x, Role role);
  bool unsatisfiable(ContextId x);
  ContextId saturated(std::vector<Concept> core);
  Concept fresh();

  const Saturation& base_;
  ExtraTheory extra_;
  Saturation saturation_;
  std::vector<Fact> facts_;
  std::uint32_t fresh_count_ = 0;
};

}  // namespace heed::dl
