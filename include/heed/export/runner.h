#pragma once

#include <heed/model/mealy.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace heed::exporter {

/// How an observation was answered.
enum class Status : std::uint8_t {
  Defined,   ///< By a row of the machine.
  Fallback,  ///< By a row marked as fallback: the observation breaks an assumption.
  Undefined  ///< There is no row: the state is kept.
};

/// Runs a machine. Dense tables [state][letter] where they fit into \p table_bytes, else a binary search
/// among the state's rows. Copies share machine and tables, each has its own state. Steps never allocate.
class Runner {
 public:
  struct Answer {
    Status status = Status::Undefined;
    std::uint32_t output = 0;  ///< Index into `output_letters`; no meaning when undefined.
  };

  explicit Runner(model::Mealy machine, std::size_t table_bytes = std::size_t{64} << 20);

  /// The index of an observation among the machine's input letters; nothing when it is none of them, or has
  /// the wrong size or a value outside its domain. O(inputs) where the domain's size is moderate.
  [[nodiscard]] std::optional<std::uint32_t> letter(const model::Valuation& observation) const noexcept;
  /// One step on an observation.
  Answer step(const model::Valuation& observation) noexcept;
  /// One step on an input letter. O(1) with dense tables. An index out of range is undefined.
  Answer step_letter(std::uint32_t letter) noexcept;
  /// Whether the present state has a row for this letter.
  [[nodiscard]] bool answers(std::uint32_t letter) const noexcept;
  /// Back before the first observation.
  void reset() noexcept { state_ = 0; }

  [[nodiscard]] std::uint32_t state() const noexcept { return state_; }
  [[nodiscard]] const model::Mealy& machine() const noexcept;

 private:
  struct Tables;
  std::shared_ptr<const Tables> tables_;
  std::uint32_t state_ = 0;
};

}  // namespace heed::exporter
