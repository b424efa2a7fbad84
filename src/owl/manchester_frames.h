#pragma once

#include "manchester_expressions.h"
#include "parsed.h"

#include <set>
#include <tuple>
#include <utility>

namespace heed::owl {

/// Whether \p word begins a frame: "Class:", "DisjointClasses:", ...
[[nodiscard]] bool is_manchester_frame(std::string_view word);

/// Frames of the Manchester syntax as axioms.
class ManchesterFrames {
 public:
  ManchesterFrames(TextLexer& lexer, Names& names, Parsed& parsed)
      : lexer_(lexer), names_(names), parsed_(parsed), read_(lexer, names) {}

  void frame(EntityKind kind);  ///< \pre at the word of such a frame
  void list_of_equals();        ///< \pre at any other frame: "DisjointClasses:" and the like, "Rule:"
  std::vector<Annotation> annotations();  ///< Those that stand here, behind "Annotations:".
  ManchesterExpressions& expressions() { return read_; }

 private:
  /// What the sections of a frame are about.
  struct Subject {
    Iri iri;
    ClassExpression expression;
    ObjectProperty property;
    bool named = true;
  };
  using Section = void (ManchesterFrames::*)(const Subject&);

  std::vector<Annotation> annotations(unsigned depth);
  Annotation annotation(unsigned depth);
  Subject subject_of(EntityKind kind);
  static Section section(EntityKind kind, std::string_view word);
  void about(const Subject& subject);

  void sub_class(const Subject& s);
  void super_class(const Subject& s);
  void equivalent_class(const Subject& s);
  void disjoint_class(const Subject& s);
  void disjoint_union(const Subject& s);
  void has_key(const Subject& s);
  void domain(const Subject& s);
  void range(const Subject& s);
  void characteristics(const Subject& s);
  void sub_property(const Subject& s);
  void super_property(const Subject& s);
  void equivalent_property(const Subject& s);
  void disjoint_property(const Subject& s);
  void inverse(const Subject& s);
  void chain(const Subject& s);
  void data_domain(const Subject& s);
  void data_range(const Subject& s);
  void data_characteristics(const Subject& s);
  void sub_data_property(const Subject& s);
  void equivalent_data_property(const Subject& s);
  void disjoint_data_property(const Subject& s);
  void annotation_domain(const Subject& s);
  void annotation_range(const Subject& s);
  void sub_annotation_property(const Subject& s);
  void datatype(const Subject& s);
  void types(const Subject& s);
  void facts(const Subject& s);
  void same(const Subject& s);
  void different(const Subject& s);

  void equal_properties(bool equivalent, std::vector<Annotation> notes, std::size_t offset);
  Iri entity(EntityKind kind);
  /// `[Annotations: ...] item, [Annotations: ...] item`: each item becomes an axiom at its own place.
  template <class Item>
  void each(Item item) {
    do {
      std::vector<Annotation> notes = annotations();
      lexer_.peek();
      const std::size_t offset = lexer_.offset();
      AxiomContent content = item();
      emit(std::move(content), std::move(notes), offset);
    } while (lexer_.take(','));
  }
  void emit(AxiomContent content, std::vector<Annotation> notes, std::size_t offset);

  TextLexer& lexer_;
  Names& names_;
  Parsed& parsed_;
  ManchesterExpressions read_;
  [[nodiscard]] bool said_before(const AxiomContent& content);

  std::set<std::pair<EntityKind, Iri>> declared_;
  std::set<std::tuple<std::size_t, Iri, Iri>> pairs_;  ///< Of symmetric axioms: kind, lesser, greater.
};

}  // namespace heed::owl
