#include "catalog.h"

#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <pugixml.hpp>

#include <charconv>
#include <filesystem>

namespace heed::owl {
namespace {

std::string percent_decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16).ptr == text.data() + i + 3) {
      out += static_cast<char>(code);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::string file_of(std::string_view uri, const std::string& catalog) {
  if (uri.starts_with("file://"))
    uri.remove_prefix(7);
  else if (uri.starts_with("file:"))
    uri.remove_prefix(5);
  return util::resolve_path(catalog, percent_decoded(uri));
}

}  // namespace

std::map<std::string, std::string> read_catalog(const std::string& path, const util::Limits& limits) {
  std::map<std::string, std::string> out;
  if (!std::filesystem::is_regular_file(path)) return out;
  const util::SourceText source = util::read_file(path, limits);
  pugi::xml_document document;
  const auto result = document.load_buffer(source.text().data(), source.text().size());
  if (!result)
    throw util::InputError(source, static_cast<std::size_t>(result.offset), "not-xml",
                           std::string("the catalogue is not well-formed XML: ") + result.description());
  struct Walker : pugi::xml_tree_walker {
    std::map<std::string, std::string>& out;
    const std::string& path;
    Walker(std::map<std::string, std::string>& o, const std::string& p) : out(o), path(p) {}
    bool for_each(pugi::xml_node& node) override {
      if (std::string_view(node.name()) != "uri") return true;
      const std::string_view target = node.attribute("uri").value();
      const bool remote = target.starts_with("http:") || target.starts_with("https:");
      if (!remote && !target.empty()) out.try_emplace(node.attribute("name").value(), file_of(target, path));
      return true;
    }
  } walker(out, path);
  document.traverse(walker);
  return out;
}

}  // namespace heed::owl
