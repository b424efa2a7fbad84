#pragma once

#include <heed/owl/ontology.h>
#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>

#include <string>
#include <utility>
#include <vector>

namespace heed::owl {

enum class Syntax { RdfXml, Turtle, OwlXml, Functional, Manchester, Unknown };

/// By content first (first markup, `@prefix`, `Prefix(`, `Prefix:`), then by the extension of the name.
[[nodiscard]] Syntax recognise(const util::SourceText& source);
[[nodiscard]] std::string_view to_string(Syntax syntax);

/// Reads one document; owl:imports are listed, not followed. docs/formats/owl.md
/// \param diagnostics  Gets everything that was read but not understood, in document order.
/// \throws InputError  not well-formed, a syntax that has no reader, over a limit (entities, nesting).
[[nodiscard]] Ontology read(const util::SourceText& source, const util::Limits& limits,
                            util::Diagnostics& diagnostics);

struct ImportOptions {
  /// Ontology IRI to file path; goes before the catalogue.
  std::vector<std::pair<std::string, std::string>> mapping;
  /// `catalog-v001.xml` beside the root file (and beside each imported one).
  bool use_catalog = true;
  /// A missing import becomes a warning instead of an InputError.
  bool allow_missing = false;
};

/// Reads \p path and, transitively, what it imports; each document once, so cycles end. Never uses a network.
/// \throws InputError  as read(); an import that neither mapping nor catalogue resolves (unless allowed).
[[nodiscard]] Ontology load(const std::string& path, const ImportOptions& options, const util::Limits& limits,
                            util::Diagnostics& diagnostics);

}  // namespace heed::owl
