#pragma once

#include <heed/model/mealy.h>

#include <cstdint>
#include <vector>

namespace heed::exporter {

/// Number of observations that the inputs' domains allow; \p most + 1 when there are more than \p most.
[[nodiscard]] std::uint64_t observation_count(const std::vector<model::Variable>& inputs, std::uint64_t most);

/// From an observation to its letter. A table over the mixed-radix number of the observation (first input
/// most significant, so that letters ascend with it) where that is not much larger than the letters
/// themselves, else a binary search.
class LetterIndex {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  LetterIndex(const std::vector<model::Variable>& inputs, const std::vector<model::Valuation>& letters,
              std::uint64_t most_entries);

  /// The letter, or `none`. \param letters  those of the constructor
  [[nodiscard]] std::uint32_t find(const model::Valuation& observation,
                                   const std::vector<model::Valuation>& letters) const noexcept;

 private:
  struct Digit {
    std::int64_t low, size;
  };
  std::vector<Digit> digits_;
  std::vector<std::uint32_t> table_;  ///< Empty: search.
};

}  // namespace heed::exporter
