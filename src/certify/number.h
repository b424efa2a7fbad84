#pragma once

#include <heed/bdd/bdd.h>

#include <cstdint>
#include <vector>

namespace heed::certify {

/// An integer term as functions: `offset` plus the binary number of `bits`, least significant first, which is
/// never negative. Values stay within 62 bits. (The solver's terms are two's complement: what one encoding
/// gets wrong, the other is unlikely to.)
struct Number {
  std::int64_t offset = 0;
  std::vector<bdd::Bdd> bits;
};

/// Thrown where a term leaves 62 bits.
struct OutOfRange {};

[[nodiscard]] Number add(const Number& a, const Number& b);
[[nodiscard]] Number subtract(const Number& a, const Number& b);
[[nodiscard]] Number multiply(const Number& a, const Number& b);
/// \param manager  For terms without bits.
[[nodiscard]] bdd::Bdd equal(bdd::Manager& manager, const Number& a, const Number& b);
[[nodiscard]] bdd::Bdd less(bdd::Manager& manager, const Number& a, const Number& b);

}  // namespace heed::certify
