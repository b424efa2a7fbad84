#pragma once

#include "names.h"
#include "parsed.h"

#include <string_view>
#include <variant>
#include <vector>

namespace heed::owl {

/// OWL/XML and the functional-style syntax are two spellings of one tree: a word and what it is applied to.
/// Their readers report the tree as it is met; this machine turns it into axioms, children first, on a stack
/// of its own.
class StructuralBuilder {
 public:
  StructuralBuilder(Names& names, Parsed& parsed) : names_(names), parsed_(parsed) {}

  /// `word(` or `<word>`; the empty word is a plain bracket. \throws InputError  unknown or misplaced words,
  /// nesting over the limit
  void open(std::string_view word, std::size_t offset);
  /// \throws InputError  what was applied does not fit the word
  void close();
  void name(Iri iri, std::size_t offset);
  /// A name that says what it is: `<Class IRI="..."/>`.
  void entity(EntityKind kind, Iri iri, std::size_t offset);
  void literal(Literal literal, std::size_t offset);
  void number(std::uint32_t n, std::size_t offset);

  [[nodiscard]] std::size_t depth() const { return frames_.size() + ignored_; }
  /// Inside a rule, whose contents heed does not read.
  [[nodiscard]] bool ignoring() const { return ignored_ > 0; }

  struct Name {
    Iri iri;
    bool typed = false;
    EntityKind kind{};
  };
  struct Properties {
    std::vector<ObjectProperty> members;
    bool chain = false;
  };
  using Value = std::variant<Name, ObjectProperty, Properties, ClassExpression, DataRange, Literal, Facet,
                             Annotation, std::uint32_t>;
  struct Argument {
    Value value;
    std::size_t offset;
    std::uint32_t depth = 0;  ///< Of data ranges and annotations.
  };

  enum class Group { Axiom, Class, Range, Annotation, Inverse, Chain, Bracket, Entity, Facet, Rule };

 private:
  struct Frame {
    std::string_view word;
    Group group;
    unsigned code;  ///< In its group.
    std::size_t offset;
    std::size_t first;  ///< Of its arguments.
  };

  void push(Value value, std::size_t offset, std::uint32_t depth = 0);
  Argument built(const Frame& frame);
  void axiom(const Frame& frame);

  Names& names_;
  Parsed& parsed_;
  std::vector<Frame> frames_;
  std::vector<Argument> arguments_;
  std::size_t ignored_ = 0;
};

/// The arguments of one word, taken from left to right.
class Arguments {
 public:
  using Argument = StructuralBuilder::Argument;
  Arguments(Names& names, std::string_view word, std::size_t offset, Argument* first, Argument* last)
      : names_(names), word_(word), offset_(offset), next_(first), last_(last) {}

  ClassExpression class_expression();
  ObjectProperty property();
  Iri entity(EntityKind kind);
  Iri named_class() { return entity(EntityKind::Class); }
  Iri data_property() { return entity(EntityKind::DataProperty); }
  Iri annotation_property() { return entity(EntityKind::AnnotationProperty); }
  Iri individual() { return entity(EntityKind::NamedIndividual); }
  Iri iri();  ///< Whatever it names.
  DataRange range();
  Literal literal();
  AnnotationValue annotation_value();
  std::uint32_t number();
  std::vector<ObjectProperty> chain();                               ///< One property, or a chain.
  std::vector<ClassExpression> classes(std::size_t at_least);        ///< All that is left.
  std::vector<ObjectProperty> properties(std::size_t at_least);      ///< All that is left.
  std::vector<Iri> entities(EntityKind kind, std::size_t at_least);  ///< All that is left.
  std::vector<Annotation> annotations();                             ///< Those that stand here.

  [[nodiscard]] bool at_end() const { return next_ == last_; }
  template <class T>
  [[nodiscard]] const T* peek() const {
    return next_ == last_ ? nullptr : std::get_if<T>(&next_->value);
  }
  template <class T>
  T take() {
    return std::get<T>(std::move((next_++)->value));
  }
  [[nodiscard]] std::uint32_t depth() const { return depth_; }  ///< The greatest of those taken.
  /// \throws InputError  there are more
  void expect_end() const;
  [[noreturn]] void wrong(std::string_view expected) const;
  Names& names() { return names_; }

 private:
  template <class Take>
  auto rest(std::size_t at_least, std::string_view what, Take take);

  Names& names_;
  std::string_view word_;
  std::size_t offset_;
  Argument* next_;
  Argument* last_;
  std::uint32_t depth_ = 0;
};

/// Words in the order of ClassExpression::Kind, and of DataRange::Kind, from 1.
[[nodiscard]] const std::vector<std::string_view>& class_words();
[[nodiscard]] const std::vector<std::string_view>& range_words();
/// Words of axioms in a fixed order.
[[nodiscard]] const std::vector<std::string_view>& axiom_words();

[[nodiscard]] ClassExpression build_class(unsigned kind, Arguments& arguments);
[[nodiscard]] DataRange build_range(unsigned kind, Arguments& arguments);
/// \param word  Its place in axiom_words().
[[nodiscard]] AxiomContent build_axiom(unsigned word, Arguments& arguments);

}  // namespace heed::owl
