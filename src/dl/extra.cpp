#include "extra.h"

namespace heed::dl {

Concept ExtraTheory::find(ConceptNode node) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].kind == node.kind && nodes_[i].a == node.a && nodes_[i].b == node.b)
      return static_cast<Concept>(base_.size() + i);
  return nothing_known;
}

Concept ExtraTheory::intern(ConceptNode node) {
  const Concept known = base_.find(node);
  const bool is_name = node.kind == ConceptKind::Class || node.kind == ConceptKind::Individual ||
                       node.kind == ConceptKind::Data;
  if (known != nothing_known && (is_name || known <= bottom || base_.node(known).right)) return known;
  if (const Concept mine = find(node); mine != nothing_known) return mine;
  nodes_.push_back(node);
  const auto out = static_cast<Concept>(base_.size() + nodes_.size() - 1);
  if (node.kind == ConceptKind::Not) negations_.emplace_back(node.a, out);
  if (node.kind == ConceptKind::All && node.a < base_.role_count())
    for (const Role role : base_.transitive_below(node.a)) intern({ConceptKind::All, role, node.b});
  return out;
}

Role ExtraTheory::role_of(owl::Iri iri, bool data) {
  const Role known = base_.role(iri, data);
  if (known != nothing_known) return known;
  const auto next = static_cast<Role>(base_.role_count() + 2 * roles_.size());
  return roles_.try_emplace((std::uint64_t{iri.id} << 1) | (data ? 1U : 0U), next).first->second;
}

Concept ExtraTheory::data(const std::string& key) {
  const Concept known = base_.data_concept(key);
  if (known != nothing_known) return known;
  const auto number = UINT32_MAX - 1 - static_cast<std::uint32_t>(data_.size());
  return intern({ConceptKind::Data, data_.try_emplace(key, number).first->second, 0});
}

/// A literal that the theory does not know still has its datatype.
Concept ExtraTheory::literal(const owl::Literal& literal) {
  const Theory::DataKey key = Theory::key_of(literal);
  const bool known = base_.data_concept(key.text) != nothing_known;
  const Concept value = data(key.text);
  return known ? value : conjunction({value, data_range(owl::DataRange::datatype(key.datatype))});
}

Concept ExtraTheory::data_range(const owl::DataRange& range) {
  const std::string key = Theory::key_of(range);
  return key.empty() ? top : data(key);
}

}  // namespace heed::dl
