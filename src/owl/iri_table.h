#pragma once

#include <heed/owl/iri.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace heed::owl {

/// Interned texts. Views stay valid for the life of the table: texts live in blocks that never move.
class IriTable {
 public:
  IriTable();  ///< Holds the vocabulary at its fixed ids.
  Iri intern(std::string_view text);
  [[nodiscard]] std::optional<Iri> find(std::string_view text) const;
  [[nodiscard]] std::string_view text(Iri iri) const { return texts_[iri.id]; }
  [[nodiscard]] std::size_t size() const { return texts_.size(); }

 private:
  [[nodiscard]] std::size_t slot_of(std::string_view text, std::uint64_t hash) const;
  std::string_view keep(std::string_view text);
  void grow();

  static constexpr std::uint32_t free_slot = UINT32_MAX;
  std::vector<std::string_view> texts_;
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint32_t> slots_;  ///< Open addressing, a power of two, at most half full.
  std::vector<std::unique_ptr<char[]>> blocks_;
  std::size_t room_ = 0;  ///< Bytes left at the end of the last block.
  char* next_ = nullptr;
};

}  // namespace heed::owl
