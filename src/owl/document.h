#pragma once

#include "graph.h"
#include "ontology_data.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace heed::owl {

/// What a document says of itself.
struct Header {
  std::vector<Iri> names;                              ///< Its IRI and version IRI.
  std::vector<std::pair<Iri, std::uint32_t>> imports;  ///< With the offsets of their statements.
};

/// One document of a closure, whatever its syntax. Documents are read one by one, but what a name is, is only
/// known when all of them have been: hence the axioms come last.
class Document {
 public:
  explicit Document(util::SourceText source) : source_(std::move(source)) {}
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;
  virtual ~Document() = default;

  [[nodiscard]] const util::SourceText& source() const { return source_; }
  [[nodiscard]] virtual Header header() const = 0;
  [[nodiscard]] virtual const std::vector<std::pair<std::string, std::string>>& prefixes() const = 0;
  /// Adds what it declares.
  virtual void declare(KindTable& kinds) = 0;
  /// Adds what its names must be by their use. \returns whether anything is new.
  virtual bool infer(KindTable& kinds, const IriTable& iris) = 0;
  /// Appends its axioms, once. \param number  Of the document in its closure; the root is 0.
  virtual void finish(OntologyData& data, const ReadContext& context, std::size_t number) = 0;

 private:
  util::SourceText source_;
};

[[nodiscard]] std::unique_ptr<Document> read_document(const util::SourceText& source, ReadContext context);

[[nodiscard]] std::unique_ptr<Document> read_owl_xml(const util::SourceText& source, ReadContext context);

[[nodiscard]] std::unique_ptr<Document> read_functional(const util::SourceText& source, ReadContext context);

[[nodiscard]] std::unique_ptr<Document> read_manchester(const util::SourceText& source, ReadContext context);

/// The axioms of \p documents, the root first.
[[nodiscard]] Ontology finish_documents(std::vector<std::unique_ptr<Document>>& documents,
                                        std::shared_ptr<OntologyData> data, const util::Limits& limits,
                                        util::Diagnostics& diagnostics);

}  // namespace heed::owl
