#include "letter_index.h"

#include <algorithm>

namespace heed::exporter {

std::uint64_t observation_count(const std::vector<model::Variable>& inputs, std::uint64_t most) {
  std::uint64_t count = 1;
  for (const model::Variable& input : inputs) {
    const auto size = static_cast<std::uint64_t>(input.domain.size());
    if (size > most / count) return most + 1;
    count *= size;
  }
  return count;
}

LetterIndex::LetterIndex(const std::vector<model::Variable>& inputs,
                         const std::vector<model::Valuation>& letters, std::uint64_t most_entries) {
  for (const model::Variable& input : inputs) digits_.push_back({input.domain.low, input.domain.size()});
  const std::uint64_t count = observation_count(inputs, most_entries);
  if (count > most_entries) return;
  table_.assign(count, none);
  for (std::uint32_t i = 0; i < letters.size(); ++i) {
    std::uint64_t code = 0;
    for (std::size_t k = 0; k < digits_.size(); ++k)
      code = code * static_cast<std::uint64_t>(digits_[k].size) +
             static_cast<std::uint64_t>(letters[i][k] - digits_[k].low);
    table_[code] = i;
  }
}

std::uint32_t LetterIndex::find(const model::Valuation& observation,
                                const std::vector<model::Valuation>& letters) const noexcept {
  if (observation.size() != digits_.size()) return none;
  if (table_.empty()) {
    const auto found = std::lower_bound(letters.begin(), letters.end(), observation);
    if (found == letters.end() || *found != observation) return none;
    return static_cast<std::uint32_t>(found - letters.begin());
  }
  std::uint64_t code = 0;
  for (std::size_t k = 0; k < digits_.size(); ++k) {
    const std::int64_t digit = observation[k] - digits_[k].low;
    if (digit < 0 || digit >= digits_[k].size) return none;
    code = code * static_cast<std::uint64_t>(digits_[k].size) + static_cast<std::uint64_t>(digit);
  }
  return table_[code];
}

}  // namespace heed::exporter
