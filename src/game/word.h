#pragma once

#include <heed/bdd/bdd.h>

#include <cstdint>
#include <vector>

namespace heed::game {

/// An integer as a vector of functions: two's complement, least significant bit first, at least one bit.
using Word = std::vector<bdd::Bdd>;

/// Widest word that arithmetic may need; a specification that needs more is refused.
constexpr std::size_t max_word_width = 64;

[[nodiscard]] Word word_constant(bdd::Manager& manager, std::int64_t value);
[[nodiscard]] Word word_add(const Word& a, const Word& b);
[[nodiscard]] Word word_subtract(const Word& a, const Word& b);
/// \pre The widths add up to at most max_word_width.
[[nodiscard]] Word word_multiply(const Word& a, const Word& b);
[[nodiscard]] bdd::Bdd word_equal(const Word& a, const Word& b);
[[nodiscard]] bdd::Bdd word_less(const Word& a, const Word& b);

}  // namespace heed::game
