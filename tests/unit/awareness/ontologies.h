#pragma once

#include <heed/awareness/catalogue.h>
#include <heed/owl/ontology.h>
#include <heed/owl/read.h>
#include <heed/util/file.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace heed::awareness::test {

inline std::string source_path(const std::string& file) {
  return std::string(HEED_SOURCE_DIR) + "/" + file;
}

/// Path of a corpus file; empty when the corpus is absent.
inline std::string corpus_path(const std::string& file) {
  const char* set = std::getenv("HEED_CORPUS");
  const std::string folder = set != nullptr ? set : source_path("../shared/corpus");
  return std::filesystem::exists(folder) ? folder + "/" + file : "";
}

/// The catalogue of a document; text replacements first, so that a test can alter what the file says.
inline Catalogue catalogue_of(const std::string& path, const CatalogueOptions& options,
                              const std::vector<std::pair<std::string, std::string>>& edits = {}) {
  std::string text = util::read_file(path).text();
  for (const auto& [from, to] : edits) {
    const auto place = text.find(from);
    if (place == std::string::npos) throw std::runtime_error("nothing to edit: " + from);
    text.replace(place, from.size(), to);
  }
  util::Diagnostics diagnostics;
  util::Budget budget;
  const owl::Ontology ontology = owl::read(util::SourceText(path, text), {}, diagnostics);
  const dl::Reasoner reasoner(ontology, budget);
  return build_catalogue(reasoner, options, budget);
}

inline CatalogueOptions traffic_options() {
  CatalogueOptions options;
  options.entities = {"Sign"};
  options.features = {"Feature"};
  options.behaviours = {"Behaviour"};
  options.feature_roles = {"hasMainColour", "hasShape",        "hasSymbol",
                           "hasText",       "hasGroundColour", "hasBorderColour"};
  options.action_roles = {"hasAction"};
  return options;
}

inline Catalogue traffic_signs(const std::vector<std::pair<std::string, std::string>>& edits = {}) {
  return catalogue_of(source_path("examples/stop-sign/traffic-signs.owl"), traffic_options(), edits);
}

inline Catalogue yield_roles() {
  CatalogueOptions options;
  options.entities = {"sign"};
  options.features = {"Colour", "Shape"};
  options.behaviours = {"Action"};
  options.feature_roles = {"hasColor", "hasShape"};
  options.action_roles = {"hasAction"};
  options.subclass_role = "isSubClass";
  return catalogue_of(source_path("examples/yield-roles/yield.owl"), options);
}

/// Features or behaviours as sorted atoms.
inline std::set<std::string> atoms_of_features(const Catalogue& catalogue,
                                               const std::vector<Entailed>& list) {
  std::set<std::string> result;
  for (const Entailed& e : list) result.insert(catalogue.features[e.index].atom);
  return result;
}

inline std::set<std::string> described_atoms(const Catalogue& catalogue, const std::string& entity) {
  return atoms_of_features(catalogue, catalogue.described(catalogue.entity(Name(entity))));
}

inline std::set<std::string> prescribed_atoms(const Catalogue& catalogue, const std::string& entity) {
  std::set<std::string> result;
  for (const Entailed& e : catalogue.entities[catalogue.entity(Name(entity))].behaviours)
    result.insert(catalogue.behaviours[e.index].atom);
  return result;
}

inline std::vector<const Warning*> warnings_with(const Catalogue& catalogue, const std::string& code) {
  std::vector<const Warning*> result;
  for (const Warning& warning : catalogue.warnings)
    if (warning.code == code) result.push_back(&warning);
  return result;
}

}  // namespace heed::awareness::test
