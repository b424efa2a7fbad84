#pragma once

#include <heed/sim/profile.h>
#include <heed/util/limits.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "profile_model.h"

namespace heed::sim {

/// What a trace's future depends on.
struct Knowledge {
  static constexpr std::int32_t later = -1;  ///< Not drawn yet, hence after the current cell.
  std::vector<std::int32_t> onset;           ///< `later`, or 0 ... T (T = never).
  std::uint64_t reported = 0;                ///< Reported already and to stay; only kept where that matters.
  /// Per feature, what it is read as for the whole approach: `undecided`, `right`, or 2 + which of its
  /// misreadings. Empty where the profile has none of that kind.
  std::vector<std::uint8_t> reading;
  static constexpr std::uint8_t undecided = 0, right = 1;
  friend auto operator<=>(const Knowledge&, const Knowledge&) = default;
};

struct Branch {
  Rational probability;
  Knowledge knowledge;
  std::uint64_t seen = 0;
};

/// Unfolds single cells of a checked profile.
class CellUnfolder {
 public:
  /// \param ahead  Per unit: its onsets are drawn before cell 0. Closed under what units refer to.
  /// \param most  Branches of one cell.
  CellUnfolder(const ProfileModel& model, std::vector<bool> ahead, std::size_t most, util::Budget& budget);

  /// What may be known before cell 0: one branch, unless something is drawn ahead.
  [[nodiscard]] std::vector<Branch> start();
  /// What may happen in \p cell.
  [[nodiscard]] std::vector<Branch> unfold(const Knowledge& before, std::uint32_t cell);
  /// Units that must be drawn ahead, too, since a rule needed an onset that was still to come. The results of
  /// the call that set it are void.
  [[nodiscard]] const std::optional<std::vector<bool>>& wanted_ahead() const { return wanted_ahead_; }

 private:
  void draw(const DrawUnit& unit, std::uint32_t cell, std::vector<Branch>& branches);
  void draw_feature(const DrawUnit& unit, std::uint32_t cell, std::vector<Branch>& branches);
  void draw_shuffle(const DrawUnit& unit, std::uint32_t cell, std::vector<Branch>& branches);
  void draw_feature_ahead(const DrawUnit& unit, std::vector<Branch>& branches);
  void draw_shuffle_ahead(const DrawUnit& unit, std::vector<Branch>& branches);
  void report(std::uint32_t cell, std::vector<Branch>& branches);
  struct Rates {
    Rational detection, false_detection;
    bool tracked = false;  ///< What was reported once stays reported, and might not without.
  };
  void report_feature(std::uint32_t feature, std::uint32_t cell, const Rates& rates,
                      std::vector<Branch>& branches);
  /// What becomes of a branch in which \p feature is rightly reported, by what it is read as; never none.
  [[nodiscard]] std::vector<Branch> read(std::uint32_t feature, std::uint32_t cell, bool tracked,
                                         Branch branch) const;
  /// A rate in \p cell that is \p begin at the horizon and \p end, if given, in the last cell.
  [[nodiscard]] Rational rate(const Rational& begin, const std::optional<Rational>& end,
                              std::uint32_t cell) const;
  void forget(std::uint32_t cell, Knowledge& knowledge) const;
  void grow(std::vector<Branch>& branches, Branch branch);
  void want_ahead(const std::vector<std::uint32_t>& features);
  [[nodiscard]] std::vector<OnsetRange> ranges(const Knowledge& knowledge, std::uint32_t cell) const;
  [[nodiscard]] std::optional<std::vector<std::int64_t>> values(const DrawUnit& unit,
                                                                const Knowledge& knowledge,
                                                                std::uint32_t cell);
  [[nodiscard]] bool visible(const Knowledge& knowledge, std::size_t feature, std::uint32_t cell) const;
  [[nodiscard]] bool open(const DrawUnit& unit, const Knowledge& knowledge) const;

  const ProfileModel& model_;
  std::vector<bool> ahead_;
  std::size_t most_;
  util::Budget& budget_;
  std::uint32_t cells_;
  std::optional<std::vector<bool>> wanted_ahead_;
};

}  // namespace heed::sim
