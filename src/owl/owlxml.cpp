#include "resolve.h"
#include "structural.h"
#include "xml_entities.h"
#include "xml_input.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <charconv>
#include <deque>

// OWL 2 XML Serialization: elements are the words of the structural specification, so the tree goes to the
// StructuralBuilder as it stands. An explicit stack keeps the depth of the input off the machine's.

namespace heed::owl {
namespace {

namespace v = vocabulary;

struct Frame {
  pugi::xml_node next;
  const std::string* base;
  std::string_view language;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

std::optional<EntityKind> entity_kind(std::string_view word) {
  static constexpr std::pair<std::string_view, EntityKind> kinds[] = {
      {"Class", EntityKind::Class},
      {"ObjectProperty", EntityKind::ObjectProperty},
      {"NamedIndividual", EntityKind::NamedIndividual},
      {"DataProperty", EntityKind::DataProperty},
      {"Datatype", EntityKind::Datatype},
      {"AnnotationProperty", EntityKind::AnnotationProperty}};
  for (const auto& [name, kind] : kinds)
    if (name == word) return kind;
  return std::nullopt;
}

class OwlXml {
 public:
  OwlXml(const util::SourceText& source, const ReadContext& context)
      : input_(source),
        entities_(source, context.limits),
        names_(source, context),
        builder_(names_, parsed_) {}
  Parsed read();

 private:
  void root();
  void header_iri(const char* attribute, Iri& iri, bool& present);
  void child(Frame& top);
  void take(pugi::xml_node element, const Frame& frame);
  bool leaf(pugi::xml_node element, std::string_view word, const Frame& frame);
  void prefix(pugi::xml_node element);
  void import(pugi::xml_node element, const Frame& frame);
  Frame inside(pugi::xml_node element, const Frame& outer);
  Iri named(pugi::xml_node element, const Frame& frame);
  Literal literal(pugi::xml_node element, const Frame& frame);
  void cardinality(pugi::xml_attribute attribute);
  std::string text_of(pugi::xml_node element);
  std::string value_of(pugi::xml_attribute attribute) {
    return std::string(entities_.expand(attribute.value(), input_.offset_of(attribute.value())));
  }
  std::string required(pugi::xml_node element, const char* attribute);

  Parsed parsed_;
  XmlInput input_;
  XmlEntities entities_;
  Names names_;
  StructuralBuilder builder_;
  std::vector<Frame> stack_;
  std::deque<std::string> kept_;
};

Parsed OwlXml::read() {
  for (const pugi::xml_node node : input_.document().children())
    if (node.type() == pugi::node_doctype) entities_.declare(node.value(), input_.offset_of(node.value()));
  root();
  while (!stack_.empty()) {
    if (stack_.back().next) {
      child(stack_.back());
      continue;
    }
    stack_.pop_back();
    if (!stack_.empty()) builder_.close();
  }
  return std::move(parsed_);
}

void OwlXml::header_iri(const char* attribute, Iri& iri, bool& present) {
  const pugi::xml_attribute found = input_.root().attribute(attribute);
  if (!found) return;
  iri = names_.full(value_of(found), input_.offset_of(found.value()));
  present = true;
  parsed_.header.names.push_back(iri);
}

/// Relative names stand against xml:base, without it against the ontology's IRI.
void OwlXml::root() {
  const pugi::xml_node root = input_.root();
  const pugi::xml_attribute own = root.attribute("ontologyIRI");
  if (own) names_.set_base(value_of(own));
  kept_.push_back(names_.base());
  Frame frame = inside(root, {{}, &kept_.back(), {}});
  names_.set_base(*frame.base);
  header_iri("ontologyIRI", parsed_.iri, parsed_.has_iri);
  header_iri("versionIRI", parsed_.version, parsed_.has_version);
  stack_.push_back(frame);
}

Frame OwlXml::inside(pugi::xml_node element, const Frame& outer) {
  Frame frame{element.first_child(), outer.base, outer.language};
  if (const auto base = element.attribute("xml:base")) {
    std::string resolved;
    resolve_iri(*outer.base, value_of(base), resolved);
    frame.base = &kept_.emplace_back(std::move(resolved));
  }
  if (const auto attribute = element.attribute("xml:lang")) {
    std::string& language = kept_.emplace_back(value_of(attribute));
    if (!language.empty() && !is_language_tag(language)) {
      names_.warn(input_.offset_of(attribute.value()), "bad-language",
                  fmt::format("'{}' is no language and is left out", language), "such as en or de-AT");
      language.clear();
    }
    frame.language = language;
  }
  return frame;
}

void OwlXml::child(Frame& top) {
  const pugi::xml_node node = top.next;
  top.next = node.next_sibling();
  if (node.type() == pugi::node_element) {
    const Frame frame = inside(node, top);
    take(node, frame);
    return;
  }
  const bool is_text = node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
  if (is_text && !trimmed(node.value()).empty() && !builder_.ignoring())
    names_.fail(input_.offset_of(node.value()), "stray-text", "text stands where an element is expected",
                "only Literal, IRI, AbbreviatedIRI and Import hold text");
}

void OwlXml::take(pugi::xml_node element, const Frame& frame) {
  const std::string_view word = split_name(element.name()).second;
  if (stack_.size() == 1 && (word == "Prefix" || word == "Import"))
    return word == "Prefix" ? prefix(element) : import(element, frame);
  if (!builder_.ignoring() && leaf(element, word, frame)) return;
  builder_.open(word, input_.offset_of(element));
  if (!builder_.ignoring()) {
    if (const auto count = element.attribute("cardinality")) cardinality(count);
    if (word == "FacetRestriction") {
      const std::string facet = required(element, "facet");
      builder_.name(names_.resolved(*frame.base, facet, input_.offset_of(element)),
                    input_.offset_of(element));
    }
  }
  stack_.push_back(frame);
}

/// Names and literals. \returns false for any other element.
bool OwlXml::leaf(pugi::xml_node element, std::string_view word, const Frame& frame) {
  const std::size_t offset = input_.offset_of(element);
  if (const auto kind = entity_kind(word)) {
    builder_.entity(*kind, named(element, frame), offset);
  } else if (word == "AnonymousIndividual") {
    builder_.name(names_.anonymous(required(element, "nodeID")), offset);
  } else if (word == "IRI") {
    builder_.name(names_.resolved(*frame.base, trimmed(text_of(element)), offset), offset);
  } else if (word == "AbbreviatedIRI") {
    builder_.name(names_.abbreviated(trimmed(text_of(element)), offset), offset);
  } else if (word == "Literal") {
    builder_.literal(literal(element, frame), offset);
  } else {
    return false;
  }
  return true;
}

void OwlXml::prefix(pugi::xml_node element) {
  const std::string name = value_of(element.attribute("name"));
  const std::string uri = required(element, "IRI");
  names_.declare_prefix(name, uri);
  parsed_.prefixes.emplace_back(name, uri);
}

void OwlXml::import(pugi::xml_node element, const Frame& frame) {
  const std::size_t offset = input_.offset_of(element);
  const std::string target = text_of(element);
  if (trimmed(target).empty()) names_.fail(offset, "bad-import", "the import names no document");
  parsed_.header.imports.emplace_back(names_.resolved(*frame.base, trimmed(target), offset),
                                      static_cast<std::uint32_t>(offset));
}

std::string OwlXml::required(pugi::xml_node element, const char* attribute) {
  const pugi::xml_attribute found = element.attribute(attribute);
  if (!found)
    names_.fail(input_.offset_of(element), "missing-attribute",
                fmt::format("{} has no attribute '{}'", element.name(), attribute));
  return value_of(found);
}

Iri OwlXml::named(pugi::xml_node element, const Frame& frame) {
  const pugi::xml_attribute iri = element.attribute("IRI");
  const pugi::xml_attribute abbreviated = element.attribute("abbreviatedIRI");
  if (iri && abbreviated)
    names_.fail(input_.offset_of(element), "two-names",
                fmt::format("{} has both an IRI and an abbreviatedIRI", element.name()));
  if (iri) return names_.resolved(*frame.base, value_of(iri), input_.offset_of(iri.value()));
  if (abbreviated) return names_.abbreviated(value_of(abbreviated), input_.offset_of(abbreviated.value()));
  names_.fail(input_.offset_of(element), "missing-attribute",
              fmt::format("{} has neither an IRI nor an abbreviatedIRI", element.name()));
}

Literal OwlXml::literal(pugi::xml_node element, const Frame& frame) {
  Iri datatype = v::xsd_string;
  const pugi::xml_attribute given = element.attribute("datatypeIRI");
  if (given) datatype = names_.resolved(*frame.base, value_of(given), input_.offset_of(given.value()));
  std::string text = text_of(element);
  if (datatype == v::rdf_plain_literal) datatype = v::xsd_string;
  const bool may_be_tagged = datatype == v::xsd_string || datatype == v::rdf_lang_string;
  return Names::literal(std::move(text), datatype, may_be_tagged ? frame.language : std::string_view());
}

void OwlXml::cardinality(pugi::xml_attribute attribute) {
  const std::string text = value_of(attribute);
  const std::size_t offset = input_.offset_of(attribute.value());
  std::uint32_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size())
    names_.fail(offset, "bad-cardinality", fmt::format("'{}' is no cardinality", text),
                "write a natural number");
  builder_.number(n, offset);
}

std::string OwlXml::text_of(pugi::xml_node element) {
  std::string out;
  for (const pugi::xml_node node : element.children()) {
    if (node.type() == pugi::node_cdata) out += node.value();
    if (node.type() == pugi::node_pcdata)
      out += entities_.expand(node.value(), input_.offset_of(node.value()));
    if (node.type() == pugi::node_element)
      names_.fail(input_.offset_of(node), "misplaced",
                  fmt::format("{} holds text only, not {}", element.name(), node.name()));
  }
  return out;
}

}  // namespace

std::unique_ptr<Document> read_owl_xml(const util::SourceText& source, ReadContext context) {
  return std::make_unique<ParsedDocument>(source, OwlXml(source, context).read());
}

}  // namespace heed::owl
