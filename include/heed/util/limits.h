#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace heed::util {

/// Bounds that a user sets. 0 means none.
struct Limits {
  double seconds = 0;                                ///< Wall clock from the start of the command.
  std::size_t memory_bytes = std::size_t{4} << 30;   ///< Peak resident size.
  std::size_t input_bytes = std::size_t{64} << 20;   ///< Per input file, checked before parsing.
  std::size_t nesting = 10'000;                      ///< Depth of any nested input.
  std::size_t entity_bytes = std::size_t{16} << 20;  ///< Text that XML entities may expand to, per file.
};

/// A limit was hit; whoever throws it leaves all values usable. Ends in exit code 3.
class LimitExceeded : public std::runtime_error {
 public:
  enum class Kind { Time, Memory, Cancelled, Size };
  LimitExceeded(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// A running account of Limits. Not copied; passed by reference to whatever may take long.
/// It only ever ends work: no result depends on the clock.
class Budget {
 public:
  explicit Budget(const Limits& limits = {});
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Cheap; meant for every few hundred steps of a loop. \throws LimitExceeded
  void check();
  /// Ask before growing a table by \p bytes. \throws LimitExceeded  when resident size plus \p bytes is over,
  /// to 1 MiB.
  void reserve(std::size_t bytes);
  /// From any thread or signal handler.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] double elapsed_seconds() const;

 private:
  Limits limits_;
  std::chrono::steady_clock::time_point start_;
  std::atomic<bool> cancelled_{false};
  std::uint64_t calls_ = 0;
  std::size_t asked_for_ = 0;  ///< Bytes since the system was last asked how many there are.
};

/// Resident size of this process now, in bytes; 0 where the system does not tell.
[[nodiscard]] std::size_t resident_bytes();

/// Peak resident size of this process so far, in bytes.
[[nodiscard]] std::size_t peak_resident_bytes();

}  // namespace heed::util
