#pragma once

#include <heed/logic/formula.h>
#include <heed/spec/symbols.h>

#include <string>

namespace heed::spec {

/// What a place of the specification admits (the table in gr1.h).
struct Place {
  enum class Next : std::uint8_t { Never, Inputs, Everything };
  std::string what;  ///< "[env init]", "the definition 'halt'"; for messages.
  bool only_inputs = false;
  Next next = Next::Never;
  std::string text{};  ///< The clause, where the formula has no location.
};

/// \throws util::InputError  unknown names, Next or another temporal operator where it may not stand, types
/// that do not fit.
void check_formula(const logic::Formula& formula, const Symbols& symbols, const Place& place);

}  // namespace heed::spec
