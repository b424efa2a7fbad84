#include "iri_table.h"

#include <heed/owl/vocabulary.h>
#include <heed/util/hash.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace heed::owl {
namespace vocabulary {
namespace {
constexpr std::array<std::string_view, size> texts = {
#define HEED_TEXT(name, text) std::string_view(text),
    HEED_OWL_VOCABULARY(HEED_TEXT)
#undef HEED_TEXT
};
}  // namespace

std::string_view text(Iri iri) {
  return texts[iri.id];
}
}  // namespace vocabulary

namespace {

constexpr std::size_t block_bytes = 1 << 16;

std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = text.size();
  std::uint64_t word = 0;
  while (text.size() >= sizeof word) {
    std::memcpy(&word, text.data(), sizeof word);
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 29;
    text.remove_prefix(sizeof word);
  }
  word = 0;
  if (!text.empty()) std::memcpy(&word, text.data(), text.size());
  return util::mix(hash, word);
}

}  // namespace

IriTable::IriTable() : slots_(1024, free_slot) {
  for (std::uint32_t id = 0; id < vocabulary::size; ++id) intern(vocabulary::text(Iri{id}));
}

std::size_t IriTable::slot_of(std::string_view text, std::uint64_t hash) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash & mask;
  while (slots_[slot] != free_slot && (hashes_[slots_[slot]] != hash || texts_[slots_[slot]] != text))
    slot = (slot + 1) & mask;
  return slot;
}

std::optional<Iri> IriTable::find(std::string_view text) const {
  const std::uint32_t id = slots_[slot_of(text, hash_of(text))];
  return id == free_slot ? std::nullopt : std::optional(Iri{id});
}

Iri IriTable::intern(std::string_view text) {
  const std::uint64_t hash = hash_of(text);
  std::size_t slot = slot_of(text, hash);
  if (slots_[slot] != free_slot) return Iri{slots_[slot]};
  const auto id = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(keep(text));
  hashes_.push_back(hash);
  slots_[slot] = id;
  if (texts_.size() * 2 > slots_.size()) grow();
  return Iri{id};
}

void IriTable::grow() {
  slots_.assign(slots_.size() * 2, free_slot);
  const std::size_t mask = slots_.size() - 1;
  for (std::uint32_t id = 0; id < texts_.size(); ++id) {
    std::size_t slot = hashes_[id] & mask;
    while (slots_[slot] != free_slot) slot = (slot + 1) & mask;
    slots_[slot] = id;
  }
}

std::string_view IriTable::keep(std::string_view text) {
  if (text.size() > room_) {
    room_ = std::max(block_bytes, text.size());
    blocks_.push_back(std::make_unique<char[]>(room_));
    next_ = blocks_.back().get();
  }
  char* const begin = next_;
  std::copy(text.begin(), text.end(), begin);
  next_ += text.size();
  room_ -= text.size();
  return {begin, text.size()};
}

}  // namespace heed::owl
