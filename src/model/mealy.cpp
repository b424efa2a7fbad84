#include <heed/model/mealy.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>

namespace heed::model {
namespace {

/// The number of \p letter, whose values are looked at as words.
std::uint32_t numbered(util::WordTable& letters, const Valuation& letter) {
  const std::vector<std::uint32_t> word(letter.begin(), letter.end());
  return letters.number(std::span<const std::uint32_t>(word)).first;
}

std::vector<Valuation> valuations(const util::WordTable& letters) {
  std::vector<Valuation> result;
  result.reserve(letters.size());
  for (std::uint32_t i = 0; i < letters.size(); ++i)
    result.emplace_back(letters[i].begin(), letters[i].end());
  return result;
}

/// Sorts \p letters and returns where each old index went.
std::vector<std::uint32_t> sort_letters(std::vector<Valuation>& letters) {
  std::vector<std::uint32_t> order(letters.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return letters[a] < letters[b]; });
  std::vector<Valuation> sorted(letters.size());
  std::vector<std::uint32_t> place(letters.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    sorted[i] = std::move(letters[order[i]]);
  }
  letters = std::move(sorted);
  return place;
}

}  // namespace

const Mealy::Transition* Mealy::find(std::uint32_t state, std::uint32_t input) const {
  const Transition* begin = transitions.data() + first[state];
  const Transition* end = transitions.data() + first[state + 1];
  const Transition* row =
      std::lower_bound(begin, end, input, [](const Transition& t, std::uint32_t i) { return t.input < i; });
  return row != end && row->input == input ? row : nullptr;
}

std::optional<std::uint32_t> Mealy::input_letter(const Valuation& valuation) const {
  const auto found = std::lower_bound(input_letters.begin(), input_letters.end(), valuation);
  if (found == input_letters.end() || *found != valuation) return std::nullopt;
  return static_cast<std::uint32_t>(found - input_letters.begin());
}

bool operator==(const Mealy& a, const Mealy& b) {
  return write_mealy(a) == write_mealy(b);
}

MealyBuilder::MealyBuilder(std::string name, std::vector<Variable> inputs, std::vector<Output> outputs)
    : input_letters_(inputs.size()), output_letters_(outputs.size()) {
  machine_.name = std::move(name);
  machine_.inputs = std::move(inputs);
  machine_.outputs = std::move(outputs);
}

std::uint32_t MealyBuilder::add_state() {
  return states_++;
}

void MealyBuilder::add(std::uint32_t state, const Valuation& input, const Valuation& output,
                       std::uint32_t next, bool fallback) {
  add(state, {input_letter(input), output_letter(output), next, fallback});
}

std::uint32_t MealyBuilder::input_letter(const Valuation& letter) {
  assert(letter.size() == machine_.inputs.size());
  return numbered(input_letters_, letter);
}

std::uint32_t MealyBuilder::output_letter(const Valuation& letter) {
  assert(letter.size() == machine_.outputs.size());
  return numbered(output_letters_, letter);
}

std::size_t MealyBuilder::bytes_to_finish() const {
  constexpr std::size_t of_block = 16;  // what an allocation takes besides
  const auto letters = [](const util::WordTable& words) {
    return words.size() * (sizeof(Valuation) + of_block + words.length() * sizeof(std::int32_t));
  };
  return letters(input_letters_) + letters(output_letters_) + states_ * sizeof(std::uint32_t);
}

/// Takes the rows, and counts those of each state into the machine.
std::vector<Mealy::Transition> MealyBuilder::rows_by_state() {
  const auto end_of = [&](std::size_t run) {
    return run + 1 < runs_.size() ? runs_[run + 1].begin : rows_.size();
  };
  machine_.first.assign(states_ + 1, 0);
  for (std::size_t run = 0; run < runs_.size(); ++run)
    machine_.first[runs_[run].state + 1] += static_cast<std::uint32_t>(end_of(run) - runs_[run].begin);
  std::partial_sum(machine_.first.begin(), machine_.first.end(), machine_.first.begin());
  if (std::ranges::is_sorted(runs_, {}, &Run::state)) return std::move(rows_);
  std::vector<Mealy::Transition> sorted(rows_.size());
  std::vector<std::uint32_t> place(machine_.first.begin(), machine_.first.end() - 1);
  for (std::size_t run = 0; run < runs_.size(); ++run)
    for (std::size_t i = runs_[run].begin; i < end_of(run); ++i) sorted[place[runs_[run].state]++] = rows_[i];
  return sorted;
}

Mealy MealyBuilder::finish() {
  machine_.input_letters = valuations(input_letters_);
  machine_.output_letters = valuations(output_letters_);
  const auto input_place = sort_letters(machine_.input_letters);
  const auto output_place = sort_letters(machine_.output_letters);
  machine_.transitions = rows_by_state();
  for (Mealy::Transition& row : machine_.transitions) {
    row.input = input_place[row.input];
    row.output = output_place[row.output];
  }
  for (std::uint32_t state = 0; state < states_; ++state)
    std::sort(machine_.transitions.begin() + machine_.first[state],
              machine_.transitions.begin() + machine_.first[state + 1],
              [](const Mealy::Transition& a, const Mealy::Transition& b) { return a.input < b.input; });
  rows_.clear();
  runs_.clear();
  return std::move(machine_);
}

}  // namespace heed::model
