#pragma once

#include <heed/logic/formula.h>
#include <heed/model/fts.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace heed::spec {

using StateSet = std::vector<bool>;

/// A plant seen through formulas over `state` and `action`.
class PlantTerms {
 public:
  explicit PlantTerms(const model::Fts& plant);

  [[nodiscard]] const model::Fts& plant() const { return plant_; }
  [[nodiscard]] bool deterministic() const { return deterministic_; }
  [[nodiscard]] const StateSet* label(const std::string& name) const;
  [[nodiscard]] const std::vector<std::int32_t>* value(const std::string& name) const;
  [[nodiscard]] std::optional<std::uint32_t> state(const std::string& name) const;

  /// "`state` is in \p states", with the fewest comparisons.
  [[nodiscard]] logic::Formula inside(const StateSet& states) const;
  /// "The next state is in \p states": over `state` and `action` where the plant is deterministic. Where the
  /// action is not enabled the value is left open, for the shorter formula.
  [[nodiscard]] logic::Formula next_inside(const StateSet& states) const;
  [[nodiscard]] StateSet enabled(std::uint32_t action) const;

 private:
  const model::Fts& plant_;
  bool deterministic_;
  std::map<std::string, const StateSet*> labels_;
  std::map<std::string, const std::vector<std::int32_t>*> values_;
  std::map<std::string, std::uint32_t> states_;
  std::vector<StateSet> enabled_;
};

/// expand_plant() and, where the formula speaks of the plant's present state only, the states where it holds.
struct Expanded {
  logic::Formula formula;
  std::optional<StateSet> states;
};
[[nodiscard]] Expanded expand(const logic::Formula& formula, const PlantTerms& terms);

/// One comparison that mentions the plant, as a formula over `state`, Next over it and the other names.
/// `states` is set where nothing but the present state matters.
[[nodiscard]] Expanded expand_comparison(const logic::Formula& comparison, const PlantTerms& terms);

/// True where a comparison mentions `state` or a plant value.
[[nodiscard]] bool mentions_plant(const logic::Formula& comparison, const PlantTerms& terms);

}  // namespace heed::spec
