#pragma once

#include <heed/model/mealy.h>

#include <string>

#include "cpp_names.h"

namespace heed::exporter {

/// Definitions of `letter_count`, `letter_of(observation)`: from an observation to its letter, or
/// `letter_count`. A table over the mixed-radix number of the observation where it is dense, else a binary
/// search among the letters.
[[nodiscard]] std::string cpp_letters(const model::Mealy& machine, const CppNames& names);

/// Definitions of `Row`, `row_of(state, letter)` and `reactions`. One cell per state and letter where most of
/// them have a row, else a binary search among the state's rows.
[[nodiscard]] std::string cpp_rows(const model::Mealy& machine, const CppNames& names);

/// A value in the generated code, such as `Action::halt`.
[[nodiscard]] std::string cpp_value(const CppColumn& column, std::int32_t value);

}  // namespace heed::exporter
