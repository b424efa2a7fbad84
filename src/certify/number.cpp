#include "number.h"

#include <algorithm>
#include <functional>

namespace heed::certify {
namespace {

using bdd::Bdd;
using Bits = std::vector<Bdd>;

constexpr std::size_t most_bits = 62;
constexpr std::int64_t most = std::int64_t{1} << most_bits;

/// Drops leading zeros; everything stays far from overflow.
Number checked(Number number) {
  while (!number.bits.empty() && number.bits.back().is_false()) number.bits.pop_back();
  if (number.bits.size() > most_bits || number.offset > most || number.offset < -most) throw OutOfRange();
  return number;
}

/// Bit \p i; invalid beyond the last: zero.
Bdd at(const Bits& bits, std::size_t i) {
  return i < bits.size() ? bits[i] : Bdd();
}

/// Both possibly invalid, which stands for zero.
Bdd half(const Bdd& a, const Bdd& b) {
  if (!a.valid()) return b;
  return b.valid() ? a ^ b : a;
}

Bdd both(const Bdd& a, const Bdd& b) {
  return a.valid() && b.valid() ? a & b : Bdd();
}

Bdd either(const Bdd& a, const Bdd& b) {
  if (!a.valid()) return b;
  return b.valid() ? a | b : a;
}

/// a + b, one bit longer at most. Some bit is valid.
Bits sum(const Bits& a, const Bits& b) {
  Bits result;
  Bdd carry;
  const std::size_t width = std::max(a.size(), b.size());
  for (std::size_t i = 0; i < width; ++i) {
    const Bdd x = at(a, i), y = at(b, i), differ = half(x, y);
    result.push_back(half(differ, carry));
    carry = either(both(x, y), both(differ, carry));
  }
  if (carry.valid()) result.push_back(carry);
  return result;
}

/// bits * 2^shift
Bits shifted(const Bits& bits, std::size_t shift) {
  if (bits.empty()) return bits;
  Bits result(shift, bits.front().manager().constant(false));
  result.insert(result.end(), bits.begin(), bits.end());
  return result;
}

/// offset + bits = (offset + all ones) - (complement of the bits)
Number negated(const Number& a) {
  Number result;
  const std::int64_t ones = (std::int64_t{1} << a.bits.size()) - 1;
  result.offset = -a.offset - ones;
  result.bits.reserve(a.bits.size());
  for (const Bdd& bit : a.bits) result.bits.push_back(!bit);
  return checked(std::move(result));
}

Number scaled(const Bits& bits, std::int64_t factor) {
  Number result;
  const std::int64_t size = factor < 0 ? -factor : factor;
  for (std::size_t i = 0; i <= most_bits; ++i)
    if (((size >> i) & 1) != 0) result = checked({0, sum(result.bits, shifted(bits, i))});
  return factor < 0 ? negated(result) : result;
}

/// The binary number that the term is above \p base. \pre base <= offset
Bits above(bdd::Manager& manager, const Number& a, std::int64_t base) {
  Bits constant;
  for (std::int64_t rest = a.offset - base; rest != 0; rest >>= 1)
    constant.push_back(manager.constant((rest & 1) != 0));
  return constant.empty() ? a.bits : sum(a.bits, constant);
}

}  // namespace

Number add(const Number& a, const Number& b) {
  return checked({a.offset + b.offset, sum(a.bits, b.bits)});
}

Number subtract(const Number& a, const Number& b) {
  return add(a, negated(b));
}

Number multiply(const Number& a, const Number& b) {
  Number result;
  if (__builtin_mul_overflow(a.offset, b.offset, &result.offset)) throw OutOfRange();
  result = add(result, add(scaled(a.bits, b.offset), scaled(b.bits, a.offset)));
  for (std::size_t i = 0; i < b.bits.size(); ++i) {
    Bits row;
    for (const Bdd& bit : a.bits) row.push_back(bit & b.bits[i]);
    result = add(result, checked({0, shifted(row, i)}));
  }
  return result;
}

bdd::Bdd equal(bdd::Manager& manager, const Number& a, const Number& b) {
  const std::int64_t base = std::min(a.offset, b.offset);
  const Bits x = above(manager, a, base), y = above(manager, b, base);
  std::vector<Bdd> differ;
  for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i) {
    differ.push_back(half(at(x, i), at(y, i)));
    if (differ.back().is_true()) return manager.constant(false);
    if (differ.back().is_false()) differ.pop_back();
  }
  // From the bottom up: each step then adds nodes on top of what is there, instead of making it anew.
  std::ranges::sort(differ, std::greater(), [&](const Bdd& bit) { return manager.level(bit.top()); });
  Bdd same = manager.constant(true);
  for (const Bdd& bit : differ) same = same.minus(bit);
  return same;
}

bdd::Bdd less(bdd::Manager& manager, const Number& a, const Number& b) {
  const std::int64_t base = std::min(a.offset, b.offset);
  const Bits x = above(manager, a, base), y = above(manager, b, base);
  const Bdd zero = manager.constant(false);
  Bdd below = zero;
  for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i) {
    const Bdd p = i < x.size() ? x[i] : zero, q = i < y.size() ? y[i] : zero;
    below = p.iff(q).ite(below, q);
  }
  return below;
}

}  // namespace heed::certify
