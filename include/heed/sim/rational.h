#pragma once

#include <heed/util/source.h>

#include <gmpxx.h>

#include <string>

namespace heed::sim {

/// Probabilities are exact: a profile written as fractions gives outcomes as fractions.
using Rational = mpq_class;

/// Reads "3", "0.125", ".5", "2.5e-3" or "1/2" (docs/formats/profile.md); no sign, at most 1,000 digits, a
/// decimal exponent of at most three digits. The value may be outside 0 ... 1: whoever takes a probability
/// checks that. \throws util::InputError `bad-number` with the position inside \p source.
[[nodiscard]] Rational parse_rational(const util::SourceText& source);

/// "129691/144000", "0", "1".
[[nodiscard]] std::string fraction(const Rational& value);

/// The value with exactly \p digits digits after the point, rounded exactly, half to even (as printf rounds
/// what a double holds exactly): decimal(1/8, 2) = "0.12". "-0.00" is never printed.
[[nodiscard]] std::string decimal(const Rational& value, unsigned digits);

/// The nearest double from below or above: relative error at most 2^-52.
[[nodiscard]] double to_double(const Rational& value);

}  // namespace heed::sim
