#pragma once

#include <heed/util/diagnostic.h>

#include <pugixml.hpp>

#include <string>
#include <string_view>
#include <utility>

namespace heed::owl {

/// A parsed document whose names and values point into a copy of its text, so that places are known. pugixml
/// is told to leave escapes alone, because it knows no declared entities and resolving "&amp;lt;" twice would
/// be wrong.
class XmlInput {
 public:
  /// \throws InputError  `not-xml`
  explicit XmlInput(const util::SourceText& source);
  XmlInput(const XmlInput&) = delete;
  XmlInput& operator=(const XmlInput&) = delete;

  [[nodiscard]] pugi::xml_node document() const { return document_; }
  [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
  [[nodiscard]] std::size_t offset_of(const char* place) const {
    return static_cast<std::size_t>(place - buffer_.data());
  }
  /// Of the '<' of an element.
  [[nodiscard]] std::size_t offset_of(pugi::xml_node node) const {
    const std::size_t at = offset_of(node.name());
    return at > 0 ? at - 1 : at;
  }

 private:
  std::string buffer_;
  pugi::xml_document document_;
};

/// "p:name" into "p" and "name"; the prefix may be empty.
[[nodiscard]] inline std::pair<std::string_view, std::string_view> split_name(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return {{}, name};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

}  // namespace heed::owl
