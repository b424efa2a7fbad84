#pragma once

#include "theory.h"

#include <heed/owl/expression.h>

#include <functional>

namespace heed::dl {

/// Where expressions become concepts: the theory while it is built, or a question over a finished one.
class ConceptSink {
 public:
  virtual ~ConceptSink() = default;
  virtual Concept intern(ConceptNode node) = 0;
  virtual Role role_of(owl::Iri iri, bool data) = 0;
  virtual Concept literal(const owl::Literal& literal) = 0;
  virtual Concept data_range(const owl::DataRange& range) = 0;

  /// Translates without recursion over the depth of \p expression.
  Concept translate(const owl::ClassExpression& expression);

  Concept conjunction(std::vector<Concept> parts);
  Concept disjunction(std::vector<Concept> parts);
  Concept negation(Concept c);
  Concept some(Role role, Concept filler);
  Concept all(Role role, Concept filler);
  Role role_of(owl::ObjectProperty property) {
    const Role role = role_of(property.iri, false);
    return property.inverse ? inverse(role) : role;
  }

 protected:
  [[nodiscard]] virtual const ConceptNode& node_of(Concept c) const = 0;

 private:
  Concept build(const owl::ClassExpression& e, const std::vector<Concept>& parts);
  Concept counted(const owl::ClassExpression& e, Concept existential, bool unqualified, Role role);
};

}  // namespace heed::dl
