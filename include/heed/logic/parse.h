#pragma once

#include <heed/logic/formula.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <string>
#include <string_view>

namespace heed::logic {

/// Reads one formula in heed's LTL (docs/formats/ltl.md). Iterative: nesting is bounded by `limits.nesting`,
/// not by the stack. \throws util::InputError  with the position, what was expected and a caret.
[[nodiscard]] Formula parse(const util::SourceText& source, const util::Limits& limits = {});

/// The same for a text that stands in no file; messages call it "<formula>".
[[nodiscard]] Formula parse(std::string_view text);

/// Prints so that parse() reads the same formula back: fewest parentheses, reserved names quoted.
[[nodiscard]] std::string to_string(const Formula& formula);

enum class Notation { Ascii, Unicode, Html, Latex, Textbook };
/// The same formula for people: ∧ ∨ ¬ → ○ □ ◇ (read back as well), HTML entities, LaTeX math, or Ascii as
/// papers write it, `X halt` for `halt'`. Ascii and Latex keep the prime.
[[nodiscard]] std::string to_string(const Formula& formula, Notation notation);

}  // namespace heed::logic
