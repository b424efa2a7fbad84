#include "word.h"

#include <algorithm>

namespace heed::game {
namespace {

using bdd::Bdd;

/// Bit \p i with the sign repeated without end.
const Bdd& bit(const Word& word, std::size_t i) {
  return i < word.size() ? word[i] : word.back();
}

/// Drops sign bits that say nothing, so that widths follow the values and not the shape of the term.
Word trimmed(Word word) {
  while (word.size() > 1 && word[word.size() - 1] == word[word.size() - 2]) word.pop_back();
  return word;
}

Word ripple(const Word& a, const Word& b, bool negate_b, std::size_t width) {
  Bdd carry = a.front().manager().constant(negate_b);
  Word sum;
  sum.reserve(width);
  for (std::size_t i = 0; i < width; ++i) {
    const Bdd& x = bit(a, i);
    const Bdd y = negate_b ? !bit(b, i) : bit(b, i);
    const Bdd differ = x ^ y;
    sum.push_back(differ ^ carry);
    carry = differ.ite(carry, x);
  }
  return sum;
}

}  // namespace

Word word_constant(bdd::Manager& manager, std::int64_t value) {
  Word word;
  for (std::size_t i = 0; i < max_word_width; ++i) word.push_back(manager.constant(((value >> i) & 1) != 0));
  return trimmed(std::move(word));
}

Word word_add(const Word& a, const Word& b) {
  return trimmed(ripple(a, b, false, std::max(a.size(), b.size()) + 1));
}

Word word_subtract(const Word& a, const Word& b) {
  return trimmed(ripple(a, b, true, std::max(a.size(), b.size()) + 1));
}

Word word_multiply(const Word& a, const Word& b) {
  const std::size_t width = a.size() + b.size();
  const Bdd zero = a.front().manager().constant(false);
  Word product(width, zero);
  // Modulo 2^width, where both factors are sign-extended, the unsigned schoolbook product is the signed one.
  for (std::size_t i = 0; i < width; ++i) {
    const Bdd& factor = bit(b, i);
    if (factor.is_false()) continue;
    Word shifted(width, zero);
    for (std::size_t k = i; k < width; ++k) shifted[k] = bit(a, k - i) & factor;
    product = ripple(product, shifted, false, width);
  }
  return trimmed(std::move(product));
}

Bdd word_equal(const Word& a, const Word& b) {
  Bdd equal = a.front().manager().constant(true);
  for (std::size_t i = std::max(a.size(), b.size()); i-- > 0;) equal &= bit(a, i).iff(bit(b, i));
  return equal;
}

Bdd word_less(const Word& a, const Word& b) {
  const std::size_t width = std::max(a.size(), b.size());
  Bdd less = a.front().manager().constant(false);
  for (std::size_t i = 0; i + 1 < width; ++i) {
    const Bdd& x = bit(a, i);
    const Bdd& y = bit(b, i);
    less = (x ^ y).ite(y, less);
  }
  const Bdd& x = bit(a, width - 1);
  const Bdd& y = bit(b, width - 1);
  return (x ^ y).ite(x, less);
}

}  // namespace heed::game
