#pragma once

#include "evidence.h"
#include "labels.h"
#include "units.h"

#include <heed/awareness/perception.h>
#include <heed/awareness/policy.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace heed::awareness {

/// What observations leave possible, as formulas over what perception reports (docs/awareness.md).
class Possibilities {
 public:
  /// \param whole  entities that are read whole are part of what is observed
  Possibilities(const Catalogue& catalogue, const Perception& perception, bool closed, bool whole);

  /// Something seen, conflict, what is possible, unknown: each over earlier ones.
  [[nodiscard]] std::vector<Situation> situations() const;
  /// That \p entity follows from what is seen.
  [[nodiscard]] Rule recognised(std::size_t entity) const;
  /// That all candidates are \p entity or below it. \p work is what may still be spent on listing evidence.
  [[nodiscard]] Rule identified(std::size_t entity, std::size_t& work) const;
  /// That what is seen calls for \p behaviour, whatever the thing is.
  [[nodiscard]] Rule called_for(std::size_t behaviour) const;
  [[nodiscard]] logic::Formula common(std::size_t behaviour) const;
  [[nodiscard]] logic::Formula brave(std::size_t behaviour) const;
  /// Nothing in the catalogue fits what is seen.
  [[nodiscard]] logic::Formula nothing_fits() const;

 private:
  struct Unit {
    std::size_t entity;
    std::string name;                  ///< "possible_stop_sign"
    std::vector<Environment> against;  ///< Minimal, beyond the general conflicts.
    std::map<std::size_t, std::vector<Environment>>
        prompts;  ///< Behaviours: what must be seen; {} = nothing.
  };
  void observe(bool whole);
  void add_unit(std::size_t entity);
  void build_tree();
  [[nodiscard]] logic::Formula is_candidate(const Unit& unit) const;
  [[nodiscard]] logic::Formula no_candidate(std::size_t from, std::size_t to) const;
  [[nodiscard]] logic::Formula formula_of(const Environment& environment) const;
  [[nodiscard]] logic::Formula formula_of(const std::vector<Environment>& environments) const;
  [[nodiscard]] Evidence evidence_of(const Environment& environment,
                                     const std::vector<owl::AxiomId>& axioms) const;
  [[nodiscard]] std::vector<Evidence> list(const std::vector<Environment>& environments,
                                           std::optional<HornBase::Prop> known, HornBase::Prop goal) const;
  [[nodiscard]] std::vector<owl::AxiomId> why_identified(std::size_t entity, const Environment& seen) const;

  const Catalogue& catalogue_;
  const Perception& perception_;
  bool closed_;
  HornBase base_;
  Units which_;
  std::map<HornBase::Prop, std::string> atoms_;  ///< Of what is observable.
  std::vector<std::string> seen_;                ///< Those that are seen rather than excluded.
  std::vector<Environment> any_seen_;            ///< One for each of these.
  std::unique_ptr<Labels> labels_;
  std::vector<Unit> units_;                ///< In the order of which_.entities.
  std::map<std::size_t, std::size_t> at_;  ///< Entity to unit.
  std::vector<std::vector<logic::Formula>>
      none_;  ///< none_[k][i]: no candidate among units i 2^k ... (i+1) 2^k - 1.
};

/// Minimal hitting sets: sets that contain one of the alternatives of every entry of \p duties and none of
/// \p forbidden wholly for at least one of its entries. Smaller ones first; stops when \p work is spent.
struct HittingTask {
  std::vector<const std::vector<Environment>*> duties;
  std::vector<const std::vector<Environment>*> inside;  ///< Of these one must stay unhit.
  const Labels* labels;                                 ///< Contradictory sets are not looked for.
};
[[nodiscard]] std::vector<Environment> minimal_hitting_sets(const HittingTask& task, std::size_t& work,
                                                            bool& complete);

}  // namespace heed::awareness
