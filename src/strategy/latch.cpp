#include "latch.h"

namespace heed::strategy {

LatchRows::LatchRows(const std::vector<model::Variable>& inputs, bool used) : inputs_(inputs) {
  if (used) letters_ = count_letters();
}

std::uint64_t LatchRows::count_letters() const {
  constexpr std::uint64_t most = std::uint64_t{1} << 32;
  std::uint64_t count = 1;
  for (const model::Variable& input : inputs_) {
    count *= static_cast<std::uint64_t>(input.domain.size());
    if (count > most)
      throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                                "there are too many observations to answer each");
  }
  return count;
}

std::uint64_t LatchRows::number(const model::Valuation& letter) const {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const model::Domain& domain = inputs_[i].domain;
    number = number * static_cast<std::uint64_t>(domain.size()) +
             static_cast<std::uint64_t>(letter[i] - domain.low);
  }
  return number + 1;
}

model::Valuation LatchRows::letter_of(std::uint64_t number) const {
  model::Valuation letter(inputs_.size());
  std::uint64_t rest = number - 1;
  for (std::size_t i = inputs_.size(); i-- > 0;) {
    const model::Domain& domain = inputs_[i].domain;
    const auto size = static_cast<std::uint64_t>(domain.size());
    letter[i] = domain.low + static_cast<std::int32_t>(rest % size);
    rest /= size;
  }
  return letter;
}

const LegalRow* LatchRows::find(std::uint64_t number) const {
  const auto found = std::lower_bound(rows_.begin(), rows_.end(), number,
                                      [](const Numbered& row, std::uint64_t n) { return row.number < n; });
  return found != rows_.end() && found->number == number ? &found->row : nullptr;
}

const LegalRow& LatchRows::nearest(const model::Valuation& letter, const model::Valuation& seen,
                                   std::uint64_t last) const {
  if (last == 0) return rows_.front().row;
  // What was seen before and is not seen now (the lowest code) counts as still seen.
  model::Valuation together = letter;
  for (std::size_t i = 0; i < together.size(); ++i)
    if (together[i] == inputs_[i].domain.low) together[i] = seen[i];
  if (const LegalRow* row = find(number(together))) return *row;
  if (const LegalRow* row = find(last)) return *row;
  return rows_.front().row;
}

}  // namespace heed::strategy
