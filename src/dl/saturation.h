#pragma once

#include "extra.h"
#include "index_set.h"
#include "theory.h"

#include <heed/util/limits.h>

#include <deque>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace heed::dl {

using ContextId = std::uint32_t;
/// A derived statement, where derivations are recorded.
using Fact = std::uint32_t;
constexpr Fact no_fact = UINT32_MAX;

struct Link {
  Role role;
  ContextId other;
  Fact fact;
};

struct Universal {
  Role role;
  Concept filler;
  Fact fact;
};

/// Successors that functional properties make one.
struct Group {
  std::vector<Role> roles, functions;
  std::vector<Concept> core;
  Fact fact = no_fact;
};

/// The things that have all concepts of `core`, and what follows for them.
struct Context {
  std::vector<Concept> core;       ///< Ascending.
  std::vector<Concept> subsumers;  ///< In order of derivation.
  std::vector<Fact> facts;         ///< Beside it, where derivations are recorded.
  IndexSet places;                 ///< Of subsumers.
  std::vector<Concept> fillers;    ///< Those subsumers that some existential on the left has as filler.
  std::vector<Link> successors, predecessors;
  IndexSet successor_places;
  std::vector<Universal> universals;
  std::vector<Group> groups;
  std::vector<std::pair<Role, Fact>> at_most_one;
  std::vector<std::pair<std::uint32_t, Concept>> memberships;
  std::vector<ContextId> mirrors;    ///< Contexts of individuals that this nonempty one equals.
  std::vector<ContextId> followers;  ///< Of an individual: contexts below it.
  std::vector<Concept> mirrored;     ///< Of an individual: what came from a context that equals it.
  std::vector<std::uint32_t> cases;  ///< Places in the list of splits, of which this is a case.
  std::vector<std::uint32_t> tests;  ///< Places in the list of trials, of which this is the context.
  std::uint8_t supposed = 0;         ///< How many suppositions its core holds.
  bool unsatisfiable = false, nonempty = false;
};

/// The things of `whole` are in one of `cases` each.
struct Split {
  ContextId whole;
  Fact fact;  ///< Of the union.
  std::vector<ContextId> cases;
};

/// The things of `whole` are all `goal` when none of them can be in `supposed`.
struct Trial {
  ContextId whole, supposed;
  Concept goal;
};

/// Consequences by rules over contexts until nothing is new. Two uses: the base (a theory, all its contexts)
/// and a question over a finished base, which reads the base's contexts and only ever fills its own.
///
///     X: C,  C [= D told                        =>  X: D
///     X: C and D on the left somewhere          =>  X: C and D
///     X: some R C                               =>  X -R-> {C} + ranges of R
///     X -R-> K, K: C, some S C left, R [= S     =>  X: some S C
///     X -R-> K, X: only S C, R [= S             =>  X -R-> K + C
///     X -R-> K, K: only S C, R [= inverse S     =>  X: C
///     X -R-> K, X -S-> L, R, S [= F functional  =>  X -R-> K + L, X -S-> K + L
///     X -R-> K -S-> L, R o S [= T               =>  X -T-> L
///     X -R-> K, K: bottom                       =>  X: bottom
///     X not empty, X: {a}                       =>  {a}: all that X is
///     X -R-> K1 ... Kn, apart from each other   =>  X: at least n R    (asked when nothing else is left)
///     X: C or D, X + C: E, X + D: E             =>  X: E               (also where a case is impossible)
///     X + C: bottom, not C left                 =>  X: not C           (only S C: X + some S not C)
///
/// The last two suppose something of X in a context of its own. They look ahead only so far: see supposed().
///
/// \cite kazakov.14.jar for the rules of EL, \cite kazakov.09.ijcai for cores that grow (universals,
/// functionality).
class Saturation {
 public:
  Saturation(const Theory& theory, util::Budget& budget, bool trace);
  /// \param base  Finished; outlives this.
  Saturation(const Saturation& base, const ExtraTheory& extra, util::Budget& budget);

  ContextId context(std::vector<Concept> core);
  ContextId nonempty_context(Concept core);
  void run();
  /// Facts for n successors of \p x along \p role that have \p filler and are pairwise apart; nothing when
  /// so many are not known.
  [[nodiscard]] std::optional<Fact> distinct_successors(ContextId x, Role role, Concept filler,
                                                        std::uint32_t n);

  [[nodiscard]] const Context& at(ContextId id) const {
    return id < first_ ? base_->contexts_[id] : contexts_[id - first_];
  }
  [[nodiscard]] const Theory& theory() const { return theory_; }
  [[nodiscard]] bool has(ContextId id, Concept c) const { return place(at(id), c) != IndexSet::none; }
  [[nodiscard]] Fact fact_of(ContextId id, Concept c) const;
  [[nodiscard]] bool inconsistent() const { return base_ != nullptr ? base_->inconsistent_ : inconsistent_; }
  [[nodiscard]] Fact inconsistency() const {
    return base_ != nullptr ? base_->inconsistency_ : inconsistency_;
  }
  [[nodiscard]] bool is_subrole(Role sub, Role super) const;

  /// All axioms that the derivations of \p facts use, ascending. \pre trace
  [[nodiscard]] std::vector<owl::AxiomId> axioms_of(std::vector<Fact> facts) const;
  /// The axioms by which \p sub is below \p super, as one more fact.
  Fact subrole_fact(Role sub, Role super);
  Fact axiom_fact(Reason reason) { return infer(no_fact, no_fact, reason); }

 private:
  struct Item {
    ContextId context;
    std::uint32_t place;  ///< Of a subsumer, or of a successor.
    bool is_link;
  };
  struct Inference {
    Fact first, second;
    std::uint32_t why;  ///< An axiom's number, or with the high bit a set in why_sets_.
  };
  struct CoreHash {
    std::size_t operator()(const std::vector<Concept>& core) const;
  };

  Context& own(ContextId id) { return contexts_[id - first_]; }
  [[nodiscard]] bool is_own(ContextId id) const { return id >= first_; }
  [[nodiscard]] static std::uint32_t place(const Context& x, Concept c) {
    return x.places.find(c, x.subsumers.size(), [&](std::uint32_t i) { return x.subsumers[i]; });
  }
  [[nodiscard]] const ConceptNode& node(Concept c) const {
    return c < theory_.size() ? theory_.node(c) : extra_->node(c);
  }
  [[nodiscard]] bool is_known(Role role) const { return role < theory_.role_count(); }
  [[nodiscard]] Concept universal_concept(Role role, Concept filler) const;

  void derive(ContextId x, Concept c, Fact first, Fact second, std::uint32_t why);
  void link(ContextId x, Role role, ContextId target, Fact fact);

  void process_subsumer(ContextId x, std::uint32_t place);
  void process_bottom(ContextId x, Fact fact);
  void decompose(ContextId x, Concept c, Fact fact);
  void check_groups(ContextId x, Concept c, Fact fact);
  void check_negations(ContextId x, Concept c, Fact fact);
  void nominal(ContextId x, Concept c, Fact fact);
  void mirror(ContextId x, ContextId individual, Fact nominal_fact);
  void existential(ContextId x, Concept c, Fact fact);
  void self(ContextId x, Role role, Fact fact);

  // saturation_cases.cpp
  [[nodiscard]] ContextId supposed(ContextId x, Concept c);
  void split(ContextId x, Concept c, Fact fact);
  void settle(const Split& split, Concept c);
  void settle_all(const Split& split);
  void cases_process(ContextId x, Concept c);
  void cases_bottom(ContextId x);
  void aim(ContextId x, Concept goal);

  // saturation_counting.cpp
  bool count_successors();
  bool count_successors(ContextId x, Concept at_least);
  [[nodiscard]] std::optional<Fact> apart(ContextId a, ContextId b);

  void process_link(ContextId x, std::uint32_t place);
  void link_rules(ContextId x, const Link& edge);
  void compose(ContextId x, const Link& edge);
  void apply_universals(ContextId x, const Link& edge);
  void universal_backwards(const Link& back, const Universal& u);
  void merge_functional(ContextId x, const Link& edge);
  std::vector<Role> functions_of(const Context& x, Role role) const;
  void absorb(ContextId x, Group merged, const std::vector<std::size_t>& hit, const Link& edge);
  void make_nonempty(ContextId x);

  void drain();
  Fact infer(Fact first, Fact second, std::uint32_t why);
  std::uint32_t why(Reason reason, Role sub, Role super);
  std::uint32_t keep_why(std::vector<Reason> reasons);
  std::vector<Reason> path(Role sub, Role super);

  const Theory& theory_;
  const Saturation* base_ = nullptr;
  const ExtraTheory* extra_ = nullptr;
  util::Budget& budget_;
  const bool trace_;
  ContextId first_ = 0;
  std::deque<Context> contexts_;
  std::unordered_map<std::vector<Concept>, ContextId, CoreHash> cores_;
  std::vector<ContextId> targets_;  ///< By existential on the right: where its link goes.
  std::deque<Split> splits_;
  std::deque<Trial> trials_;
  std::size_t suppositions_ = 0;
  std::vector<Item> queue_;
  std::size_t next_ = 0;
  bool inconsistent_ = false;
  Fact inconsistency_ = no_fact;
  Fact first_fact_ = 0;
  std::vector<Inference> inferences_;
  std::vector<std::vector<Reason>> why_sets_;
  std::uint32_t first_why_ = 0;
  std::map<std::pair<Role, Role>, std::vector<Reason>> paths_;
};

}  // namespace heed::dl
