#include "manchester_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

// The document around the frames. What is declared is found by a scan over the tokens when the document is
// read; the frames are read when the whole closure has declared its names.

namespace heed::owl {
namespace {

constexpr std::array<std::string_view, 13> frame_words = {"Class:",
                                                          "ObjectProperty:",
                                                          "DataProperty:",
                                                          "AnnotationProperty:",
                                                          "Datatype:",
                                                          "Individual:",
                                                          "EquivalentClasses:",
                                                          "DisjointClasses:",
                                                          "EquivalentProperties:",
                                                          "DisjointProperties:",
                                                          "SameIndividual:",
                                                          "DifferentIndividuals:",
                                                          "Rule:"};
constexpr std::array<std::string_view, 24> section_words = {"Annotations:",
                                                            "SubClassOf:",
                                                            "SuperClassOf:",
                                                            "EquivalentTo:",
                                                            "DisjointWith:",
                                                            "DisjointUnionOf:",
                                                            "HasKey:",
                                                            "Domain:",
                                                            "Range:",
                                                            "Characteristics:",
                                                            "SubPropertyOf:",
                                                            "SuperPropertyOf:",
                                                            "InverseOf:",
                                                            "Inverses:",
                                                            "SubPropertyChain:",
                                                            "Types:",
                                                            "Facts:",
                                                            "SameAs:",
                                                            "DifferentFrom:",
                                                            "Prefix:",
                                                            "Ontology:",
                                                            "Import:",
                                                            "InverseFunctional:",
                                                            "Instances:"};

std::optional<EntityKind> declared_kind(std::string_view word) {
  static constexpr std::pair<std::string_view, EntityKind> kinds[] = {
      {"Class:", EntityKind::Class},
      {"ObjectProperty:", EntityKind::ObjectProperty},
      {"DataProperty:", EntityKind::DataProperty},
      {"AnnotationProperty:", EntityKind::AnnotationProperty},
      {"Datatype:", EntityKind::Datatype},
      {"Individual:", EntityKind::NamedIndividual}};
  for (const auto& [name, kind] : kinds)
    if (name == word) return kind;
  return std::nullopt;
}

class ManchesterDocument : public Document {
 public:
  ManchesterDocument(const util::SourceText& text, const ReadContext& context)
      : Document(text), lexer_(source()), names_(source(), context), frames_(lexer_, names_, parsed_) {
    header_part();
    body_ = lexer_.offset();
    scan();
  }
  [[nodiscard]] Header header() const override { return parsed_.header; }
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prefixes() const override {
    return parsed_.prefixes;
  }
  void declare(KindTable&) override {}
  bool infer(KindTable&, const IriTable&) override { return false; }
  void finish(OntologyData& data, const ReadContext&, std::size_t number) override {
    lexer_.go_back(body_);
    while (!lexer_.at_end()) {
      const std::string_view word = lexer_.next_word();
      const auto kind = declared_kind(word);
      if (!is_manchester_frame(word))
        lexer_.fail(
            lexer_.offset(), "syntax",
            fmt::format("expected a frame such as 'Class:', found {}", lexer_.found()),
            word.empty() ? std::string() : util::suggestion(word, {frame_words.begin(), frame_words.end()}));
      if (kind)
        frames_.frame(*kind);
      else
        frames_.list_of_equals();
    }
    append(parsed_, source(), number, data);
  }

 private:
  void header_part();
  void prefix();
  void ontology();
  void scan();

  Parsed parsed_;
  TextLexer lexer_;
  Names names_;
  ManchesterFrames frames_;
  std::size_t body_ = 0;
};

void ManchesterDocument::prefix() {
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  std::string_view name = lexer_.word();
  if (!name.ends_with(':'))
    lexer_.fail(offset, "syntax", "a prefix ends with ':'", "Prefix: p: <http://example.org/>");
  name.remove_suffix(1);
  if (lexer_.peek() != '<') lexer_.fail(lexer_.offset(), "syntax", "expected '<' and the namespace");
  const std::string_view uri = lexer_.iri();
  names_.declare_prefix(name, uri);
  parsed_.prefixes.emplace_back(name, uri);
}

void ManchesterDocument::ontology() {
  const auto iri_follows = [this] {
    if (lexer_.peek() == '<') return true;
    const std::string_view word = lexer_.next_word();
    return word.find(':') != std::string_view::npos && !is_manchester_keyword(word);
  };
  for (auto [iri, present] :
       {std::pair(&parsed_.iri, &parsed_.has_iri), std::pair(&parsed_.version, &parsed_.has_version)}) {
    if (!iri_follows()) return;
    *iri = frames_.expressions().name();
    *present = true;
    parsed_.header.names.push_back(*iri);
  }
}

void ManchesterDocument::header_part() {
  ManchesterExpressions& expressions = frames_.expressions();
  while (!lexer_.at_end()) {
    const std::size_t offset = lexer_.offset();
    if (expressions.take_word("Prefix:")) {
      prefix();
    } else if (expressions.take_word("Ontology:")) {
      ontology();
    } else if (expressions.take_word("Import:")) {
      parsed_.header.imports.emplace_back(expressions.name(), static_cast<std::uint32_t>(offset));
    } else if (lexer_.next_word() == "Annotations:") {
      for (Annotation& annotation : frames_.annotations())
        parsed_.annotations.push_back(std::move(annotation));
    } else {
      return;
    }
  }
}

/// Notes what each frame declares.
void ManchesterDocument::scan() {
  while (!lexer_.at_end()) {
    const auto kind = declared_kind(lexer_.next_word());
    lexer_.skip();
    if (!kind) continue;
    const char c = lexer_.peek();
    const std::string_view next = lexer_.next_word();
    const bool complex = c == '(' || c == '{' || next == "not" || next == "inverse" || next.starts_with("_:");
    if (complex || (c != '<' && next.empty()) || is_manchester_keyword(next)) continue;
    names_.use(*kind, frames_.expressions().name());
  }
}

}  // namespace

bool is_manchester_frame(std::string_view word) {
  return std::find(frame_words.begin(), frame_words.end(), word) != frame_words.end();
}

bool is_manchester_keyword(std::string_view word) {
  return is_manchester_frame(word) ||
         std::find(section_words.begin(), section_words.end(), word) != section_words.end();
}

std::unique_ptr<Document> read_manchester(const util::SourceText& source, ReadContext context) {
  return std::make_unique<ManchesterDocument>(source, context);
}

}  // namespace heed::owl
