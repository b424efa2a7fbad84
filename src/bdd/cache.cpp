#include "cache.h"

#include <algorithm>
#include <bit>

namespace heed::bdd {

namespace {
/// Up to here it grows by four: it is soon outgrown, and costs little.
constexpr std::size_t small_bytes = std::size_t{1} << 18;
}  // namespace

ComputedCache::ComputedCache(std::size_t bytes, std::size_t max_bytes)
    : sets_(std::bit_ceil(std::max<std::size_t>(std::min(bytes, max_bytes) / sizeof(Set), 2))),
      shift_(64 - std::countr_zero(sets_.size())),
      max_bytes_(max_bytes) {}

void ComputedCache::clear() {
  std::fill(sets_.begin(), sets_.end(), Set{});
}

// Without branches, since what lives is unpredictable. Places that hold nothing come out as they were:
// constants live.
void ComputedCache::sweep(const std::vector<std::uint64_t>& marked) {
  const std::uint64_t* const marks = marked.data();
  const auto lives = [marks](std::uint32_t edge) {
    const std::uint32_t index = (edge & operand_mask) >> 1;
    return static_cast<std::uint32_t>(marks[index >> 6] >> (index & 63U)) & 1U;
  };
  const auto clean = [&](Entry& entry) {
    // A composition's second operand is the number of its substitution, whose functions may be gone.
    const std::uint32_t composed = entry.h == code(Binary::Compose) ? 1U : 0U;
    const std::uint32_t third = entry.h >= binary_mark ? 0U : entry.h, second = composed != 0 ? 0U : entry.g;
    const std::uint32_t keep =
        0U - (lives(entry.result) & lives(entry.f) & lives(second) & lives(third) & (composed ^ 1U));
    entry.f &= keep;
    entry.g &= keep;
    entry.h &= keep;
    entry.result &= keep;
  };
  for (Set& place : sets_) {
    clean(place.newer);
    clean(place.older);
  }
}

unsigned ComputedCache::growth() const {
  return bytes() < small_bytes && bytes() * 4 <= max_bytes_ ? 2 : bytes() * 2 <= max_bytes_ ? 1 : 0;
}

void ComputedCache::grow() {
  const unsigned bits = growth();
  std::vector<Set> old(sets_.size() << bits);
  old.swap(sets_);
  shift_ -= bits;
  for (const Set& place : old) {
    for (const Entry& entry : {place.older, place.newer}) {
      if (entry.f != 0 || entry.g != 0 || entry.h != 0) store(entry.f, entry.g, entry.h, entry.result);
    }
  }
}

}  // namespace heed::bdd
