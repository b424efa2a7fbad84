#pragma once

#include <heed/util/hash.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace heed::util {

/// Bytes that are taken at once on the way to \p more items, because those that are there have to move.
template <typename Item>
[[nodiscard]] std::size_t bytes_to_grow(const std::vector<Item>& items, std::size_t more) {
  return items.size() + more > items.capacity() ? items.size() * sizeof(Item) : 0;
}

/// Words of one length, numbered from 0 in the order of their discovery: equal words are one number. All of
/// them lie in one block of memory, without an allocation each; nothing depends on an order of hashing.
/// Memory: 4 bytes a letter, and 8 to 16 a word for finding it (up to 32 in a small table). \pre fewer than
/// 2^32 - 1 words
class WordTable {
 public:
  using Number = std::uint32_t;
  static constexpr Number none = UINT32_MAX;

  /// \param length  Letters of each word.
  explicit WordTable(std::size_t length) : length_(length), places_(initial_places, none) {
    letters_.reserve(initial_places / 2 * length);
  }

  /// The number of \p word, and whether it is new. Expected constant time a letter. \pre length many letters
  template <std::size_t Length>
  std::pair<Number, bool> number(std::span<const std::uint32_t, Length> word) {
    const std::size_t place = place_of(word);
    if (places_[place] != none) return {places_[place], false};
    return {add(word, place), true};
  }
  template <std::size_t Length>
  std::pair<Number, bool> number(const std::array<std::uint32_t, Length>& word) {
    return number(std::span<const std::uint32_t, Length>(word));
  }
  /// Its number, or none.
  template <std::size_t Length>
  [[nodiscard]] Number find(const std::array<std::uint32_t, Length>& word) const {
    return places_[place_of(std::span<const std::uint32_t, Length>(word))];
  }
  /// Valid until the next word is added.
  [[nodiscard]] std::span<const std::uint32_t> operator[](Number number) const {
    return {letters_.data() + std::size_t{number} * length_, length_};
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t length() const { return length_; }
  /// Bytes that are taken at once on the way to \p more words, because what is there has to move.
  [[nodiscard]] std::size_t bytes_to_grow(std::size_t more) const {
    return util::bytes_to_grow(letters_, more * length_) +
           (2 * (size_ + more) > places_.size() ? 2 * places_.size() * sizeof(Number) : 0);
  }
  /// Those of all words, one after the other.
  [[nodiscard]] const std::vector<std::uint32_t>& letters() const { return letters_; }

 private:
  static constexpr std::size_t initial_places = 64;

  template <std::size_t Length>
  static std::uint64_t hash_of(std::span<const std::uint32_t, Length> word) {
    std::uint64_t hash = 0;
    std::size_t i = 0;
    for (; i + 1 < word.size(); i += 2) hash = absorb(hash, std::uint64_t{word[i]} << 32 | word[i + 1]);
    return i < word.size() ? absorb(hash, word[i]) : hash;
  }

  /// Where \p word stands or would stand.
  template <std::size_t Length>
  [[nodiscard]] std::size_t place_of(std::span<const std::uint32_t, Length> word) const {
    assert(word.size() == length_);
    const std::size_t mask = places_.size() - 1;
    std::size_t place = hash_of(word) & mask;
    while (places_[place] != none && !equal(word, letters_.data() + std::size_t{places_[place]} * length_))
      place = (place + 1) & mask;
    return place;
  }
  /// A loop of its own: a call costs more than comparing the few letters that words have.
  template <std::size_t Length>
  static bool equal(std::span<const std::uint32_t, Length> word, const std::uint32_t* other) {
    for (std::size_t i = 0; i < word.size(); ++i)
      if (word[i] != other[i]) return false;
    return true;
  }
  Number add(std::span<const std::uint32_t> word, std::size_t place);
  void grow();

  std::size_t length_;
  std::size_t size_ = 0;
  std::vector<std::uint32_t> letters_;
  std::vector<Number> places_;  ///< Open addressing, a power of two, at most half full.
};

}  // namespace heed::util
