#pragma once

#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>

#include <map>
#include <string>
#include <string_view>

namespace heed::owl {

/// Internal entities of a DOCTYPE, and the expansion of references in attribute values and text. Expansion is
/// textual: an entity that brings markup, or lives outside the document, is refused. The number of bytes that
/// go through entity values is capped over the whole document (`Limits::entity_bytes`), so that neither
/// exponential nor quadratic definitions cost more than the cap.
class XmlEntities {
 public:
  XmlEntities(const util::SourceText& source, const util::Limits& limits)
      : source_(source), limits_(limits) {}

  /// \param subset  What stands between "<!DOCTYPE" and its ">". \param offset  Of it, in the source.
  void declare(std::string_view subset, std::size_t offset);

  /// The text with all references resolved; \p text itself when it has none. The view lives until the next
  /// call.
  std::string_view expand(std::string_view text, std::size_t offset);

  [[nodiscard]] const std::map<std::string, std::string, std::less<>>& declared() const { return values_; }

 private:
  void declare_one(std::string_view declaration, std::size_t offset);
  void expand_nested(std::string_view name, std::size_t offset);
  /// Resolves "&#10;", "&lt;" and the like; false for the name of a declared entity.
  bool append_builtin(std::string_view name, std::size_t offset, std::string& out) const;
  [[nodiscard]] std::string_view value_of(std::string_view name, std::size_t offset);
  [[noreturn]] void fail(std::size_t offset, const char* code, std::string message,
                         std::string hint = {}) const;

  const util::SourceText& source_;
  const util::Limits& limits_;
  std::map<std::string, std::string, std::less<>> values_;
  std::map<std::string, std::size_t, std::less<>> external_;
  std::size_t spent_ = 0;
  std::string buffer_;
};

}  // namespace heed::owl
