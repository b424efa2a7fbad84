#pragma once

#include <heed/model/mealy.h>
#include <heed/util/limits.h>

#include "outlook.h"
#include "rules.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace heed::check {

/// Finds the row of a machine's letter by the values of the specification's inputs, whatever order the
/// machine has them in.
class LetterIndex {
 public:
  /// \throws util::InputError  when the machine's inputs are not those of the specification
  LetterIndex(const model::Mealy& machine, const spec::Gr1& spec);
  static constexpr std::uint32_t unknown = UINT32_MAX;
  /// \param code  Of the same inputs.
  [[nodiscard]] std::uint32_t find(const std::int32_t* inputs, std::uint64_t code) const;
  /// What the value of input \p i adds to the code of a valuation, which is the sum over all inputs.
  [[nodiscard]] std::uint64_t code(std::size_t i, std::int64_t value) const {
    return digits_[i].weight * static_cast<std::uint64_t>(value - digits_[i].low);
  }
  /// The valuation, in the machine's order, of inputs in the specification's order.
  [[nodiscard]] model::Valuation valuation(const std::int32_t* inputs) const;

 private:
  const model::Mealy& machine_;
  std::vector<std::uint32_t> column_;  ///< Of the machine, per input of the specification.
  struct Digit {
    std::uint64_t weight;
    std::int64_t low;
  };
  std::vector<Digit> digits_;  ///< Mixed radix; without weight where the product does not fit.
  std::vector<std::uint32_t> dense_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> sparse_;
};

/// Enumerates the legal inputs of one step from the specification: inputs are assigned in order, and every
/// clause is decided as soon as its inputs are there.
class LegalInputs {
 public:
  LegalInputs(const Rules& rules, const LetterIndex& letters, util::Budget& budget)
      : rules_(rules),
        letters_(letters),
        budget_(budget),
        values_(rules.layout.size()),
        registers_(rules.registers + 1),
        next_(rules.spec.inputs.size()),
        codes_(rules.spec.inputs.size() + 1) {}

  /// Calls \p visit with the values of the step (inputs, and memories as far as they are determined) and the
  /// machine's letter of the inputs. It may change the other values, and returns false to stop.
  /// \param kept  Of the step before; null for the first. \param outlook  From there.
  template <typename Visit>
  void each(const std::int64_t* kept, const Outlook& outlook, Visit&& visit) {
    outlook_ = &outlook;
    if (outlook.dead() || !level(0, kept)) return;
    const auto& inputs = rules_.spec.inputs;
    if (inputs.empty()) {
      visit(values_.data(), letters_.find(values_.data(), 0));
      return;
    }
    next_[0] = inputs[0].domain.low;
    for (std::size_t k = 0;;) {
      if (next_[k] > inputs[k].domain.high) {
        if (k == 0) return;
        --k;
        continue;
      }
      const std::int64_t value = next_[k]++;
      values_[k] = static_cast<std::int32_t>(value);
      if ((++steps_ & 0xff) == 0) budget_.check();
      if (!level(k + 1, kept)) continue;
      if (k + 1 == inputs.size()) {
        if (!visit(values_.data(), letters_.find(values_.data(), codes_[k] + letters_.code(k, value))))
          return;
      } else {
        codes_[k + 1] = codes_[k] + letters_.code(k, value);
        ++k;
        next_[k] = inputs[k].domain.low;
      }
    }
  }

 private:
  bool level(std::size_t k, const std::int64_t* kept);
  [[nodiscard]] std::int32_t memory(std::uint32_t i, const std::int64_t* kept);

  const Rules& rules_;
  const LetterIndex& letters_;
  util::Budget& budget_;
  std::vector<std::int32_t> values_;
  std::vector<std::int64_t> registers_, next_;
  std::vector<std::uint64_t> codes_;  ///< Of the first inputs, by how many they are.
  const Outlook* outlook_ = nullptr;
  std::uint64_t steps_ = 0;
};

}  // namespace heed::check
