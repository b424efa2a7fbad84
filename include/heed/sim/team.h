#pragma once

#include <cstdint>
#include <span>

namespace heed::sim {

/// Processes that share the work of sampling, on one machine or on several: each draws its part, and all get
/// the same sums. What they find is what one process finds, to the last bit.
class Team {
 public:
  Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  virtual ~Team() = default;

  [[nodiscard]] virtual unsigned rank() const = 0;  ///< Of this process: 0 ... size() - 1.
  [[nodiscard]] virtual unsigned size() const = 0;
  /// Replaces \p counts by their sums over all members, which all call it in the same order with as many
  /// counts. Where each count is 0 in all members but one, the sums are what each had to give.
  /// \throws  What the implementation throws where another member has failed: no sum can come then.
  virtual void sum(std::span<std::uint64_t> counts) = 0;
};

}  // namespace heed::sim
