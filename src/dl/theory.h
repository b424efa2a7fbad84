#pragma once

#include <heed/dl/reasoner.h>
#include <heed/owl/ontology.h>

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace heed::dl {

/// A concept of the theory: a name, or a part of an expression that got a number of its own.
using Concept = std::uint32_t;
/// An object property (even number), its inverse (the odd number behind), or a data property (even).
using Role = std::uint32_t;
constexpr std::uint32_t nothing_known = UINT32_MAX;

[[nodiscard]] constexpr Role inverse(Role role) {
  return role ^ 1U;
}

enum class ConceptKind : std::uint8_t {
  Top,
  Bottom,
  Class,       ///< a: Iri
  Individual,  ///< a: Iri. The nominal {a}.
  Data,        ///< a: number of the data range or literal
  And,         ///< a, b
  Or,          ///< a, b
  Not,         ///< a
  Some,        ///< a: role, b: filler
  All,         ///< a: role, b: filler
  AtMostOne,   ///< a: role. Unqualified.
  AtLeast,     ///< a: Some(role, filler), b: n >= 2
  AtMost,      ///< a: Some(role, filler), b: n >= 1. Nothing follows from it here.
  Self,        ///< a: role
  Unknown      ///< Stands for what has no translation.
};

constexpr Concept top = 0;
constexpr Concept bottom = 1;

/// Why an axiom is not used in full; a set of these.
enum Loss : std::uint16_t {
  NoLoss = 0,
  UnionRight = 1 << 0,
  ComplementLeft = 1 << 1,
  UniversalLeft = 1 << 2,
  NumberRight = 1 << 3,
  NumberLeft = 1 << 4,
  DataRangeLoss = 1 << 5,
  SelfLeft = 1 << 6,
  KindLoss = 1 << 7,
  ChainRange = 1 << 8,
  InverseFunctionality = 1 << 9
};

struct ConceptNode {
  ConceptKind kind;
  std::uint32_t a = 0, b = 0;
  std::uint16_t loss_right = 0,
                loss_left = 0;       ///< What is lost where it stands right or left of an inclusion.
  bool right = false, left = false;  ///< Where it stands.
};

/// Tells why: 0 for a tautology, else the number of an axiom.
using Reason = std::uint32_t;

struct Told {
  Concept super;
  Reason reason;
};
struct Conjunction {
  Concept other, result;
};
struct LeftExistential {
  Role role;
  Concept existential;
};
struct Chain {
  Role first, second, super;
  Reason reason;
};
struct Membership {
  std::uint32_t group;
  Reason reason;
};
struct RoleEdge {
  Role super;
  Reason reason;
};

/// An ontology in the form that saturation works on: each part of an expression is a concept, `C SubClassOf
/// D` is one told inclusion, and the parts follow their own definitions (conjunctions, existentials) that
/// hold by name alone. So a derivation names exactly the axioms it needs.
class Theory {
 public:
  /// \param ids  The axioms to use, or nullptr for all.
  Theory(const owl::Ontology& ontology, const std::vector<owl::AxiomId>* ids);

  [[nodiscard]] std::size_t size() const { return concepts_.size(); }
  [[nodiscard]] const ConceptNode& node(Concept c) const { return concepts_[c]; }
  [[nodiscard]] Concept class_concept(owl::Iri iri) const { return find({ConceptKind::Class, iri.id, 0}); }
  [[nodiscard]] Concept individual_concept(owl::Iri iri) const {
    return find({ConceptKind::Individual, iri.id, 0});
  }
  [[nodiscard]] Concept find(ConceptNode node) const;
  /// nothing_known where the ontology does not use it.
  [[nodiscard]] Role role(owl::Iri iri, bool data) const;
  [[nodiscard]] Concept data_concept(const std::string& key) const;

  [[nodiscard]] const std::vector<Told>& told(Concept c) const { return told_[c]; }
  [[nodiscard]] const std::vector<Conjunction>& conjunctions(Concept c) const { return conjunctions_[c]; }
  [[nodiscard]] const std::vector<LeftExistential>& left(Concept c) const { return left_[c]; }
  /// Complements and universals that matter on the left for what is \p c, as they stand beside it in a
  /// conjunction.
  [[nodiscard]] const std::vector<Concept>& goals(Concept c) const { return goals_[c]; }
  /// What a complement or universal on the left denies.
  [[nodiscard]] Concept denied(Concept goal) const {
    const auto found = denied_.find(goal);
    return found == denied_.end() ? nothing_known : found->second;
  }
  [[nodiscard]] const std::vector<Membership>& groups(Concept c) const { return groups_[c]; }
  [[nodiscard]] const std::vector<Concept>& individuals() const { return individuals_; }
  /// Minimum cardinalities from 2 that stand on the left.
  [[nodiscard]] const std::vector<Concept>& counted() const { return counted_; }

  [[nodiscard]] std::size_t role_count() const { return role_edges_.size(); }
  [[nodiscard]] bool is_subrole(Role sub, Role super) const {
    return closure_[sub * words_ + super / 64] >> (super % 64) & 1U;
  }
  [[nodiscard]] const std::vector<Role>& superroles(Role role) const {
    return superroles_[role];
  }  ///< Itself included.
  [[nodiscard]] const std::vector<RoleEdge>& role_edges(Role role) const { return role_edges_[role]; }
  [[nodiscard]] const std::vector<Told>& domains(Role role) const {
    return domains_[role];
  }  ///< Told of it alone.
  [[nodiscard]] const std::vector<Told>& ranges(Role role) const { return ranges_[role]; }
  [[nodiscard]] Reason functional(Role role) const {
    return functional_[role];
  }  ///< nothing_known: it is not.
  [[nodiscard]] bool has_functional(Role role) const {
    return has_functional_[role];
  }  ///< It or a super-role.
  [[nodiscard]] const std::vector<Chain>& chains_from(Role first) const { return chains_from_[first]; }
  [[nodiscard]] const std::vector<Chain>& chains_into(Role second) const { return chains_into_[second]; }
  /// Transitive roles below \p role: a universal restriction goes on along them.
  [[nodiscard]] const std::vector<Role>& transitive_below(Role role) const { return transitive_below_[role]; }
  [[nodiscard]] Reason transitive(Role role) const { return transitive_[role]; }

  [[nodiscard]] const std::vector<Dropped>& dropped() const { return dropped_; }

  /// A text that is equal for equal values, and whether it is a literal that differs from all others of its
  /// family.
  struct DataKey {
    std::string text, family;
    owl::Iri datatype;
  };
  static DataKey key_of(const owl::Literal& literal);
  static std::string key_of(const owl::DataRange& range);

 private:
  friend class TheoryBuilder;
  struct NodeHash {
    std::size_t operator()(const ConceptNode& node) const;
  };
  struct NodeEqual {
    bool operator()(const ConceptNode& x, const ConceptNode& y) const {
      return x.kind == y.kind && x.a == y.a && x.b == y.b;
    }
  };

  std::vector<ConceptNode> concepts_;
  std::unordered_map<ConceptNode, Concept, NodeHash, NodeEqual> numbers_;
  std::unordered_map<std::string, std::uint32_t> data_;
  std::unordered_map<std::uint64_t, Role> roles_;
  std::vector<std::vector<Told>> told_;
  std::vector<std::vector<Conjunction>> conjunctions_;
  std::vector<std::vector<LeftExistential>> left_;
  std::vector<std::vector<Concept>> goals_;
  std::unordered_map<Concept, Concept> denied_;
  std::vector<std::vector<Membership>> groups_;
  std::vector<Concept> individuals_, counted_;
  std::vector<std::vector<RoleEdge>> role_edges_;
  std::vector<std::uint64_t> closure_;
  std::size_t words_ = 0;
  std::vector<std::vector<Role>> superroles_;
  std::vector<std::vector<Told>> domains_, ranges_;
  std::vector<Reason> functional_, transitive_;
  std::vector<bool> has_functional_;
  std::vector<std::vector<Chain>> chains_from_, chains_into_;
  std::vector<std::vector<Role>> transitive_below_;
  std::vector<Dropped> dropped_;
};

}  // namespace heed::dl
