#include "catalog.h"
#include "document.h"
#include "kinds.h"

#include <heed/owl/read.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <filesystem>
#include <set>

namespace heed::owl {
namespace {

/// The documents of one import closure, read breadth first.
class Loader {
 public:
  Loader(const ImportOptions& options, const util::Limits& limits, util::Diagnostics& diagnostics)
      : options_(options),
        limits_(limits),
        diagnostics_(diagnostics),
        data_(std::make_shared<OntologyData>()) {
    add_builtin_kinds(data_->kinds, data_->iris);
  }

  Ontology load(const std::string& path) {
    add(path);
    for (std::size_t next = 0; next < documents_.size(); ++next) follow(next);
    return finish_documents(documents_, std::move(data_), limits_, diagnostics_);
  }

 private:
  void add(const std::string& path) {
    std::error_code error;
    const auto canonical = std::filesystem::weakly_canonical(path, error);
    if (!seen_files_.insert(error ? path : canonical.string()).second) return;
    documents_.push_back(read_document(util::read_file(path, limits_), {data_->iris, data_->kinds, limits_,
                                                                        diagnostics_, documents_.size()}));
    for (const Iri name : documents_.back()->header().names) seen_iris_.insert(name);
  }

  void follow(std::size_t document) {
    for (const auto& [name, offset] : documents_[document]->header().imports) {
      if (!seen_iris_.insert(name).second) continue;
      const std::string iri(data_->iris.text(name));
      const util::SourceText source = documents_[document]->source();
      const std::string path = find(iri, source.name());
      if (path.empty())
        missing(source, offset, iri);
      else
        add(path);
    }
  }

  std::string find(const std::string& iri, const std::string& importer) {
    for (const auto& [name, path] : options_.mapping)
      if (name == iri) return path;
    if (options_.use_catalog) {
      for (const std::string& from : {importer, documents_.front()->source().name()}) {
        const auto& catalog = catalog_of(util::resolve_path(from, "catalog-v001.xml"));
        const auto entry = catalog.find(iri);
        // Nested catalogues go stale when folders move; the root's then still knows.
        if (entry != catalog.end() && std::filesystem::exists(entry->second)) return entry->second;
      }
    }
    if (iri.starts_with("file:")) return iri.substr(iri.starts_with("file://") ? 7 : 5);
    return {};
  }

  const std::map<std::string, std::string>& catalog_of(const std::string& path) {
    const auto [place, is_new] = catalogs_.try_emplace(path);
    if (is_new) place->second = read_catalog(path, limits_);
    return place->second;
  }

  void missing(const util::SourceText& source, std::size_t offset, const std::string& iri) {
    std::string message = fmt::format("no file is known for the import '{}'", iri);
    std::string hint =
        "name its file in catalog-v001.xml beside the document or map it; nothing is fetched from a network";
    if (!options_.allow_missing)
      throw util::InputError(source, offset, "missing-import", std::move(message), std::move(hint));
    diagnostics_.push_back(
        warning_at(source, offset, "missing-import", std::move(message), "what it declares is left out"));
  }

  const ImportOptions& options_;
  const util::Limits& limits_;
  util::Diagnostics& diagnostics_;
  std::shared_ptr<OntologyData> data_;
  std::vector<std::unique_ptr<Document>> documents_;
  std::set<std::string> seen_files_;
  std::set<Iri> seen_iris_;
  std::map<std::string, std::map<std::string, std::string>> catalogs_;
};

}  // namespace

Ontology load(const std::string& path, const ImportOptions& options, const util::Limits& limits,
              util::Diagnostics& diagnostics) {
  return Loader(options, limits, diagnostics).load(path);
}

}  // namespace heed::owl
