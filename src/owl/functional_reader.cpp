#include "structural.h"
#include "text_lexer.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <charconv>

// The functional-style syntax of "OWL 2 Structural Specification": `Word( ... )` all the way. The tree goes
// to the StructuralBuilder, whose stack is the only one.

namespace heed::owl {
namespace {

namespace v = vocabulary;

class FunctionalReader {
 public:
  FunctionalReader(const util::SourceText& source, const ReadContext& context)
      : lexer_(source), names_(source, context), builder_(names_, parsed_) {}
  Parsed read();

 private:
  void prefix();
  void ontology();
  void import();
  void axiom();
  void part();
  void literal(std::size_t offset);
  void word();
  Iri name();
  Iri header_iri();

  TextLexer lexer_;
  Parsed parsed_;
  Names names_;
  StructuralBuilder builder_;
};

Parsed FunctionalReader::read() {
  while (lexer_.next_word() == "Prefix") prefix();
  const std::size_t offset = lexer_.offset();
  if (lexer_.word() != "Ontology") {
    lexer_.go_back(offset);
    lexer_.fail(offset, "syntax",
                fmt::format("expected Prefix(...) or Ontology(...), found {}", lexer_.found()));
  }
  lexer_.expect('(', "behind Ontology");
  ontology();
  while (!lexer_.take(')')) {
    if (lexer_.at_end()) lexer_.fail(offset, "open-ontology", "the ontology has no closing ')'");
    if (lexer_.next_word() == "Import")
      import();
    else
      axiom();
  }
  if (!lexer_.at_end())
    lexer_.fail(lexer_.offset(), "syntax", fmt::format("{} stands behind the ontology", lexer_.found()),
                "a bracket too many, or a second ontology");
  return std::move(parsed_);
}

void FunctionalReader::prefix() {
  lexer_.word();
  lexer_.expect('(', "behind Prefix");
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  std::string_view name = lexer_.word();
  if (!name.ends_with(':'))
    lexer_.fail(offset, "syntax", "a prefix ends with ':'", "Prefix(p:=<http://example.org/>)");
  name.remove_suffix(1);
  lexer_.expect('=', "behind the prefix");
  if (lexer_.peek() != '<') lexer_.fail(lexer_.offset(), "syntax", "expected '<' and the namespace");
  const std::string_view uri = lexer_.iri();
  lexer_.expect(')', "behind the namespace");
  names_.declare_prefix(name, uri);
  parsed_.prefixes.emplace_back(name, uri);
}

Iri FunctionalReader::header_iri() {
  const Iri iri = name();
  parsed_.header.names.push_back(iri);
  return iri;
}

/// The IRI and version IRI. They may be abbreviated names, which a word with a bracket behind it is not.
void FunctionalReader::ontology() {
  const auto iri_follows = [this] {
    if (lexer_.peek() == '<') return true;
    return lexer_.next_word().find(':') != std::string_view::npos;
  };
  if (!iri_follows()) return;
  parsed_.iri = header_iri();
  parsed_.has_iri = true;
  if (!iri_follows()) return;
  parsed_.version = header_iri();
  parsed_.has_version = true;
}

void FunctionalReader::import() {
  const std::size_t offset = lexer_.offset();
  lexer_.word();
  lexer_.expect('(', "behind Import");
  parsed_.header.imports.emplace_back(name(), static_cast<std::uint32_t>(offset));
  lexer_.expect(')', "behind the imported IRI");
}

void FunctionalReader::axiom() {
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  do part();
  while (builder_.depth() > 0 && !lexer_.at_end());
  if (builder_.depth() > 0) lexer_.fail(offset, "open-axiom", "the axiom has no closing ')'");
}

Iri FunctionalReader::name() {
  const char c = lexer_.peek();
  const std::size_t offset = lexer_.offset();
  if (c == '<') return names_.full(lexer_.iri(), offset);
  const std::string_view word = lexer_.word();
  if (word.find(':') == std::string_view::npos) {
    lexer_.go_back(offset);
    lexer_.fail(offset, "syntax", fmt::format("expected a name, found {}", lexer_.found()),
                "a name has a prefix with ':', an IRI stands in <>");
  }
  if (word.starts_with("_:")) return names_.anonymous(word.substr(2));
  return names_.abbreviated(word, offset);
}

void FunctionalReader::literal(std::size_t offset) {
  std::string text = lexer_.string();
  if (lexer_.ahead() == '@')
    return builder_.literal(Names::literal(std::move(text), v::xsd_string, lexer_.language()), offset);
  Iri datatype = v::xsd_string;
  if (lexer_.ahead() == '^') {
    lexer_.expect('^', "before a datatype");
    lexer_.expect('^', "before a datatype");
    datatype = name();
  }
  builder_.literal(Names::literal(std::move(text), datatype, {}), offset);
}

/// One name, literal, number or bracket.
void FunctionalReader::part() {
  const char c = lexer_.peek();
  const std::size_t offset = lexer_.offset();
  if (c == ')') {
    lexer_.take(')');
    if (builder_.depth() == 0) lexer_.fail(offset, "syntax", "')' closes nothing");
    builder_.close();
  } else if (c == '(') {
    lexer_.take('(');
    builder_.open({}, offset);
  } else if (c == '"') {
    literal(offset);
  } else if (c == '<') {
    builder_.name(name(), offset);
  } else {
    word();
  }
}

void FunctionalReader::word() {
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  const std::string_view word = lexer_.word();
  if (word.empty())
    lexer_.fail(offset, "syntax",
                fmt::format("expected an axiom or a part of one, found {}", lexer_.found()));
  if (word.find(':') != std::string_view::npos) {
    lexer_.go_back(offset);
    return builder_.name(name(), offset);
  }
  if (word.find_first_not_of("0123456789") == std::string_view::npos) {
    std::uint32_t n = 0;
    if (std::from_chars(word.data(), word.data() + word.size(), n).ec != std::errc())
      lexer_.fail(offset, "bad-cardinality", fmt::format("the number {} is too large", word));
    return builder_.number(n, offset);
  }
  if (lexer_.peek() != '(')
    lexer_.fail(offset, "syntax", fmt::format("'{}' is neither a name nor followed by '('", word),
                "a name has a prefix with ':'");
  lexer_.take('(');
  builder_.open(word, offset);
}

}  // namespace

std::unique_ptr<Document> read_functional(const util::SourceText& source, ReadContext context) {
  return std::make_unique<ParsedDocument>(source, FunctionalReader(source, context).read());
}

}  // namespace heed::owl
