#include "sample_tables.h"

#include "letters.h"

#include <algorithm>
#include <map>
#include <utility>

namespace heed::sim {
namespace {

/// floor(2^64 * value), at most 2^64 - 1.
std::uint64_t scale(const Rational& value) {
  if (value >= 1) return UINT64_MAX;
  const mpz_class scaled = (value.get_num() << 64) / value.get_den();
  std::uint64_t result = 0;
  mpz_export(&result, nullptr, -1, sizeof result, 0, 0, scaled.get_mpz_t());
  return result;
}

}  // namespace

Letters::Letters(const Run& run) {
  std::map<std::uint32_t, std::uint32_t> index;
  const auto intern = [&](const model::Valuation& valuation) {
    const std::uint32_t letter = run.machine.input_letter(valuation).value_or(Judge::none);
    const auto [found, added] = index.emplace(letter, static_cast<std::uint32_t>(machine.size()));
    if (added) machine.push_back(letter);
    return found->second;
  };
  (void)intern(run.binding.blank);
  std::map<std::uint64_t, std::uint32_t> known;
  for (const Chain::Step& step : run.chain.steps) {
    const auto [found, added] = known.emplace(step.seen, 0);
    if (added) found->second = intern(observation(run.binding, step.seen));
    of_step.push_back(found->second);
  }
}

DrawTable::DrawTable(const Chain& chain, std::span<const std::uint32_t> letter_of_step, util::Budget& budget)
    : first_(chain.first) {
  const std::size_t size = std::size_t{chain.state_count()} * slots;
  if (size > UINT32_MAX)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Size, "the chain has too many states to sample");
  budget.reserve(size * sizeof(Choice) + chain.steps.size() * (sizeof(Choice) + sizeof(std::uint64_t)));
  choices_.resize(size);
  for (std::uint32_t state = 0; state < chain.state_count(); ++state) {
    Rational sum = 0;
    for (std::uint32_t i = chain.first[state]; i < chain.first[state + 1]; ++i) {
      sum += chain.steps[i].probability;
      thresholds_.push_back(scale(sum));
      steps_.push_back({chain.steps[i].next * slots, letter_of_step[i]});
    }
    if (chain.first[state] < chain.first[state + 1]) fill_slots(state);
  }
}

void DrawTable::fill_slots(std::uint32_t state) {
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    const std::uint64_t low = std::uint64_t{slot} << (64 - slot_bits);
    const std::uint64_t high = low + ((std::uint64_t{1} << (64 - slot_bits)) - 1);
    const std::uint32_t step = step_index(state, low);
    if (step == step_index(state, high)) choices_[state * slots + slot] = steps_[step];
  }
}

std::uint32_t DrawTable::step_index(std::uint32_t state, std::uint64_t draw) const {
  const auto begin = thresholds_.begin() + first_[state], end = thresholds_.begin() + first_[state + 1] - 1;
  return static_cast<std::uint32_t>(std::upper_bound(begin, end, draw) - thresholds_.begin());
}

StepTable::StepTable(const Run& run, std::span<const std::uint32_t> letters, util::Budget& budget) {
  const std::size_t size = (std::size_t{run.machine.state_count()} + 1) * letters.size();
  if (size > UINT32_MAX)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Size, "machine and profile are too large to sample");
  budget.reserve(size * sizeof(Row));
  const auto end = static_cast<std::uint32_t>(run.machine.state_count() * letters.size());
  rows.resize(size, Row{end, 0});
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wanted;
  for (std::uint32_t i = 0; i < letters.size(); ++i) wanted.emplace_back(letters[i], i);
  std::sort(wanted.begin(), wanted.end());
  for (std::uint32_t state = 0; state < run.machine.state_count(); ++state) {
    if (state % 256 == 0) budget.check();
    for (const auto& [letter, index] : wanted) {
      Row& row = rows[state * letters.size() + index];
      const auto* found = letter == Judge::none ? nullptr : run.machine.find(state, letter);
      row.event = !found ? missing : found->fallback ? fallback : 0;
      if (!found) continue;
      row.next = static_cast<std::uint32_t>(found->next * letters.size());
      const auto transition = static_cast<std::size_t>(found - run.machine.transitions.data());
      if (run.judge.event[transition] != Judge::none) row.event |= run.judge.event[transition] + 1;
    }
  }
}

}  // namespace heed::sim
