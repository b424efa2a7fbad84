#include <algorithm>

#include "words.h"

namespace heed::bdd {

Words shifted_left(const Words& number, std::size_t bits) {
  if (number.empty()) return {};
  Words result(bits / 64, 0);
  const unsigned rest = bits % 64;
  std::uint64_t carry = 0;
  for (const std::uint64_t word : number) {
    result.push_back((word << rest) | carry);
    carry = rest == 0 ? 0 : word >> (64 - rest);
  }
  if (carry != 0) result.push_back(carry);
  return result;
}

Words sum(const Words& a, const Words& b) {
  const Words& longer = a.size() >= b.size() ? a : b;
  const Words& shorter = a.size() >= b.size() ? b : a;
  Words result = longer;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::uint64_t other = i < shorter.size() ? shorter[i] : 0;
    const std::uint64_t partial = result[i] + other;
    const std::uint64_t total = partial + carry;
    carry = (partial < other || total < partial) ? 1 : 0;
    result[i] = total;
  }
  if (carry != 0) result.push_back(carry);
  return result;
}

std::string decimal(Words number) {
  if (number.empty()) return "0";
  std::string digits;
  while (!number.empty()) {
    // Half words keep remainder * 2^32 + half within 64 bits.
    std::uint64_t remainder = 0;
    for (std::size_t i = number.size(); i-- > 0;) {
      const std::uint64_t upper = (remainder << 32) | (number[i] >> 32);
      const std::uint64_t lower = ((upper % 10) << 32) | (number[i] & 0xffffffffU);
      number[i] = ((upper / 10) << 32) | (lower / 10);
      remainder = lower % 10;
    }
    digits.push_back(static_cast<char>('0' + remainder));
    while (!number.empty() && number.back() == 0) number.pop_back();
  }
  std::reverse(digits.begin(), digits.end());
  return digits;
}

}  // namespace heed::bdd
