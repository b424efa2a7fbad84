#include <heed/owl/read.h>

#include "document.h"
#include "encoding.h"
#include "graph.h"
#include "kinds.h"
#include "mapper.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace heed::owl {
namespace {

namespace v = vocabulary;

/// Where the root element begins: over the byte order mark, white space, the XML declaration, comments and
/// the DOCTYPE.
std::size_t root_element(std::string_view text) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (at < text.size()) {
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    std::string_view closing;
    if (text.substr(at, 4) == "<!--")
      closing = "-->";
    else if (text.substr(at, 2) == "<?")
      closing = "?>";
    else if (text.substr(at, 2) == "<!") {
      const std::size_t bracket = text.find('[', at);
      closing = bracket < text.find('>', at) ? "]>" : ">";
      const std::size_t subset_end = closing == ">" ? at : text.find(']', at);
      const std::size_t end = text.find('>', subset_end);
      at = end == std::string_view::npos ? text.size() : end + 1;
      continue;
    } else {
      return at;
    }
    const std::size_t end = text.find(closing, at);
    at = end == std::string_view::npos ? text.size() : end + closing.size();
  }
  return at;
}

/// First word that is neither white space nor in a "#" comment.
std::string_view first_word(std::string_view text) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (;;) {
    at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    if (at == text.size() || text[at] != '#') break;
    at = std::min(text.find('\n', at), text.size());
  }
  const std::size_t end = std::min(text.find_first_of(" \t\r\n(", at), text.size());
  return text.substr(at, end - at + (end < text.size() && text[end] == '(' ? 1 : 0));
}

bool looks_like_turtle(std::string_view word) {
  if (word == "@prefix" || word == "@base" || word == "PREFIX" || word == "BASE" || word == "prefix" ||
      word == "base")
    return true;
  if (word.starts_with("_:") || word.starts_with("[") || word.starts_with("<#")) return true;
  const bool absolute = word.find("://") != std::string_view::npos || word.starts_with("<urn:");
  return word.starts_with("<") && absolute && word.find('>') != std::string_view::npos;
}

Syntax by_extension(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string extension = dot == std::string::npos ? "" : name.substr(dot + 1);
  if (extension == "ttl" || extension == "nt") return Syntax::Turtle;
  if (extension == "rdf" || extension == "owl" || extension == "xml") return Syntax::RdfXml;
  if (extension == "owx") return Syntax::OwlXml;
  if (extension == "ofn" || extension == "fss") return Syntax::Functional;
  if (extension == "omn") return Syntax::Manchester;
  return Syntax::Unknown;
}

/// A document that was read as triples.
class GraphDocument : public Document {
 public:
  explicit GraphDocument(Graph graph) : Document(graph.source), graph_(std::move(graph)) {}
  [[nodiscard]] Header header() const override {
    Header out;
    for (const Triple& t : graph_.triples) {
      if (t.predicate == v::rdf_type && t.object == v::owl_ontology && t.subject.is_iri())
        out.names.push_back(t.subject.as_iri());
      else if (t.predicate == v::owl_version_iri && t.object.is_iri())
        out.names.push_back(t.object.as_iri());
      else if (t.predicate == v::owl_imports && t.object.is_iri())
        out.imports.emplace_back(t.object.as_iri(), t.offset);
    }
    return out;
  }
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prefixes() const override {
    return graph_.prefixes;
  }
  void declare(KindTable& kinds) override { collect_declared(graph_, kinds); }
  bool infer(KindTable& kinds, const IriTable& iris) override { return infer_from_use(graph_, kinds, iris); }
  void finish(OntologyData& data, const ReadContext& context, std::size_t number) override {
    Mapper(graph_, data, context.diagnostics, context.limits, number).run();
  }

 private:
  Graph graph_;
};

[[noreturn]] void no_reader(const util::SourceText& source) {
  throw util::InputError(source, 0, "unknown-syntax", "this is no syntax of OWL that heed knows",
                         "RDF/XML, Turtle, OWL/XML, functional-style and Manchester syntax are read");
}

}  // namespace

std::string_view to_string(Syntax syntax) {
  static constexpr std::array<std::string_view, 6> names = {
      "RDF/XML", "Turtle", "OWL/XML", "functional-style syntax", "Manchester syntax", "an unknown syntax"};
  return names[static_cast<std::size_t>(syntax)];
}

Syntax recognise(const util::SourceText& source) {
  const std::string_view text = source.text();
  const std::string_view word = first_word(text);
  if (looks_like_turtle(word)) return Syntax::Turtle;
  if (word == "Prefix(" || word == "Ontology(" || word == "Prefix" || word == "Ontology")
    return Syntax::Functional;
  if (word == "Prefix:" || word == "Ontology:" || word.starts_with("Prefix::")) return Syntax::Manchester;
  if (word.starts_with("<")) {
    const std::string_view root = text.substr(root_element(text), 200);
    const std::string_view name = root.substr(0, root.find_first_of(" \t\r\n>/"));
    const bool owl_xml = name == "<Ontology" ||
                         (name.ends_with(":Ontology") && root.find("ontologyIRI") != std::string_view::npos);
    return owl_xml ? Syntax::OwlXml : Syntax::RdfXml;
  }
  return by_extension(source.name());
}

std::unique_ptr<Document> read_document(const util::SourceText& given, ReadContext context) {
  if (given.text().size() >= UINT32_MAX)
    throw util::InputError(given, 0, "file-too-large", "an ontology document must be smaller than 4 GiB");
  const util::SourceText source = in_utf8(given);
  const Syntax syntax = recognise(source);
  switch (syntax) {
    case Syntax::Turtle:
      return std::make_unique<GraphDocument>(read_turtle(source, context));
    case Syntax::RdfXml:
      return std::make_unique<GraphDocument>(read_rdf_xml(source, context));
    case Syntax::OwlXml:
      return read_owl_xml(source, context);
    case Syntax::Functional:
      return read_functional(source, context);
    case Syntax::Manchester:
      return read_manchester(source, context);
    default:
      no_reader(source);
  }
}

Ontology finish_documents(std::vector<std::unique_ptr<Document>>& documents,
                          std::shared_ptr<OntologyData> data, const util::Limits& limits,
                          util::Diagnostics& diagnostics) {
  for (const auto& document : documents) document->declare(data->kinds);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& document : documents) changed |= document->infer(data->kinds, data->iris);
  }
  for (std::size_t number = 0; number < documents.size(); ++number)
    documents[number]->finish(*data, {data->iris, data->kinds, limits, diagnostics, number}, number);
  if (!documents.empty()) data->prefixes = documents.front()->prefixes();
  return Ontology(std::move(data));
}

Ontology read(const util::SourceText& source, const util::Limits& limits, util::Diagnostics& diagnostics) {
  auto data = std::make_shared<OntologyData>();
  add_builtin_kinds(data->kinds, data->iris);
  std::vector<std::unique_ptr<Document>> documents;
  documents.push_back(read_document(source, {data->iris, data->kinds, limits, diagnostics}));
  return finish_documents(documents, std::move(data), limits, diagnostics);
}

}  // namespace heed::owl
