#include "letters.h"

#include <heed/util/diagnostic.h>
#include <heed/util/hash.h>

#include <fmt/format.h>

namespace heed::check {
namespace {

constexpr std::uint64_t dense_limit = std::uint64_t{1} << 22;

std::uint64_t hash_of(const std::int32_t* values, std::size_t count) {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < count; ++i) hash = util::mix(hash, static_cast<std::uint32_t>(values[i]));
  return hash;
}

}  // namespace

LetterIndex::LetterIndex(const model::Mealy& machine, const spec::Gr1& spec) : machine_(machine) {
  std::uint64_t product = 1;
  for (const model::Variable& input : spec.inputs) {
    std::uint32_t column = 0;
    while (column < machine.inputs.size() && machine.inputs[column].name != input.name) ++column;
    if (column == machine.inputs.size() || machine.inputs[column].domain != input.domain)
      throw util::InputError(
          input.location, "columns",
          fmt::format("the controller does not read the input '{}' of the specification", input.name));
    column_.push_back(column);
    digits_.push_back({product, input.domain.low});
    product = product > dense_limit ? product : product * static_cast<std::uint64_t>(input.domain.size());
  }
  if (machine.inputs.size() != spec.inputs.size())
    throw util::InputError({}, "columns", "the controller reads inputs that the specification does not have");
  const bool dense = product <= dense_limit;
  if (dense)
    dense_.assign(product, unknown);
  else
    for (Digit& digit : digits_) digit.weight = 0;
  model::Valuation values(column_.size());
  for (std::uint32_t letter = 0; letter < machine.input_letters.size(); ++letter) {
    for (std::size_t i = 0; i < column_.size(); ++i) values[i] = machine.input_letters[letter].at(column_[i]);
    for (std::size_t i = 0; i < column_.size(); ++i)
      if (values[i] < spec.inputs[i].domain.low || values[i] > spec.inputs[i].domain.high)
        throw util::InputError({}, "columns",
                               "an input letter of the controller has a value outside its type");
    std::uint64_t code = 0;
    for (std::size_t i = 0; i < values.size(); ++i) code += this->code(i, values[i]);
    if (dense)
      dense_[code] = letter;
    else
      sparse_[hash_of(values.data(), values.size())].push_back(letter);
  }
}

std::uint32_t LetterIndex::find(const std::int32_t* inputs, std::uint64_t code) const {
  if (!dense_.empty()) return dense_[code];
  const auto found = sparse_.find(hash_of(inputs, column_.size()));
  if (found == sparse_.end()) return unknown;
  for (const std::uint32_t letter : found->second) {
    bool same = true;
    for (std::size_t i = 0; i < column_.size(); ++i)
      same = same && machine_.input_letters[letter][column_[i]] == inputs[i];
    if (same) return letter;
  }
  return unknown;
}

model::Valuation LetterIndex::valuation(const std::int32_t* inputs) const {
  model::Valuation out(column_.size());
  for (std::size_t i = 0; i < column_.size(); ++i) out[column_[i]] = inputs[i];
  return out;
}

std::int32_t LegalInputs::memory(std::uint32_t i, const std::int64_t* kept) {
  if (!kept) return rules_.spec.memories[i].initial[0];
  const Update& update = rules_.updates[i];
  for (const Update::Case& c : update.cases)
    if (c.guard.run({values_.data(), kept}, registers_) != 0) return c.value;
  return static_cast<std::int32_t>(update.otherwise.run({values_.data(), kept}, registers_));
}

bool LegalInputs::level(std::size_t k, const std::int64_t* kept) {
  for (const Task& task : outlook_->tasks(k)) {
    switch (task.kind) {
      case Task::Kind::Memory:
        values_[rules_.layout.memory(task.index)] = memory(task.index, kept);
        break;
      case Task::Kind::Definition:
        values_[rules_.layout.definition(task.index)] =
            static_cast<std::int32_t>(rules_.definitions[task.index].run({values_.data()}, registers_));
        break;
      case Task::Kind::Check:
        if (!outlook_->holds(outlook_->check(task.index), values_.data(), registers_)) return false;
        break;
    }
  }
  return true;
}

}  // namespace heed::check
