#include <heed/util/word_table.h>

namespace heed::util {

namespace {
/// Places up to which a table grows by four: small ones cost little and grow often.
constexpr std::size_t most_for_four = std::size_t{1} << 12;
}  // namespace

WordTable::Number WordTable::add(std::span<const std::uint32_t> word, std::size_t place) {
  const auto added = static_cast<Number>(size_++);
  letters_.insert(letters_.end(), word.begin(), word.end());
  places_[place] = added;
  if (2 * size_ > places_.size()) grow();
  return added;
}

void WordTable::grow() {
  std::vector<Number> wider((places_.size() < most_for_four ? 4 : 2) * places_.size(), none);
  const std::size_t mask = wider.size() - 1;
  for (Number word = 0; word < size_; ++word) {
    std::size_t place = hash_of((*this)[word]) & mask;
    while (wider[place] != none) place = (place + 1) & mask;
    wider[place] = word;
  }
  places_ = std::move(wider);
}

}  // namespace heed::util
