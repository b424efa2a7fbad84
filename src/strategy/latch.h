#pragma once

#include <heed/model/mealy.h>
#include <heed/util/limits.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace heed::strategy {

/// The answer to a legal observation, to be repeated for an illegal one.
struct LegalRow {
  std::uint32_t output = 0;  ///< The builder's number of the letter.
  std::uint32_t next = 0;
};

/// The rows of one state, for answering observations that have none: OnViolation::Latch.
class LatchRows {
 public:
  /// \param used  Whether fill() will be called. \throws util::LimitExceeded  too many letters for that
  LatchRows(const std::vector<model::Variable>& inputs, bool used);

  void clear() { rows_.clear(); }
  void add(const model::Valuation& letter, LegalRow row) { rows_.push_back({number(letter), row}); }

  /// A letter's number, from 1, in ascending order of letters. \pre used
  [[nodiscard]] std::uint64_t number(const model::Valuation& letter) const;

  /// Calls \p row for every letter without one, in ascending order. \param last  Number of the last
  /// observation, 0: none.
  template <typename Row>
  void fill(std::uint64_t last, const Row& row) {
    if (rows_.empty()) return;
    std::sort(rows_.begin(), rows_.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
    const model::Valuation seen = last == 0 ? model::Valuation{} : letter_of(last);
    auto next_legal = rows_.begin();
    for (std::uint64_t n = 1; n <= letters_; ++n) {
      if (next_legal != rows_.end() && next_legal->number == n) {
        ++next_legal;
        continue;
      }
      const model::Valuation letter = letter_of(n);
      row(letter, nearest(letter, seen, last));
    }
  }

 private:
  struct Numbered {
    std::uint64_t number;
    LegalRow row;
  };
  [[nodiscard]] std::uint64_t count_letters() const;
  [[nodiscard]] model::Valuation letter_of(std::uint64_t number) const;
  [[nodiscard]] const LegalRow* find(std::uint64_t number) const;
  [[nodiscard]] const LegalRow& nearest(const model::Valuation& letter, const model::Valuation& seen,
                                        std::uint64_t last) const;

  std::vector<model::Variable> inputs_;
  std::uint64_t letters_ = 0;
  std::vector<Numbered> rows_;
};

}  // namespace heed::strategy
