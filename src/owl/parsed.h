#pragma once

#include "document.h"

namespace heed::owl {

/// An axiom that has no number yet.
struct Draft {
  AxiomContent content;
  std::vector<Annotation> annotations;
  std::uint32_t offset;
};

/// What the readers of axiom syntaxes (OWL/XML, functional-style, Manchester) find in a document.
struct Parsed {
  Header header;
  Iri iri{}, version{};
  bool has_iri = false, has_version = false;
  std::vector<std::pair<std::string, std::string>> prefixes;
  std::vector<Annotation> annotations;
  std::vector<Draft> drafts;
};

/// Gives \p parsed to \p data: axioms with numbers and places, labels, imports, and of the root document
/// (\p number 0) its names and annotations. \p parsed loses its axioms.
void append(Parsed& parsed, const util::SourceText& source, std::size_t number, OntologyData& data);

/// A document whose axioms need nothing of the others.
class ParsedDocument : public Document {
 public:
  ParsedDocument(util::SourceText source, Parsed parsed)
      : Document(std::move(source)), parsed_(std::move(parsed)) {}
  [[nodiscard]] Header header() const override { return parsed_.header; }
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prefixes() const override {
    return parsed_.prefixes;
  }
  void declare(KindTable&) override {}
  bool infer(KindTable&, const IriTable&) override { return false; }
  void finish(OntologyData& data, const ReadContext&, std::size_t number) override {
    append(parsed_, source(), number, data);
  }

 private:
  Parsed parsed_;
};

}  // namespace heed::owl
