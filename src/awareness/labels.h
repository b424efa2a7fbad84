#pragma once

#include "horn.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace heed::awareness {

/// Propositions that are assumed together, ascending.
using Environment = std::vector<HornBase::Prop>;

/// Minimal sets of observations from which each proposition follows, and minimal contradictory ones: an
/// assumption-based truth maintenance over the Horn rules. Sets that contain a contradiction are left out.
/// \cite dekleer.86.aij
class Labels {
 public:
  /// What follows from observations alone. \param observable  one flag per proposition \param never  pairs of
  /// observations that cannot be made together
  Labels(const HornBase& base, std::vector<char> observable,
         const std::vector<std::pair<HornBase::Prop, HornBase::Prop>>& never);
  /// The same for a thing that is known to be \p entity. \p general outlives this object.
  Labels(const Labels& general, std::size_t entity);

  /// Smallest first.
  [[nodiscard]] std::vector<Environment> of(HornBase::Prop prop) const;
  /// The minimal contradictory sets beyond those of observations alone.
  [[nodiscard]] const std::vector<Environment>& contradictions() const { return own_nogoods_; }
  /// Whether \p environment contains a contradictory set.
  [[nodiscard]] bool contradictory(const Environment& environment) const;

 private:
  using Label = std::vector<Environment>;
  [[nodiscard]] const Label& label(HornBase::Prop prop) const;
  [[nodiscard]] bool excluded_here(HornBase::Prop prop) const;
  void propagate(const std::vector<HornBase::Prop>& start);
  [[nodiscard]] bool fire(const HornBase::Rule& rule);
  [[nodiscard]] Label combine(const HornBase::Rule& rule);
  bool insert(HornBase::Prop prop, Environment environment);
  bool add_contradiction(Environment environment);

  const HornBase& base_;
  const Labels* general_ = nullptr;
  std::vector<std::optional<Label>> labels_;  ///< Where it differs from the general one.
  std::vector<Environment> own_nogoods_{};
  std::vector<std::vector<Environment>> nogoods_by_first_;
  std::size_t largest_ = 2;  ///< At least the size of each of these.
  std::size_t work_ = 0;
};

}  // namespace heed::awareness
