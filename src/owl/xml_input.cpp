#include "xml_input.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::owl {

XmlInput::XmlInput(const util::SourceText& source) : buffer_(source.text()) {
  const unsigned flags = pugi::parse_cdata | pugi::parse_doctype | pugi::parse_eol |
                         pugi::parse_wconv_attribute | pugi::parse_ws_pcdata_single;
  const auto result =
      document_.load_buffer_inplace(buffer_.data(), buffer_.size(), flags, pugi::encoding_utf8);
  if (!result) {
    const auto offset =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), buffer_.size());
    throw util::InputError(source, offset, "not-xml",
                           fmt::format("not well-formed XML: {}", result.description()),
                           "every element must be closed in the order in which it was opened");
  }
  if (!root()) throw util::InputError(source, 0, "not-xml", "there is no element");
  for (pugi::xml_node next = root().next_sibling(); next; next = next.next_sibling())
    if (next.type() == pugi::node_element)
      throw util::InputError(source, offset_of(next), "not-xml", "a second element stands after the root");
}

}  // namespace heed::owl
