#include "graph.h"
#include "resolve.h"
#include "turtle_lexer.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <map>
#include <unordered_map>

// RDF 1.1 Turtle with an explicit stack instead of recursion. The statement that leads to "[" or "(" goes out
// when the bracket opens, so that triples come in document order. N-Triples is a subset.

namespace heed::owl {
namespace {

namespace v = vocabulary;

struct Frame {
  enum class Kind { Statement, Properties, Collection } kind;
  enum class Next { Subject, Predicate, Object, Separator } next;
  Term subject;  ///< Collection: the last cell.
  Iri predicate{};
  bool may_end = false;  ///< A statement that is only "[ ... ] .", or one that has a predicate.
  std::size_t opened = 0;
  std::size_t predicate_offset = 0;
};

class Turtle {
 public:
  Turtle(const util::SourceText& source, ReadContext context) : context_(context), lexer_(source) {
    graph_.source = source;
    base_ = "file:" + source.name();
  }
  Graph read();

 private:
  bool directive();
  void statement();
  void step(Frame& top);
  void step_predicate(Frame& top, char c);
  void step_separator(Frame& top, char c);
  void term_or_open(Frame& top, char c);
  void deliver(Frame& top, Term term, std::size_t offset);
  void push(Frame frame);
  Term term(char c);
  Term literal();
  Iri name();
  Iri reference();

  ReadContext context_;
  Graph graph_;
  TurtleLexer lexer_;
  std::string base_;
  std::map<std::string, std::string, std::less<>> namespaces_;
  std::unordered_map<std::string, Term> blanks_;
  std::vector<Frame> stack_;
  std::string scratch_;
};

Graph Turtle::read() {
  if (graph_.source.text().starts_with("\xEF\xBB\xBF")) lexer_.advance(3);
  while (lexer_.peek() != '\0' || lexer_.offset() < graph_.source.text().size()) {
    if (!directive()) statement();
  }
  return std::move(graph_);
}

/// "@prefix p: <x> ." and "PREFIX p: <x>", likewise base.
bool Turtle::directive() {
  const std::size_t begin = lexer_.offset();
  const bool old_style = lexer_.ahead(0) == '@';
  if (old_style) lexer_.advance();
  if (lexer_.take_word("prefix", !old_style)) {
    lexer_.peek();
    const std::string prefix(lexer_.prefix());
    if (lexer_.peek() != '<')
      lexer_.fail(lexer_.offset(), "turtle-syntax", "expected '<' and the namespace of the prefix");
    resolve_iri(base_, lexer_.iri_reference(), scratch_);
    if (namespaces_.insert_or_assign(prefix, scratch_).second) graph_.prefixes.emplace_back(prefix, scratch_);
  } else if (lexer_.take_word("base", !old_style)) {
    if (lexer_.peek() != '<') lexer_.fail(lexer_.offset(), "turtle-syntax", "expected '<' and the base");
    resolve_iri(base_, lexer_.iri_reference(), scratch_);
    base_ = scratch_;
  } else {
    if (old_style) lexer_.fail(begin, "turtle-syntax", "expected @prefix or @base");
    return false;
  }
  if (old_style) lexer_.expect('.', "at the end of the directive");
  return true;
}

void Turtle::statement() {
  stack_.push_back({.kind = Frame::Kind::Statement,
                    .next = Frame::Next::Subject,
                    .subject = {},
                    .opened = lexer_.offset()});
  while (!stack_.empty()) step(stack_.back());
}

void Turtle::push(Frame frame) {
  if (context_.limits.nesting != 0 && stack_.size() >= context_.limits.nesting)
    lexer_.fail(frame.opened, "nesting",
                fmt::format("brackets nest more than {} deep", context_.limits.nesting),
                "give the inner expression a name of its own");
  stack_.push_back(frame);
}

void Turtle::step(Frame& top) {
  const char c = lexer_.peek();
  if (top.kind == Frame::Kind::Collection) {
    if (c != ')') {
      if (c == '\0') lexer_.fail(top.opened, "open-list", "the list has no closing ')'");
      return term_or_open(top, c);
    }
    graph_.add(top.subject, v::rdf_rest, Term::iri(v::rdf_nil), lexer_.offset());
    lexer_.advance();
    stack_.pop_back();
  } else if (top.next == Frame::Next::Predicate) {
    step_predicate(top, c);
  } else if (top.next == Frame::Next::Separator) {
    step_separator(top, c);
  } else {
    term_or_open(top, c);
  }
}

void Turtle::step_predicate(Frame& top, char c) {
  const char closing = top.kind == Frame::Kind::Statement ? '.' : ']';
  if (c == closing && top.may_end) {
    lexer_.advance();
    stack_.pop_back();
    return;
  }
  if (c == '\0')
    lexer_.fail(top.opened, "open-statement", fmt::format("the statement has no closing '{}'", closing));
  top.predicate_offset = lexer_.offset();
  if (lexer_.take_word("a"))
    top.predicate = v::rdf_type;
  else if (c == '<' || c == ':' || std::isalpha(static_cast<unsigned char>(c)) != 0 ||
           static_cast<unsigned char>(c) >= 0x80)
    top.predicate = c == '<' ? reference() : name();
  else
    lexer_.fail(lexer_.offset(), "turtle-syntax",
                fmt::format("expected a property or '{}', found '{}'", closing, c));
  top.next = Frame::Next::Object;
}

void Turtle::step_separator(Frame& top, char c) {
  const char closing = top.kind == Frame::Kind::Statement ? '.' : ']';
  top.may_end = true;
  if (c == ',') {
    lexer_.advance();
    top.predicate_offset = 0;
    top.next = Frame::Next::Object;
  } else if (c == ';') {
    while (lexer_.peek() == ';') lexer_.advance();
    top.next = Frame::Next::Predicate;
  } else if (c == closing) {
    lexer_.advance();
    stack_.pop_back();
  } else if (c == '\0') {
    lexer_.fail(top.opened, "open-statement", fmt::format("the statement has no closing '{}'", closing));
  } else {
    lexer_.fail(lexer_.offset(), "turtle-syntax",
                fmt::format("expected ',', ';' or '{}', found '{}'", closing, c));
  }
}

/// The term, list or blank node that \p top waits for. References into the stack end where something is
/// pushed.
void Turtle::term_or_open(Frame& top, char c) {
  const std::size_t offset = lexer_.offset();
  if (c != '[' && c != '(') return deliver(top, term(c), offset);
  lexer_.advance();
  if (c == '(' && lexer_.peek() == ')') {
    lexer_.advance();
    return deliver(top, Term::iri(v::rdf_nil), offset);
  }
  const Term node = graph_.new_blank();
  deliver(top, node, offset);
  if (c == '(') {
    push({.kind = Frame::Kind::Collection, .next = Frame::Next::Subject, .subject = node, .opened = offset});
  } else {
    if (top.kind == Frame::Kind::Statement) top.may_end |= top.next == Frame::Next::Predicate;
    push({.kind = Frame::Kind::Properties,
          .next = Frame::Next::Predicate,
          .subject = node,
          .may_end = true,
          .opened = offset});
  }
}

void Turtle::deliver(Frame& top, Term term, std::size_t offset) {
  if (top.kind == Frame::Kind::Collection) {
    if (top.may_end) {
      const Term cell = graph_.new_blank();
      graph_.add(top.subject, v::rdf_rest, cell, offset);
      top.subject = cell;
    }
    top.may_end = true;
    graph_.add(top.subject, v::rdf_first, term, offset);
  } else if (top.next == Frame::Next::Subject) {
    if (term.is_literal())
      lexer_.fail(offset, "literal-subject", "a literal cannot be the subject of a statement");
    top.subject = term;
    top.next = Frame::Next::Predicate;
  } else {
    graph_.add(top.subject, top.predicate, term, top.predicate_offset != 0 ? top.predicate_offset : offset);
    top.next = Frame::Next::Separator;
  }
}

Term Turtle::term(char c) {
  if (c == '<') return Term::iri(reference());
  if (c == '_' && lexer_.ahead(1) == ':') {
    const auto [place, is_new] = blanks_.try_emplace(std::string(lexer_.blank_label()));
    if (is_new) place->second = graph_.new_blank();
    return place->second;
  }
  if (c == '"' || c == '\'') return literal();
  const bool sign =
      c == '+' || c == '-' || (c == '.' && std::isdigit(static_cast<unsigned char>(lexer_.ahead(1))) != 0);
  if (sign || std::isdigit(static_cast<unsigned char>(c)) != 0) {
    const auto number = lexer_.number();
    using Type = TurtleLexer::Number::Type;
    const Iri type = number.type == Type::Integer   ? v::xsd_integer
                     : number.type == Type::Decimal ? v::xsd_decimal
                                                    : v::xsd_double;
    return graph_.add_literal({std::string(number.text), type, {}});
  }
  if (lexer_.take_word("true")) return graph_.add_literal({"true", v::xsd_boolean, {}});
  if (lexer_.take_word("false")) return graph_.add_literal({"false", v::xsd_boolean, {}});
  return Term::iri(name());
}

Term Turtle::literal() {
  Literal out{lexer_.string_literal(), v::xsd_string, {}};
  if (lexer_.ahead(0) == '@') {
    out.language = lexer_.language_tag();
    for (char& c : out.language) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    out.datatype = v::rdf_lang_string;
  } else if (lexer_.ahead(0) == '^' && lexer_.ahead(1) == '^') {
    lexer_.advance(2);
    out.datatype = lexer_.peek() == '<' ? reference() : name();
  }
  return graph_.add_literal(std::move(out));
}

Iri Turtle::reference() {
  resolve_iri(base_, lexer_.iri_reference(), scratch_);
  return context_.iris.intern(scratch_);
}

Iri Turtle::name() {
  const std::size_t offset = lexer_.offset();
  const std::string_view prefix = lexer_.prefix();
  const auto found = namespaces_.find(prefix);
  if (found == namespaces_.end()) {
    std::vector<std::string> known;
    for (const auto& entry : namespaces_) known.push_back(entry.first + ":");
    lexer_.fail(offset, "undeclared-prefix", fmt::format("prefix '{}:' is not declared", prefix),
                util::suggestion(std::string(prefix) + ":", known));
  }
  scratch_.assign(found->second).append(lexer_.local_name());
  return context_.iris.intern(scratch_);
}

}  // namespace

Graph read_turtle(const util::SourceText& source, ReadContext context) {
  return Turtle(source, context).read();
}

}  // namespace heed::owl
