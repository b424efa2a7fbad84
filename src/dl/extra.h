#pragma once

#include "theory.h"
#include "translate.h"

#include <unordered_map>
#include <vector>

namespace heed::dl {

/// Names for the parts of a question that the theory does not have on the right. They number on from the
/// theory's.
class ExtraTheory : public ConceptSink {
 public:
  explicit ExtraTheory(const Theory& base) : base_(base) {}

  Concept intern(ConceptNode node) override;
  Role role_of(owl::Iri iri, bool data) override;
  using ConceptSink::role_of;
  Concept literal(const owl::Literal& literal) override;
  Concept data_range(const owl::DataRange& range) override;
  Concept literal_alone(const owl::Literal& literal) { return data(Theory::key_of(literal).text); }

  [[nodiscard]] const ConceptNode& node(Concept c) const { return nodes_[c - base_.size()]; }
  [[nodiscard]] Concept find(ConceptNode node) const;
  /// Negated concept and its negation.
  [[nodiscard]] const std::vector<std::pair<Concept, Concept>>& negations() const { return negations_; }

 protected:
  [[nodiscard]] const ConceptNode& node_of(Concept c) const override {
    return c < base_.size() ? base_.node(c) : node(c);
  }

 private:
  Concept data(const std::string& key);

  const Theory& base_;
  std::vector<ConceptNode> nodes_;
  std::unordered_map<std::uint64_t, Role> roles_;
  std::unordered_map<std::string, std::uint32_t> data_;
  std::vector<std::pair<Concept, Concept>> negations_;
};

}  // namespace heed::dl
