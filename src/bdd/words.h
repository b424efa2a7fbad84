#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace heed::bdd {

/// A natural number as little-endian words without leading zeros; empty is 0.
using Words = std::vector<std::uint64_t>;

[[nodiscard]] Words shifted_left(const Words& number, std::size_t bits);
[[nodiscard]] Words sum(const Words& a, const Words& b);
[[nodiscard]] std::string decimal(Words number);

}  // namespace heed::bdd
