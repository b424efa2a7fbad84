#pragma once

#include <heed/sim/profile.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace heed::sim {

/// Later than every number.
inline constexpr std::int64_t infinite = std::numeric_limits<std::int64_t>::max();

/// What is known of an onset while a trace unfolds; `low == high` is knowledge.
struct OnsetRange {
  std::int64_t low = 0, high = infinite;
  [[nodiscard]] bool known() const { return low == high; }
};

/// An expression with its names resolved to feature indices (in `number`).
struct ResolvedExpression {
  struct Item {
    OnsetExpression::Operation operation;
    std::int64_t number;
  };
  std::vector<Item> items;
  std::vector<std::uint32_t> features;  ///< Referred to; ascending, each once.

  /// The tightest range when each feature's onset is somewhere in its own (all operations are monotone).
  [[nodiscard]] OnsetRange evaluate(const std::vector<OnsetRange>& onsets) const;
};

/// \throws util::InputError `unknown-feature`
[[nodiscard]] ResolvedExpression resolve(const OnsetExpression& expression,
                                         const std::vector<std::string>& features);

}  // namespace heed::sim
