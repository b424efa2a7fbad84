#pragma once

#include <heed/sim/run.h>
#include <heed/util/limits.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace heed::sim {

/// The letters of a run, interned: the blank observation first, then one per thing that the chain can report.
struct Letters {
  explicit Letters(const Run& run);
  std::vector<std::uint32_t> machine;  ///< The machine's letters; Judge::none where it does not know one.
  std::vector<std::uint32_t> of_step;  ///< Per step of the chain: index into `machine`.
};

/// The chain as draws: what a random word decides in a state.
class DrawTable {
 public:
  static constexpr unsigned slot_bits = 8;
  static constexpr std::uint32_t slots = 1U << slot_bits;
  static constexpr std::uint32_t undecided = UINT32_MAX;

  /// What happens next. `next` is a row: state * slots.
  struct Choice {
    std::uint32_t next = 0;
    std::uint32_t letter = undecided;
  };

  /// \param letter_of_step  Per step of the chain.
  DrawTable(const Chain& chain, std::span<const std::uint32_t> letter_of_step, util::Budget& budget);

  /// What the word's top bits decide; letter `undecided` where a boundary lies within the slot.
  [[nodiscard]] Choice quick(std::uint32_t row, std::uint32_t word) const {
    return choices_[row + (word >> (32 - slot_bits))];
  }
  /// The choice for a whole draw. \param low  Called for the draw's low 32 bits, only when they matter.
  template <typename Low>
  [[nodiscard]] Choice careful(std::uint32_t row, std::uint32_t word, const Low& low) const {
    const std::uint32_t state = row >> slot_bits;
    std::uint32_t i = first_[state], last = first_[state + 1] - 1;
    while (i < last) {
      const std::uint32_t middle = i + (last - i) / 2;
      const auto high = static_cast<std::uint32_t>(thresholds_[middle] >> 32);
      const bool below = word != high ? word < high : low() < static_cast<std::uint32_t>(thresholds_[middle]);
      below ? last = middle : i = middle + 1;
    }
    return steps_[i];
  }
  /// The step of the chain that careful() finds.
  [[nodiscard]] std::uint32_t step_index(std::uint32_t state, std::uint64_t draw) const;

 private:
  void fill_slots(std::uint32_t state);
  std::vector<std::uint32_t> first_;
  std::vector<std::uint64_t>
      thresholds_;  ///< Per step: draws below it, floor(2^64 * cumulated); a state's last is not used.
  std::vector<Choice> steps_;
  std::vector<Choice> choices_;  ///< [state][slot]
};

/// The machine as rows [state][letter] over the letters that the chain can produce; one state more, where
/// runs end that met a missing row.
struct StepTable {
  static constexpr std::uint32_t fallback = 1U << 31, missing = 1U << 30, category = missing - 1;
  struct Row {
    std::uint32_t next = 0;   ///< state * letters
    std::uint32_t event = 0;  ///< Category + 1, 0 for none; and flags.
  };
  /// \param letters  The machine's letter for each of ours; `Judge::none` for one that it does not know.
  StepTable(const Run& run, std::span<const std::uint32_t> letters, util::Budget& budget);
  std::vector<Row> rows;
};

}  // namespace heed::sim
