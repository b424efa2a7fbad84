#pragma once

#include <heed/sim/profile.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "onset.h"

namespace heed::sim {

/// What is drawn together: one feature's onset, or a whole shuffle.
struct DrawUnit {
  std::vector<std::uint32_t> features;
  const Onset* rule = nullptr;  ///< nullptr: a shuffle.
  /// fixed: at; uniform: from, to; geometric and table: from; linear: none; shuffle: its cells.
  std::vector<ResolvedExpression> parameters;
  std::vector<std::uint32_t> parents;  ///< Features that the parameters refer to; ascending.
  util::Location location;
};

/// What a feature may be reported as instead.
struct ReadAs {
  std::uint32_t feature = 0;
  Rational probability;
  std::optional<Rational> probability_at_end;
};

/// A checked profile: names resolved, units in an order in which each comes after those it refers to.
struct ProfileModel {
  explicit ProfileModel(const ProfileSpec& profile);  ///< \throws util::InputError as compile() does

  const ProfileSpec& spec;
  std::vector<std::string> names;
  std::vector<DrawUnit> units;
  std::vector<std::uint32_t> unit_of;                ///< Per feature: index into units.
  std::vector<std::vector<std::uint32_t>> children;  ///< Per feature: units that refer to it.
  std::vector<std::vector<ReadAs>> misread_in_cell, misread_for_good;  ///< Per feature.
};

/// P(onset = cell | onset >= cell) for a rule whose parameters have the given values (`infinite` = never).
/// \param values  As in DrawUnit::parameters, none below 0.
/// \throws util::InputError `empty-range`
[[nodiscard]] Rational hazard(const DrawUnit& unit, const std::vector<std::int64_t>& values,
                              std::uint32_t cell, std::uint32_t cells);

}  // namespace heed::sim
