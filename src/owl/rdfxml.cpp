#include "graph.h"
#include "resolve.h"
#include "xml_entities.h"
#include "xml_input.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <deque>
#include <map>
#include <unordered_map>

// RDF 1.1 XML Syntax, section 7, as a machine with an explicit stack: an element is opened, its children are
// taken one by one, it is closed. A statement goes out when the element that states it is met, hence before
// what is nested in it: the triples come in document order.

namespace heed::owl {
namespace {

namespace v = vocabulary;
constexpr std::string_view rdf_namespace = HEED_RDF;

enum class Role {
  Document,    ///< Children are node elements.
  Node,        ///< Children are property elements of `subject`.
  Object,      ///< A property element: its one child is the object.
  Collection,  ///< Children are the members of a list.
};

struct Frame {
  Role role;
  pugi::xml_node element;
  pugi::xml_node next;
  Term subject;
  Iri property{};
  std::uint32_t member = 0;  ///< Of rdf:li.
  bool filled = false;       ///< Object: has its child; Collection: `subject` is the last cell.
  std::size_t scopes = 0;    ///< Namespace bindings outside this element.
  const std::string* base = nullptr;
  std::string_view language;
};

struct Attribute {
  std::string_view prefix, local;
  pugi::xml_attribute raw;
};

struct Reference {
  Term term;
  bool given = false;
};

class RdfXml {
 public:
  RdfXml(const util::SourceText& source, ReadContext context)
      : context_(context), input_(source), entities_(graph_.source, context.limits) {
    graph_.source = source;
  }
  Graph read();

 private:
  struct Binding {
    std::string_view prefix, uri;
  };

  void take_child(Frame& top);
  void close(const Frame& frame);
  Frame open(Role role, pugi::xml_node element, const Frame& outer);
  void bind_names(Frame& frame);
  void leave(const Frame& frame);
  void node_element(pugi::xml_node element);
  void property_element(pugi::xml_node element);
  bool parse_type(Frame& frame, std::string_view type, Term subject);
  void empty_or_literal(Frame& frame, Term subject);
  void literal_content(const Frame& frame, Term subject, std::string_view datatype);
  void attributes_as_triples(const Frame& frame, Term subject);
  void attach(Term node, std::size_t offset);
  void state(const Frame& frame, Term subject, Term object);
  Term subject_of(const Frame& frame);
  Reference reference(const Frame& frame, std::string_view resource_word);
  Term resource(const Frame& frame, std::string_view text, std::size_t offset);
  Term named_blank(std::string_view name, std::size_t offset);
  Iri identifier(const Frame& frame, pugi::xml_attribute attribute);
  Iri name_of(pugi::xml_node element);
  Iri name_of(const Attribute& attribute);
  std::string_view namespace_of(std::string_view prefix, std::size_t offset);
  void check_iri(Iri iri, std::size_t offset);

  [[nodiscard]] std::size_t offset_of(const char* place) const { return input_.offset_of(place); }
  [[nodiscard]] std::size_t offset_of(pugi::xml_node node) const { return input_.offset_of(node); }
  std::string_view value_of(pugi::xml_attribute attribute) {
    return entities_.expand(attribute.value(), offset_of(attribute.value()));
  }
  /// The value of rdf:WORD, unexpanded, or an empty attribute.
  pugi::xml_attribute rdf_attribute(const Frame& frame, std::string_view word);
  [[noreturn]] void fail(std::size_t offset, const char* code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(graph_.source, offset, code, std::move(message), std::move(hint));
  }

  ReadContext context_;
  Graph graph_;
  XmlInput input_;
  XmlEntities entities_;
  std::vector<Frame> stack_;
  std::vector<Binding> bindings_;
  std::deque<std::string> kept_;                     ///< Bases, namespaces and languages, at fixed addresses.
  std::unordered_map<std::string_view, Iri> names_;  ///< Of elements, while the bindings stand.
  std::unordered_map<std::string, Term> blanks_;
  std::vector<bool> identified_;  ///< By Iri: used in an rdf:ID.
  std::vector<bool> checked_;     ///< By Iri: first_bad_character() was asked.
  std::string scratch_;
};

Graph RdfXml::read() {
  bindings_.push_back({"xml", "http://www.w3.org/XML/1998/namespace"});
  for (const pugi::xml_node child : input_.document().children()) {
    if (child.type() == pugi::node_doctype) entities_.declare(child.value(), offset_of(child.value()));
  }
  const pugi::xml_node root = input_.root();
  kept_.emplace_back("file:" + graph_.source.name());
  Frame outside{.role = Role::Document,
                .element = input_.document(),
                .next = {},
                .subject = {},
                .base = &kept_.back(),
                .language = {}};
  Frame frame = open(Role::Document, root, outside);
  for (const Binding& binding : bindings_)
    if (binding.prefix != "xml") graph_.prefixes.emplace_back(binding.prefix, binding.uri);
  if (name_of(root) == context_.iris.intern(HEED_RDF "RDF")) {
    stack_.push_back(frame);
  } else {
    stack_.push_back(outside);
    node_element(root);
  }
  while (!stack_.empty()) {
    take_child(stack_.back());
  }
  return std::move(graph_);
}

/// Opens the next child element of \p top, or closes it.
void RdfXml::take_child(Frame& top) {
  while (top.next && top.next.type() != pugi::node_element) {
    const bool is_text = top.next.type() == pugi::node_pcdata || top.next.type() == pugi::node_cdata;
    if (is_text && std::string_view(top.next.value()).find_first_not_of(" \t\r\n") != std::string_view::npos)
      fail(offset_of(top.next.value()), "stray-text", "text stands where an element is expected",
           "a literal must be the only content of its property");
    top.next = top.next.next_sibling();
  }
  if (!top.next) {
    const Frame done = top;
    stack_.pop_back();
    close(done);
    return;
  }
  const pugi::xml_node child = top.next;
  top.next = child.next_sibling();
  if (context_.limits.nesting != 0 && stack_.size() > context_.limits.nesting)
    fail(offset_of(child), "nesting",
         fmt::format("elements nest more than {} deep", context_.limits.nesting));
  if (top.role == Role::Node)
    property_element(child);
  else
    node_element(child);
}

void RdfXml::close(const Frame& frame) {
  leave(frame);
  if (frame.role != Role::Collection) return;
  const Term nil = Term::iri(v::rdf_nil);
  const std::size_t offset = offset_of(frame.element);
  if (frame.filled)
    graph_.add(frame.subject, v::rdf_rest, nil, offset);
  else
    graph_.add(frame.subject, frame.property, nil, offset);
}

Frame RdfXml::open(Role role, pugi::xml_node element, const Frame& outer) {
  Frame frame{.role = role,
              .element = element,
              .next = element.first_child(),
              .subject = {},
              .base = outer.base,
              .language = outer.language};
  frame.scopes = bindings_.size();
  bind_names(frame);
  return frame;
}

/// Forgets the bindings of an element, and the names that were read under them.
void RdfXml::leave(const Frame& frame) {
  if (bindings_.size() == frame.scopes) return;
  bindings_.resize(frame.scopes);
  names_.clear();
}

void RdfXml::bind_names(Frame& frame) {
  for (const pugi::xml_attribute attribute : frame.element.attributes()) {
    const std::string_view name = attribute.name();
    if (name.substr(0, 3) != "xml") continue;
    if (name == "xmlns" || name.substr(0, 6) == "xmlns:") {
      kept_.emplace_back(value_of(attribute));
      bindings_.push_back({name.size() > 6 ? name.substr(6) : std::string_view(), kept_.back()});
      names_.clear();
    } else if (name == "xml:base") {
      resolve_iri(*frame.base, value_of(attribute), scratch_);
      frame.base = &kept_.emplace_back(scratch_);
    } else if (name == "xml:lang") {
      std::string& language = kept_.emplace_back(value_of(attribute));
      if (!language.empty() && !is_language_tag(language)) {
        context_.diagnostics.push_back(
            warning_at(graph_.source, offset_of(attribute.value()), "bad-language",
                       fmt::format("'{}' is no language and is left out", language), "such as en or de-AT"));
        language.clear();
      }
      for (char& c : language)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
      frame.language = language;
    }
  }
}

std::string_view RdfXml::namespace_of(std::string_view prefix, std::size_t offset) {
  for (auto binding = bindings_.rbegin(); binding != bindings_.rend(); ++binding)
    if (binding->prefix == prefix) return binding->uri;
  if (prefix.empty()) return {};
  std::vector<std::string> known;
  for (const Binding& binding : bindings_) known.emplace_back(binding.prefix);
  fail(offset, "undeclared-prefix", fmt::format("prefix '{}' is not declared", prefix),
       util::suggestion(prefix, known));
}

Iri RdfXml::name_of(pugi::xml_node element) {
  const std::string_view name = element.name();
  if (const auto found = names_.find(name); found != names_.end()) return found->second;
  const auto [prefix, local] = split_name(name);
  scratch_.assign(namespace_of(prefix, offset_of(element))).append(local);
  if (scratch_.size() == local.size())
    fail(offset_of(element), "no-namespace", fmt::format("element '{}' is in no namespace", name),
         "this is XML but not RDF/XML, or its xmlns declarations are missing");
  const Iri iri = context_.iris.intern(scratch_);
  check_iri(iri, offset_of(element));
  names_.emplace(name, iri);
  return iri;
}

Iri RdfXml::name_of(const Attribute& attribute) {
  scratch_.assign(namespace_of(attribute.prefix, offset_of(attribute.raw.name()))).append(attribute.local);
  const Iri iri = context_.iris.intern(scratch_);
  check_iri(iri, offset_of(attribute.raw.name()));
  return iri;
}

void RdfXml::check_iri(Iri iri, std::size_t offset) {
  if (iri.id < checked_.size() && checked_[iri.id]) return;
  if (iri.id >= checked_.size()) checked_.resize(context_.iris.size() + 64);
  checked_[iri.id] = true;
  const std::string_view text = context_.iris.text(iri);
  const std::size_t bad = first_bad_character(text);
  if (bad == std::string_view::npos) return;
  context_.diagnostics.push_back(
      warning_at(graph_.source, offset, "bad-iri",
                 fmt::format("'{}' is no IRI: it holds '{}'", text, text.substr(bad, 1)),
                 "write such a character as %20 and the like"));
}

Term RdfXml::resource(const Frame& frame, std::string_view text, std::size_t offset) {
  resolve_iri(*frame.base, text, scratch_);
  const Iri iri = context_.iris.intern(scratch_);
  check_iri(iri, offset);
  return Term::iri(iri);
}

Term RdfXml::named_blank(std::string_view name, std::size_t offset) {
  if (name.empty()) fail(offset, "bad-node-id", "rdf:nodeID is empty");
  const auto [place, is_new] = blanks_.try_emplace(std::string(name));
  if (is_new) place->second = graph_.new_blank();
  return place->second;
}

pugi::xml_attribute RdfXml::rdf_attribute(const Frame& frame, std::string_view word) {
  for (const pugi::xml_attribute attribute : frame.element.attributes()) {
    const auto [prefix, local] = split_name(attribute.name());
    if (local == word && !prefix.empty() &&
        namespace_of(prefix, offset_of(attribute.name())) == rdf_namespace)
      return attribute;
  }
  return {};
}

Iri RdfXml::identifier(const Frame& frame, pugi::xml_attribute attribute) {
  const std::size_t offset = offset_of(attribute.value());
  const std::string_view value = value_of(attribute);
  const std::string_view bad = " /:#?&<>\"'";
  if (value.empty() || value.find_first_of(bad) != std::string_view::npos)
    fail(offset, "bad-id", fmt::format("rdf:ID '{}' is not a plain name", value), "use rdf:about for an IRI");
  const std::string fragment = "#" + std::string(value);
  resolve_iri(*frame.base, fragment, scratch_);
  const Iri iri = context_.iris.intern(scratch_);
  if (iri.id >= identified_.size()) identified_.resize(context_.iris.size() + 64);
  if (identified_[iri.id])
    context_.diagnostics.push_back(
        warning_at(graph_.source, offset, "duplicate-id",
                   fmt::format("rdf:ID '{}' stands twice in the document", fragment.substr(1)),
                   "use rdf:about for the second mention"));
  identified_[iri.id] = true;
  return iri;
}

Term RdfXml::subject_of(const Frame& frame) {
  const auto about = rdf_attribute(frame, "about");
  const auto id = rdf_attribute(frame, "ID");
  const auto node = rdf_attribute(frame, "nodeID");
  if (static_cast<int>(static_cast<bool>(about)) + static_cast<int>(static_cast<bool>(id)) +
          static_cast<int>(static_cast<bool>(node)) >
      1)
    fail(offset_of(frame.element), "two-subjects",
         "an element has more than one of rdf:about, rdf:ID and rdf:nodeID");
  if (about) return resource(frame, value_of(about), offset_of(about.value()));
  if (id) return Term::iri(identifier(frame, id));
  if (node) return named_blank(value_of(node), offset_of(node.value()));
  return graph_.new_blank();
}

/// States that \p node is what the frame on top waits for.
void RdfXml::attach(Term node, std::size_t offset) {
  Frame& top = stack_.back();
  if (top.role == Role::Object) {
    if (top.filled)
      fail(offset, "two-objects", "a property has two objects", "repeat the property, or use a collection");
    top.filled = true;
    state(top, top.subject, node);
  } else if (top.role == Role::Collection) {
    const Term cell = graph_.new_blank();
    graph_.add(top.subject, top.filled ? v::rdf_rest : top.property, cell,
               top.filled ? offset : offset_of(top.element));
    graph_.add(cell, v::rdf_first, node, offset);
    top.subject = cell;
    top.filled = true;
  }
}

void RdfXml::node_element(pugi::xml_node element) {
  Frame frame = open(Role::Node, element, stack_.back());
  frame.subject = subject_of(frame);
  attach(frame.subject, offset_of(element));
  const Iri type = name_of(element);
  static constexpr std::string_view description = HEED_RDF "Description";
  if (context_.iris.text(type) != description)
    graph_.add(frame.subject, v::rdf_type, Term::iri(type), offset_of(element));
  attributes_as_triples(frame, frame.subject);
  stack_.push_back(frame);
}

/// rdf:type and all attributes outside rdf: and xml: state something of \p subject.
void RdfXml::attributes_as_triples(const Frame& frame, Term subject) {
  for (const pugi::xml_attribute attribute : frame.element.attributes()) {
    const std::string_view name = attribute.name();
    const auto [prefix, local] = split_name(name);
    if (prefix == "xml" || name.substr(0, 5) == "xmlns") continue;
    const std::size_t offset = offset_of(attribute.name());
    if (prefix.empty())
      fail(
          offset, "no-namespace", fmt::format("attribute '{}' is in no namespace", name),
          local == "about" || local == "resource" || local == "ID" ? fmt::format("write rdf:{}", local) : "");
    if (namespace_of(prefix, offset) == rdf_namespace) {
      if (local == "type") {
        const Term type = resource(frame, value_of(attribute), offset);
        graph_.add(subject, v::rdf_type, type, offset);
      } else if (local != "about" && local != "ID" && local != "nodeID" && local != "resource" &&
                 local != "datatype" && local != "parseType") {
        fail(offset, "bad-rdf-attribute", fmt::format("'{}' is no attribute of RDF", name),
             util::suggestion(local, {"about", "ID", "nodeID", "resource", "datatype", "parseType", "type"}));
      }
      continue;
    }
    const Iri property = name_of({prefix, local, attribute});
    const bool tagged = !frame.language.empty();
    const Term value =
        graph_.add_literal({std::string(value_of(attribute)), tagged ? v::rdf_lang_string : v::xsd_string,
                            std::string(frame.language)});
    graph_.add(subject, property, value, offset);
  }
}

/// Adds the triple of a property element, and its reification where it has an rdf:ID.
void RdfXml::state(const Frame& frame, Term subject, Term object) {
  const std::size_t offset = offset_of(frame.element);
  graph_.add(subject, frame.property, object, offset);
  const auto id = rdf_attribute(frame, "ID");
  if (!id) return;
  const Term statement = Term::iri(identifier(frame, id));
  graph_.add(statement, v::rdf_type, Term::iri(v::rdf_statement), offset);
  graph_.add(statement, v::rdf_subject, subject, offset);
  graph_.add(statement, v::rdf_predicate, Term::iri(frame.property), offset);
  graph_.add(statement, v::rdf_object, object, offset);
}

void RdfXml::property_element(pugi::xml_node element) {
  Frame& outer = stack_.back();
  const Term subject = outer.subject;
  Frame frame = open(Role::Object, element, outer);
  frame.subject = subject;
  frame.property = name_of(element);
  if (context_.iris.text(frame.property) == HEED_RDF "li")
    frame.property = context_.iris.intern(fmt::format(HEED_RDF "_{}", ++outer.member));
  if (const auto type = rdf_attribute(frame, "parseType"); type && parse_type(frame, value_of(type), subject))
    return;
  bool has_element = false;
  for (const pugi::xml_node child : element.children()) has_element |= child.type() == pugi::node_element;
  if (!has_element) {
    empty_or_literal(frame, subject);
    leave(frame);
    return;
  }
  if (rdf_attribute(frame, "resource") || rdf_attribute(frame, "nodeID") || rdf_attribute(frame, "datatype"))
    fail(offset_of(element), "two-objects",
         "a property has both an attribute that names its object and a nested object");
  stack_.push_back(frame);
}

bool RdfXml::parse_type(Frame& frame, std::string_view type, Term subject) {
  if (type == "Resource") {
    const Term node = graph_.new_blank();
    state(frame, subject, node);
    frame.role = Role::Node;
    frame.subject = node;
    stack_.push_back(frame);
  } else if (type == "Collection") {
    frame.role = Role::Collection;
    stack_.push_back(frame);
  } else {
    struct Text : pugi::xml_writer {
      std::string text;
      void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), size);
      }
    } writer;
    for (const pugi::xml_node child : frame.element.children())
      child.print(writer, "", pugi::format_raw | pugi::format_no_escapes);
    state(frame, subject, graph_.add_literal({writer.text, v::rdf_xml_literal, {}}));
    leave(frame);
  }
  return true;
}

Reference RdfXml::reference(const Frame& frame, std::string_view resource_word) {
  const auto named = rdf_attribute(frame, resource_word);
  const auto node = rdf_attribute(frame, "nodeID");
  if (named && node)
    fail(offset_of(frame.element), "two-objects",
         fmt::format("an element has both rdf:{} and rdf:nodeID", resource_word));
  if (named) return {resource(frame, value_of(named), offset_of(named.value())), true};
  if (node) return {named_blank(value_of(node), offset_of(node.value())), true};
  return {};
}

void RdfXml::empty_or_literal(Frame& frame, Term subject) {
  const Reference object = reference(frame, "resource");
  bool describes = false;
  for (const pugi::xml_attribute attribute : frame.element.attributes()) {
    const std::string_view name = attribute.name();
    const auto [prefix, local] = split_name(name);
    if (prefix.empty() || prefix == "xml" || prefix == "xmlns") continue;
    const bool is_rdf = namespace_of(prefix, offset_of(attribute.name())) == rdf_namespace;
    describes |= !is_rdf || local == "type";
  }
  if (object.given || describes) {
    const Term node = object.given ? object.term : graph_.new_blank();
    state(frame, subject, node);
    attributes_as_triples(frame, node);
    return;
  }
  const auto datatype = rdf_attribute(frame, "datatype");
  scratch_.clear();
  Iri type = frame.language.empty() ? v::xsd_string : v::rdf_lang_string;
  if (datatype) type = resource(frame, value_of(datatype), offset_of(datatype.value())).as_iri();
  std::string text;
  for (const pugi::xml_node child : frame.element.children()) {
    if (child.type() == pugi::node_cdata) text += child.value();
    if (child.type() == pugi::node_pcdata) text += entities_.expand(child.value(), offset_of(child.value()));
  }
  const std::string language(datatype ? std::string_view() : frame.language);
  state(frame, subject, graph_.add_literal({std::move(text), type, language}));
}

}  // namespace

Graph read_rdf_xml(const util::SourceText& source, ReadContext context) {
  return RdfXml(source, context).read();
}

}  // namespace heed::owl
