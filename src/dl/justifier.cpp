#include <heed/dl/justifier.h>

#include "question.h"
#include "saturation.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <set>

// The saturation notes for each conclusion the premises of its first derivation. Following them back from an
// answer gives a set of axioms that suffices and is small, mostly minimal already. Then axioms are taken out,
// in ever smaller chunks and at last one by one; what must stay stays. All justifications, of which there may
// be exponentially many, are found by a hitting-set tree: any other lacks an axiom of each one known.

namespace heed::dl {

namespace {

using Ask = std::function<bool(Question&)>;

/// So few axioms are mostly minimal already: chunks would all be put back.
constexpr std::size_t few = 24;

/// A theory of some of the axioms, saturated as far as individuals reach.
struct Part {
  Part(const owl::Ontology& ontology, const std::vector<owl::AxiomId>* ids, util::Budget& budget, bool trace)
      : theory(ontology, ids), base(theory, budget, trace) {
    base.nonempty_context(top);
    for (const Concept individual : theory.individuals()) base.nonempty_context(individual);
    base.run();
  }
  Theory theory;
  Saturation base;
};

}  // namespace

class Justifier::Impl {
 public:
  Impl(owl::Ontology given, util::Budget& limits) : ontology_(std::move(given)), budget_(limits) {}

  /// \param about  What is asked about: its named classes are saturated once and kept for later questions.
  std::optional<std::vector<owl::AxiomId>> justify(const Ask& ask, const owl::ClassExpression& about = {}) {
    if (!whole_) whole_ = std::make_unique<Part>(ontology_, nullptr, budget_, true);
    prepare(about);
    Question question(whole_->base, budget_);
    if (!ask(question)) return std::nullopt;
    return minimal(question.axioms(), ask);
  }

  std::optional<std::vector<owl::AxiomId>> justify_within(const std::vector<owl::AxiomId>& axioms,
                                                          const Ask& ask) {
    budget_.check();
    Part part(ontology_, &axioms, budget_, true);
    Question question(part.base, budget_);
    if (!ask(question)) return std::nullopt;
    return minimal(question.axioms(), ask);
  }

  std::vector<owl::AxiomId> minimal(std::vector<owl::AxiomId> kept, const Ask& ask) {
    for (std::size_t chunk = kept.size() > few ? kept.size() / 4 : 1;;
         chunk = std::max<std::size_t>(chunk / 2, 1)) {
      contract(kept, chunk, ask);
      if (chunk == 1) return kept;
    }
  }

  /// The tree breadth first; its nodes are sets of axioms that are left out.
  Justifications justify_all(const Ask& ask, const owl::ClassExpression& about, std::size_t most) {
    Justifications out;
    const auto first = justify(ask, about);
    if (!first || most == 0) return {{}, !first};
    out.sets.push_back(*first);
    std::deque<std::set<owl::AxiomId>> open{{}};
    std::set<std::set<owl::AxiomId>> known{{}};
    for (; !open.empty(); open.pop_front()) {
      const auto* label = without(open.front(), out.sets);
      if (label == nullptr) {
        auto found = justify_without(open.front(), ask);
        if (!found) continue;
        if (out.sets.size() == most) return out.complete = false, out;
        out.sets.push_back(std::move(*found));
        label = &out.sets.back();
      }
      for (const owl::AxiomId axiom : *label) {
        auto more = open.front();
        more.insert(axiom);
        if (known.insert(more).second) open.push_back(std::move(more));
      }
    }
    return out;
  }

 private:
  /// One of \p sets that has none of \p gone.
  static const std::vector<owl::AxiomId>* without(const std::set<owl::AxiomId>& gone,
                                                  const std::vector<std::vector<owl::AxiomId>>& sets) {
    for (const auto& set : sets)
      if (std::none_of(set.begin(), set.end(), [&](owl::AxiomId id) { return gone.contains(id); }))
        return &set;
    return nullptr;
  }

  std::optional<std::vector<owl::AxiomId>> justify_without(const std::set<owl::AxiomId>& gone,
                                                           const Ask& ask) {
    std::vector<owl::AxiomId> rest;
    for (const owl::Axiom& axiom : ontology_.axioms())
      if (!gone.contains(axiom.id)) rest.push_back(axiom.id);
    return justify_within(rest, ask);
  }

  void prepare(const owl::ClassExpression& about) {
    std::vector<const owl::ClassExpression*> open = {&about};
    while (!open.empty()) {
      const owl::ClassExpression& next = *open.back();
      open.pop_back();
      for (const auto& operand : next.operands()) open.push_back(&operand);
      if (!next.is_named()) continue;
      const Concept c = whole_->theory.class_concept(next.iri());
      if (c != nothing_known) whole_->base.context({c});
    }
    whole_->base.run();
  }

  /// Takes out every run of \p chunk axioms without which the answer stays the same.
  void contract(std::vector<owl::AxiomId>& kept, std::size_t chunk, const Ask& ask) {
    for (std::size_t at = 0; at < kept.size();) {
      const std::size_t end = std::min(at + chunk, kept.size());
      std::vector<owl::AxiomId> fewer(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(at));
      fewer.insert(fewer.end(), kept.begin() + static_cast<std::ptrdiff_t>(end), kept.end());
      Part part(ontology_, &fewer, budget_, false);
      Question question(part.base, budget_);
      if (ask(question))
        kept = std::move(fewer);
      else
        at = end;
    }
  }

  owl::Ontology ontology_;
  util::Budget& budget_;
  std::unique_ptr<Part> whole_;
};

Justifier::Justifier(owl::Ontology ontology, util::Budget& budget)
    : impl_(std::make_unique<Impl>(std::move(ontology), budget)) {}
Justifier::~Justifier() = default;
Justifier::Justifier(Justifier&&) noexcept = default;
Justifier& Justifier::operator=(Justifier&&) noexcept = default;

std::optional<std::vector<owl::AxiomId>> Justifier::subsumption(const owl::ClassExpression& sub,
                                                                const owl::ClassExpression& super) {
  return impl_->justify([&](Question& question) { return question.subsumption(sub, super); }, sub);
}

std::optional<std::vector<owl::AxiomId>> Justifier::unsatisfiable(const owl::ClassExpression& expression) {
  return impl_->justify([&](Question& question) { return !question.satisfiable(expression); }, expression);
}

std::optional<std::vector<owl::AxiomId>> Justifier::type(owl::Iri individual,
                                                         const owl::ClassExpression& of) {
  return impl_->justify([&](Question& question) { return question.type(individual, of); });
}

std::optional<std::vector<owl::AxiomId>> Justifier::inconsistent() {
  return impl_->justify(
      [&](Question& question) { return !question.satisfiable(owl::ClassExpression::thing()); });
}

std::optional<std::vector<owl::AxiomId>> Justifier::subsumption_within(
    const std::vector<owl::AxiomId>& axioms, const owl::ClassExpression& sub,
    const owl::ClassExpression& super) {
  return impl_->justify_within(axioms, [&](Question& question) { return question.subsumption(sub, super); });
}

Justifications Justifier::all_subsumption(const owl::ClassExpression& sub, const owl::ClassExpression& super,
                                          std::size_t most) {
  return impl_->justify_all([&](Question& question) { return question.subsumption(sub, super); }, sub, most);
}

}  // namespace heed::dl
