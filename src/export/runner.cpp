#include <heed/export/runner.h>

#include <algorithm>
#include <vector>

#include "letter_index.h"

namespace heed::exporter {
namespace {

struct Cell {
  std::uint32_t next = 0;
  std::uint32_t output = 0;
  Status status = Status::Undefined;
};

}  // namespace

struct Runner::Tables {
  model::Mealy machine;
  LetterIndex letters;
  std::vector<Cell> cells;  ///< [state][letter]; empty: search the rows.

  Tables(model::Mealy m, std::size_t table_bytes)
      : machine(std::move(m)),
        letters(machine.inputs, machine.input_letters, letter_entries(machine, table_bytes)) {
    const std::size_t width = machine.input_letters.size();
    if (width == 0 || machine.state_count() > table_bytes / sizeof(Cell) / width) return;
    cells.resize(machine.state_count() * width);
    for (std::uint32_t state = 0; state < machine.state_count(); ++state)
      for (std::uint32_t t = machine.first[state]; t < machine.first[state + 1]; ++t) {
        const model::Mealy::Transition& row = machine.transitions[t];
        cells[state * width + row.input] = cell(row);
      }
  }

  /// A letter table may be mostly holes, but stays of the order of the letters themselves.
  static std::uint64_t letter_entries(const model::Mealy& m, std::size_t table_bytes) {
    const std::uint64_t fitting = std::max<std::uint64_t>(4096, 16 * m.input_letters.size());
    return std::min<std::uint64_t>(fitting, table_bytes / sizeof(std::uint32_t));
  }

  static Cell cell(const model::Mealy::Transition& row) noexcept {
    return {row.next, row.output, row.fallback ? Status::Fallback : Status::Defined};
  }

  [[nodiscard]] Cell find(std::uint32_t state, std::uint32_t letter) const noexcept {
    if (letter >= machine.input_letters.size()) return {};
    if (!cells.empty()) return cells[state * machine.input_letters.size() + letter];
    if (state >= machine.state_count()) return {};
    const model::Mealy::Transition* row = machine.find(state, letter);
    return row == nullptr ? Cell{} : cell(*row);
  }
};

Runner::Runner(model::Mealy machine, std::size_t table_bytes)
    : tables_(std::make_shared<const Tables>(std::move(machine), table_bytes)) {}

std::optional<std::uint32_t> Runner::letter(const model::Valuation& observation) const noexcept {
  const std::uint32_t found = tables_->letters.find(observation, tables_->machine.input_letters);
  if (found == LetterIndex::none) return std::nullopt;
  return found;
}

Runner::Answer Runner::step(const model::Valuation& observation) noexcept {
  return step_letter(tables_->letters.find(observation, tables_->machine.input_letters));
}

Runner::Answer Runner::step_letter(std::uint32_t letter) noexcept {
  const Cell cell = tables_->find(state_, letter);
  if (cell.status != Status::Undefined) state_ = cell.next;
  return {cell.status, cell.output};
}

bool Runner::answers(std::uint32_t letter) const noexcept {
  return tables_->find(state_, letter).status != Status::Undefined;
}

const model::Mealy& Runner::machine() const noexcept {
  return tables_->machine;
}

}  // namespace heed::exporter
