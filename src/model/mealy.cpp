#include <heed/model/mealy.h>
#include <heed/util/hash.h>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace heed::model {
namespace {

std::uint64_t hash_of(const Valuation& letter) {
  std::uint64_t h = letter.size();
  for (const std::int32_t value : letter) h = util::mix(h, static_cast<std::uint32_t>(value));
  return h;
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

MealyBuilder::MealyBuilder(std::string name, std::vector<Variable> inputs, std::vector<Output> outputs) {
  machine_.name = std::move(name);
  machine_.inputs = std::move(inputs);
  machine_.outputs = std::move(outputs);
  input_index_.resize(1024);
  output_index_.resize(1024);
}

std::uint32_t MealyBuilder::add_state() {
  return states_++;
}

std::uint32_t MealyBuilder::intern(std::vector<Valuation>& letters,
                                   std::vector<std::vector<std::uint32_t>>& index, const Valuation& letter) {
  if (letters.size() > 4 * index.size()) {
    std::vector<std::vector<std::uint32_t>> larger(index.size() * 8);
    for (std::uint32_t i = 0; i < letters.size(); ++i)
      larger[hash_of(letters[i]) & (larger.size() - 1)].push_back(i);
    index = std::move(larger);
  }
  auto& bucket = index[hash_of(letter) & (index.size() - 1)];
  for (const std::uint32_t i : bucket)
    if (letters[i] == letter) return i;
  bucket.push_back(static_cast<std::uint32_t>(letters.size()));
  letters.push_back(letter);
  return bucket.back();
}

void MealyBuilder::add(std::uint32_t state, const Valuation& input, const Valuation& output,
                       std::uint32_t next, bool fallback) {
  add(state, {input_letter(input), output_letter(output), next, fallback});
}

std::uint32_t MealyBuilder::input_letter(const Valuation& letter) {
  assert(letter.size() == machine_.inputs.size());
  return intern(input_letters_, input_index_, letter);
}

std::uint32_t MealyBuilder::output_letter(const Valuation& letter) {
  assert(letter.size() == machine_.outputs.size());
  return intern(output_letters_, output_index_, letter);
}

Mealy MealyBuilder::finish() {
  const auto input_place = sort_letters(input_letters_);
  const auto output_place = sort_letters(output_letters_);
  for (Row& row : rows_) {
    row.transition.input = input_place[row.transition.input];
    row.transition.output = output_place[row.transition.output];
  }
  machine_.input_letters = std::move(input_letters_);
  machine_.output_letters = std::move(output_letters_);
  machine_.first.assign(states_ + 1, 0);
  for (const Row& row : rows_) ++machine_.first[row.state + 1];
  std::partial_sum(machine_.first.begin(), machine_.first.end(), machine_.first.begin());
  machine_.transitions.resize(rows_.size());
  std::vector<std::uint32_t> place(machine_.first.begin(), machine_.first.end() - 1);
  for (const Row& row : rows_) machine_.transitions[place[row.state]++] = row.transition;
  for (std::uint32_t state = 0; state < states_; ++state)
    std::sort(machine_.transitions.begin() + machine_.first[state],
              machine_.transitions.begin() + machine_.first[state + 1],
              [](const Mealy::Transition& a, const Mealy::Transition& b) { return a.input < b.input; });
  rows_.clear();
  return std::move(machine_);
}

}  // namespace heed::model
