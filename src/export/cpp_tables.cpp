// The tables of a generated controller, and the look-ups that go with them. Every look-up has two forms, by
// index and by search; which one is written depends on how full the table would be.
#include <fmt/format.h>

#include <algorithm>

#include "cpp_tables.h"
#include "letter_index.h"

namespace heed::exporter {
namespace {

/// A table may be this much larger than what is in it.
constexpr std::uint64_t slack = 4;
constexpr std::uint64_t always_dense = 1024;

/// Items between braces, broken into lines.
class Table {
 public:
  Table(std::string_view type, std::string_view name) {
    out_ = fmt::format("inline constexpr {} {}[] = {{", type, name);
  }
  void add(const std::string& item) {
    if (column_ == 0 || column_ + item.size() > 100) {
      out_ += any_ ? ",\n    " : "\n    ";
      column_ = 4;
    } else {
      out_ += ", ";
      column_ += 2;
    }
    any_ = true;
    out_ += item;
    column_ += item.size();
  }
  void new_line() { column_ = 0; }
  [[nodiscard]] std::string finish() const { return out_ + "};\n"; }

 private:
  std::string out_;
  std::size_t column_ = 0;
  bool any_ = false;
};

constexpr std::string_view add_digit = R"(
/// The next digit of a mixed-radix number; false for a value outside its domain.
constexpr bool add_digit(std::int64_t value, std::int64_t low, std::int64_t size, std::int64_t& code) noexcept {
  const std::int64_t digit = value - low;
  if (digit < 0 || digit >= size) return false;
  code = code * size + digit;
  return true;
}
)";

/// Letters by their number; the numbers are the letters when every observation is one.
std::string dense_letters(const model::Mealy& machine, const CppNames& names, std::uint64_t observations) {
  const std::size_t count = machine.input_letters.size();
  const bool all = count == observations;
  std::string out(names.inputs.empty() ? "" : add_digit);
  if (!all) {
    std::vector<std::size_t> letters(observations, count);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint64_t code = 0;
      for (std::size_t k = 0; k < machine.inputs.size(); ++k) {
        const model::Domain& domain = machine.inputs[k].domain;
        code = code * static_cast<std::uint64_t>(domain.size()) +
               static_cast<std::uint64_t>(std::int64_t{machine.input_letters[i][k]} - domain.low);
      }
      letters[code] = i;
    }
    Table table(smallest_type(0, static_cast<std::int64_t>(count)), "letters");
    for (const std::size_t letter : letters) table.add(std::to_string(letter));
    out += "\n/// The letter of an observation by its mixed-radix number.\n" + table.finish();
  }
  out += "\nconstexpr std::uint32_t letter_of(const Observation& observation) noexcept {\n";
  if (names.inputs.empty()) return out + "  static_cast<void>(observation);\n  return 0;\n}\n";
  out += "  std::int64_t code = 0;\n";
  for (const CppColumn& input : names.inputs)
    out += fmt::format(
        "  if (!add_digit(static_cast<std::int64_t>(observation.{}), {}, {}, code)) return letter_count;\n",
        input.field, input.variable.domain.low, input.variable.domain.size());
  return out + (all ? "  return static_cast<std::uint32_t>(code);\n}\n" : "  return letters[code];\n}\n");
}

constexpr std::string_view search_letters = R"(
/// Less than, equal to or greater than zero, as the letter stands to what is seen.
constexpr int compare(const letter_value* letter, const std::int64_t* seen) noexcept {
  for (std::uint32_t i = 0; i < input_count; ++i) {
    const std::int64_t value = letter[i];
    if (value != seen[i]) return value < seen[i] ? -1 : 1;
  }
  return 0;
}

constexpr std::uint32_t find_letter(const std::int64_t* seen) noexcept {
  std::uint32_t low = 0;
  std::uint32_t high = letter_count;
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (compare(letters + std::uint64_t{middle} * input_count, seen) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == letter_count || compare(letters + std::uint64_t{low} * input_count, seen) != 0) {
    return letter_count;
  }
  return low;
}
)";

std::string searched_letters(const model::Mealy& machine, const CppNames& names) {
  std::int64_t low = 0, high = 0;
  for (const model::Variable& input : machine.inputs) {
    low = std::min<std::int64_t>(low, input.domain.low);
    high = std::max<std::int64_t>(high, input.domain.high);
  }
  std::string out =
      fmt::format("inline constexpr std::uint32_t input_count = {};\nusing letter_value = {};\n",
                  machine.inputs.size(), smallest_type(low, high));
  Table table("letter_value", "letters");
  for (const model::Valuation& letter : machine.input_letters) {
    for (const std::int32_t value : letter) table.add(std::to_string(value));
    table.new_line();
  }
  out += "\n/// Every observation that has a letter, ascending.\n" + table.finish();
  out += search_letters;
  out +=
      "\nconstexpr std::uint32_t letter_of(const Observation& observation) noexcept {\n"
      "  const std::int64_t seen[input_count] = {\n";
  for (const CppColumn& input : names.inputs)
    out += fmt::format("      static_cast<std::int64_t>(observation.{}),\n", input.field);
  return out + "  };\n  return find_letter(seen);\n}\n";
}

std::string status_of(const model::Mealy::Transition& row) {
  return row.fallback ? "1" : "0";
}

constexpr std::string_view dense_lookup = R"(
constexpr Row row_of(std::uint32_t state, std::uint32_t letter) noexcept {
  if (letter >= letter_count) return Row{0, 0, 2};
  return rows[std::uint64_t{state} * letter_count + letter];
}
)";

std::string dense_rows(const model::Mealy& machine) {
  Table table("Row", "rows");
  for (std::uint32_t state = 0; state < machine.state_count(); ++state) {
    std::uint32_t t = machine.first[state];
    for (std::uint32_t letter = 0; letter < machine.input_letters.size(); ++letter) {
      const bool here = t < machine.first[state + 1] && machine.transitions[t].input == letter;
      const model::Mealy::Transition& row = machine.transitions[here ? t++ : 0];
      table.add(here ? fmt::format("{{{}, {}, {}}}", row.next, row.output, status_of(row)) : "{0, 0, 2}");
    }
    table.new_line();
  }
  return "\n/// One row per state and letter.\n" + table.finish() + std::string(dense_lookup);
}

constexpr std::string_view search_rows = R"(
constexpr Row row_of(std::uint32_t state, std::uint32_t letter) noexcept {
  std::uint32_t low = first[state];
  std::uint32_t high = first[state + 1];
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (row_letters[middle] == letter) return rows[middle];
    if (row_letters[middle] < letter) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return Row{0, 0, 2};
}
)";

std::string searched_rows(const model::Mealy& machine) {
  Table first(smallest_type(0, machine.first.back()), "first");
  for (const std::uint32_t place : machine.first) first.add(std::to_string(place));
  Table letters(smallest_type(0, static_cast<std::int64_t>(machine.input_letters.size())), "row_letters");
  Table rows("Row", "rows");
  for (std::uint32_t state = 0; state < machine.state_count(); ++state) {
    for (std::uint32_t t = machine.first[state]; t < machine.first[state + 1]; ++t) {
      const model::Mealy::Transition& row = machine.transitions[t];
      letters.add(std::to_string(row.input));
      rows.add(fmt::format("{{{}, {}, {}}}", row.next, row.output, status_of(row)));
    }
    letters.new_line();
    rows.new_line();
  }
  return "\n/// The rows of state s are those from first[s] up to first[s + 1], ascending by letter.\n" +
         first.finish() + letters.finish() + rows.finish() + std::string(search_rows);
}

/// A machine without rows has tables without entries, which C++ does not have.
constexpr std::string_view no_rows = R"(
constexpr Row row_of(std::uint32_t, std::uint32_t) noexcept { return Row{0, 0, 2}; }
)";

std::string reactions(const model::Mealy& machine, const CppNames& names) {
  Table table("Reaction", "reactions");
  for (const model::Valuation& letter : machine.output_letters) {
    std::string item = "{";
    for (std::size_t i = 0; i < letter.size(); ++i)
      item += (i == 0 ? "" : ", ") + cpp_value(names.outputs[i], letter[i]);
    table.add(item + "}");
    table.new_line();
  }
  if (machine.output_letters.empty()) table.add("Reaction{}");
  return "\n" + table.finish();
}

}  // namespace

std::string cpp_value(const CppColumn& column, std::int32_t value) {
  if (!column.enumerators.empty())
    return fmt::format("{}::{}", column.type, column.enumerators[static_cast<std::size_t>(value)]);
  return column.variable.domain.print(value);
}

std::string cpp_letters(const model::Mealy& machine, const CppNames& names) {
  const std::size_t count = machine.input_letters.size();
  std::string out = fmt::format("inline constexpr std::uint32_t letter_count = {};\n", count);
  if (count == 0)
    return out +
           "\nconstexpr std::uint32_t letter_of(const Observation&) noexcept { return letter_count; }\n";
  const std::uint64_t most = std::max(always_dense, slack * count);
  const std::uint64_t observations = observation_count(machine.inputs, most);
  return out + (observations <= most ? dense_letters(machine, names, observations)
                                     : searched_letters(machine, names));
}

std::string cpp_rows(const model::Mealy& machine, const CppNames& names) {
  const std::size_t rows = machine.transitions.size();
  const std::int64_t states = machine.state_count();
  std::string out = fmt::format(
      "struct Row {{\n  {} next;\n  {} reaction;\n  std::uint8_t status;  // as Status\n}};\n",
      smallest_type(0, states), smallest_type(0, static_cast<std::int64_t>(machine.output_letters.size())));
  const std::uint64_t cells = machine.state_count() * std::uint64_t{machine.input_letters.size()};
  if (rows == 0)
    out += no_rows;
  else
    out += cells <= std::max(always_dense, slack * rows) ? dense_rows(machine) : searched_rows(machine);
  return out + reactions(machine, names);
}

}  // namespace heed::exporter
