#include <heed/awareness/explain.h>
#include <heed/owl/signature.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::awareness {
namespace {

using Axioms = std::vector<owl::AxiomId>;

/// What the ontology entails without anybody having written it: a cause that other consequences come from.
struct Accident {
  owl::Iri sub;
  owl::ClassExpression super;
  std::string words;
};

std::vector<Accident> accidents_of(const Catalogue& catalogue) {
  std::vector<Accident> result;
  const auto label = [&](std::size_t e) { return catalogue.entities[e].label; };
  for (const Warning& warning : catalogue.warnings) {
    if (warning.code == "unsatisfiable-entity")
      result.push_back({catalogue.entities[warning.entities[0]].iri, owl::ClassExpression::nothing(),
                        fmt::format("nothing can be a '{}'", label(warning.entities[0]))});
    if (warning.code != "unasserted-subsumption" && warning.code != "unasserted-equivalence") continue;
    const std::size_t sub = warning.entities[0], super = warning.entities[1];
    if (catalogue.entities[sub].individual || catalogue.entities[super].individual) continue;
    result.push_back({catalogue.entities[sub].iri, owl::ClassExpression::named(catalogue.entities[super].iri),
                      fmt::format("every '{}' is taken for a '{}'", label(sub), label(super))});
  }
  return result;
}

class Lister {
 public:
  Lister(const Catalogue& catalogue, dl::Justifier& justifier, std::size_t most)
      : catalogue_(catalogue), justifier_(justifier), most_(most), accidents_(accidents_of(catalogue)) {}

  void list(ExplanationStep& step) {
    std::set<Axioms> found;
    bool complete = true;
    for (const Inclusion& inclusion : step.entailed) {
      const auto some = justifier_.all_subsumption(inclusion.sub, inclusion.super, most_);
      complete = complete && some.complete;
      found.insert(some.sets.begin(), some.sets.end());
    }
    if (found.empty()) return;
    for (const Axioms& axioms : found)
      if (!contains_another(axioms, found))
        step.all.push_back({axiom_texts(catalogue_, axioms), cause_within(axioms, step.entailed)});
    std::stable_sort(step.all.begin(), step.all.end(), [](const Justification& a, const Justification& b) {
      return std::pair(!a.derived_from.empty(), a.axioms.size()) <
             std::pair(!b.derived_from.empty(), b.axioms.size());
    });
    if (step.all.size() > most_) {
      step.all.resize(most_);
      complete = false;
    }
    step.all_listed = complete;
  }

 private:
  /// By a role a thing has what it has by the roles below: such a justification says more than is needed.
  static bool contains_another(const Axioms& axioms, const std::set<Axioms>& all) {
    return std::any_of(all.begin(), all.end(), [&](const Axioms& other) {
      return other.size() < axioms.size() &&
             std::includes(axioms.begin(), axioms.end(), other.begin(), other.end());
    });
  }

  [[nodiscard]] static bool asks(const std::vector<Inclusion>& inclusions, const Accident& accident) {
    return std::any_of(inclusions.begin(), inclusions.end(), [&](const Inclusion& asked) {
      return asked.sub.is_named() && asked.sub.iri() == accident.sub && asked.super.identical(accident.super);
    });
  }

  /// Of the accidents that a part of \p axioms entails the one with the smallest part.
  [[nodiscard]] std::string cause_within(const Axioms& axioms, const std::vector<Inclusion>& asked) {
    std::set<owl::Iri> names;
    for (const owl::AxiomId id : axioms)
      for (const owl::Iri name : owl::signature(catalogue_.ontology.axiom(id).content)) names.insert(name);
    std::string cause;
    std::size_t least = axioms.size();
    for (const Accident& accident : accidents_) {
      if (!names.contains(accident.sub) || asks(asked, accident)) continue;
      const auto part =
          justifier_.subsumption_within(axioms, owl::ClassExpression::named(accident.sub), accident.super);
      if (!part || part->size() >= least) continue;
      least = part->size();
      cause = accident.words;
    }
    return cause;
  }

  const Catalogue& catalogue_;
  dl::Justifier& justifier_;
  std::size_t most_;
  std::vector<Accident> accidents_;
};

}  // namespace

void justify_all(const Catalogue& catalogue, dl::Justifier& justifier, std::size_t most,
                 Explanation& explanation) {
  Lister lister(catalogue, justifier, most);
  for (ExplanationStep& step : explanation.steps) lister.list(step);
}

}  // namespace heed::awareness
