#include "theory.h"

#include "theory_builder.h"

#include <heed/owl/signature.h>
#include <heed/owl/vocabulary.h>
#include <heed/util/hash.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::dl {

namespace v = owl::vocabulary;

std::size_t Theory::NodeHash::operator()(const ConceptNode& node) const {
  return util::mix(static_cast<std::uint64_t>(node.kind), (std::uint64_t{node.a} << 32) | node.b);
}

Theory::Theory(const owl::Ontology& ontology, const std::vector<owl::AxiomId>* ids) {
  TheoryBuilder builder(*this, ontology);
  if (ids == nullptr) {
    for (const owl::Axiom& axiom : ontology.axioms()) builder.add(axiom);
  } else {
    for (const owl::AxiomId id : *ids) builder.add(ontology.axiom(id));
  }
  builder.finish();
}

Concept Theory::find(ConceptNode node) const {
  const auto found = numbers_.find(node);
  return found == numbers_.end() ? nothing_known : found->second;
}

Role Theory::role(owl::Iri iri, bool data) const {
  const auto found = roles_.find((std::uint64_t{iri.id} << 1) | (data ? 1U : 0U));
  return found == roles_.end() ? nothing_known : found->second;
}

Concept Theory::data_concept(const std::string& key) const {
  const auto found = data_.find(key);
  return found == data_.end() ? nothing_known : find({ConceptKind::Data, found->second, 0});
}

/// Integers and Booleans by value, strings by text, everything else by text and datatype. Families hold
/// literals that are equal only when their texts are.
Theory::DataKey Theory::key_of(const owl::Literal& literal) {
  std::string_view text = literal.value;
  const bool integer = literal.datatype == v::xsd_integer || literal.datatype == v::xsd_non_negative_integer;
  if (integer) {
    const bool minus = !text.empty() && text.front() == '-';
    if (!text.empty() && (minus || text.front() == '+')) text.remove_prefix(1);
    const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    text.remove_prefix(std::min(text.find_first_not_of('0'), text.empty() ? 0 : text.size() - 1));
    const bool zero = text == "0";
    if (digits)
      return {fmt::format("integer {}{}", minus && !zero ? "-" : "", text), "integer", literal.datatype};
  }
  if (literal.datatype == v::xsd_boolean && (text == "true" || text == "1" || text == "false" || text == "0"))
    return {text == "true" || text == "1" ? "boolean true" : "boolean false", "boolean", literal.datatype};
  if (literal.datatype == v::xsd_string) return {fmt::format("string {}", text), "string", literal.datatype};
  return {fmt::format("literal {} {} {}", literal.datatype.id, literal.language, text), "", literal.datatype};
}

/// Empty for rdfs:Literal, of which every literal is. Readers bound the nesting of data ranges.
std::string Theory::key_of(const owl::DataRange& range) {
  using Kind = owl::DataRange::Kind;
  if (range.kind() == Kind::Datatype && range.iri() == v::rdfs_literal) return {};
  std::string out = fmt::format("range {} {}", static_cast<int>(range.kind()), range.iri().id);
  for (const auto& operand : range.operands()) out += fmt::format("({})", key_of(operand));
  for (const auto& literal : range.literals()) out += fmt::format("({})", key_of(literal).text);
  for (const auto& facet : range.facets())
    out += fmt::format("({} {})", facet.facet.id, key_of(facet.value).text);
  return out;
}

void TheoryBuilder::finish() {
  close_roles();
  use_inverses();
  transitive_universals();
  spread_chains();
  spread_functional();
  check_chains();
  literal_families();
  auto& dropped = theory_.dropped_;
  for (Dropped& entry : dropped) entry.signature = owl::signature(ontology_.axiom(entry.axiom).content);
  std::stable_sort(dropped.begin(), dropped.end(), [](const Dropped& x, const Dropped& y) {
    return std::tie(x.axiom, x.why) < std::tie(y.axiom, y.why);
  });
  const auto same = [](const Dropped& x, const Dropped& y) { return x.axiom == y.axiom && x.why == y.why; };
  dropped.erase(std::unique(dropped.begin(), dropped.end(), same), dropped.end());
}

void TheoryBuilder::close_roles() {
  const std::size_t count = theory_.role_count();
  theory_.words_ = (count + 63) / 64;
  theory_.closure_.assign(count * theory_.words_, 0);
  theory_.superroles_.resize(count);
  std::vector<Role> open;
  for (Role role = 0; role < count; ++role) {
    auto* const row = theory_.closure_.data() + role * theory_.words_;
    open.assign(1, role);
    row[role / 64] |= std::uint64_t{1} << (role % 64);
    while (!open.empty()) {
      const Role next = open.back();
      open.pop_back();
      theory_.superroles_[role].push_back(next);
      for (const RoleEdge edge : theory_.role_edges_[next]) {
        if ((row[edge.super / 64] >> (edge.super % 64) & 1U) != 0) continue;
        row[edge.super / 64] |= std::uint64_t{1} << (edge.super % 64);
        open.push_back(edge.super);
      }
    }
    std::sort(theory_.superroles_[role].begin(), theory_.superroles_[role].end());
  }
}

/// `D SubClassOf only inverse(R) (R some D)` holds by itself. It is written down where an existential can
/// reach its source against the direction of R, and turns the rule for inverse properties into the one for
/// universals.
void TheoryBuilder::use_inverses() {
  right_roles_.resize(theory_.role_count());
  std::vector<bool> reached(theory_.role_count());
  for (Role role = 0; role < theory_.role_count(); ++role)
    if (right_roles_[role])
      for (const Role super : theory_.superroles_[role]) reached[super] = true;
  for (const Chain& c : chains_)
    if (reached[c.first] && reached[c.second])
      for (const Role super : theory_.superroles_[c.super]) reached[super] = true;
  for (Concept filler = 0; filler < theory_.left_.size(); ++filler) {
    const auto entries = theory_.left_[filler];
    for (const LeftExistential entry : entries) {
      if (!reached[inverse(entry.role)]) continue;
      const Concept universal = all(inverse(entry.role), entry.existential);
      theory_.told_[filler].push_back({universal, 0});
      place_right(universal);
      place();
    }
  }
}

void TheoryBuilder::transitive_universals() {
  theory_.transitive_below_.resize(theory_.role_count());
  for (Role role = 0; role < theory_.role_count(); ++role)
    if (theory_.transitive_[role] != nothing_known)
      for (const Role super : theory_.superroles_[role]) theory_.transitive_below_[super].push_back(role);
  for (Concept c = 0; c < theory_.concepts_.size(); ++c) {
    const ConceptNode node = theory_.concepts_[c];
    if (node.kind != ConceptKind::All || !node.right) continue;
    for (const Role role : theory_.transitive_below_[node.a]) place_right(all(role, node.b));
    place();
  }
}

void TheoryBuilder::spread_chains() {
  theory_.chains_from_.resize(theory_.role_count());
  theory_.chains_into_.resize(theory_.role_count());
  right_roles_.resize(theory_.role_count());
  bool against = false;
  for (Role role = 1; role < theory_.role_count(); role += 2) {
    against |= right_roles_[role];
    for (const RoleEdge edge : theory_.role_edges_[role]) against |= edge.super % 2 == 0;
  }
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    if (i % 2 == 1 && !against) continue;
    for (Role role = 0; role < theory_.role_count(); ++role) {
      if (theory_.is_subrole(role, chains_[i].first)) theory_.chains_from_[role].push_back(chains_[i]);
      if (theory_.is_subrole(role, chains_[i].second)) theory_.chains_into_[role].push_back(chains_[i]);
    }
  }
}

void TheoryBuilder::spread_functional() {
  theory_.has_functional_.resize(theory_.role_count());
  for (Role role = 0; role < theory_.role_count(); ++role)
    for (const Role super : theory_.superroles_[role])
      if (theory_.functional_[super] != nothing_known) theory_.has_functional_[role] = true;
  for (const auto& [axiom, role] : functional_axioms_) {
    bool against = false;
    for (Role sub = 0; sub < theory_.role_count(); ++sub)
      against |= right_roles_[sub] && theory_.is_subrole(sub, inverse(role));
    axiom_ = axiom;
    if (against) drop("a functional property does not merge a successor with the predecessor");
  }
}

/// A range of the composed property says something of the end of the chain that its last property may not
/// say.
void TheoryBuilder::check_chains() {
  for (std::size_t i = 0; i < chains_.size(); i += 2) {
    const Chain& c = chains_[i];
    bool lost = false;
    for (const Role super : theory_.superroles_[c.super])
      if (!theory_.is_subrole(c.second, super)) lost |= !theory_.ranges_[super].empty();
    for (Concept n = 0; n < theory_.concepts_.size() && !lost; ++n) {
      const ConceptNode& node = theory_.concepts_[n];
      if (node.kind != ConceptKind::All || !node.right || !theory_.is_subrole(c.super, node.a)) continue;
      lost = c.first != c.second || c.second != c.super;
    }
    if (!lost || c.reason == 0) continue;
    axiom_ = &ontology_.axiom(owl::AxiomId{c.reason});
    drop("ranges and universal restrictions do not reach over a property chain");
  }
}

void TheoryBuilder::literal_families() {
  axiom_ = nullptr;
  reason_ = 0;
  for (const auto& family : families_) disjoint(family.second);
}

}  // namespace heed::dl
