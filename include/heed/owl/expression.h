#pragma once

#include <heed/owl/iri.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace heed::owl {

/// An object property or its inverse.
struct ObjectProperty {
  Iri iri;
  bool inverse = false;
  friend auto operator<=>(const ObjectProperty&, const ObjectProperty&) = default;
};

struct Literal {
  std::string value;     ///< Lexical form, entities and escapes resolved.
  Iri datatype;          ///< rdf:PlainLiteral, xsd:string, ... ; rdf:langString when there is a language.
  std::string language;  ///< BCP 47 tag in lower case; may be empty.
  friend auto operator<=>(const Literal&, const Literal&) = default;
};

/// One facet of a datatype restriction: xsd:minInclusive "5"^^xsd:integer.
struct Facet {
  Iri facet;
  Literal value;
  friend auto operator<=>(const Facet&, const Facet&) = default;
};

/// A data range of OWL 2, an immutable value. Copies share.
class DataRange {
 public:
  enum class Kind : std::uint8_t { Datatype, Intersection, Union, Complement, OneOf, Restriction };

  static DataRange datatype(Iri iri);
  static DataRange intersection(std::vector<DataRange> operands);
  static DataRange union_of(std::vector<DataRange> operands);
  static DataRange complement(DataRange operand);
  static DataRange one_of(std::vector<Literal> literals);
  static DataRange restriction(Iri datatype, std::vector<Facet> facets);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] Iri iri() const { return iri_; }  ///< Of Datatype and Restriction.
  [[nodiscard]] const std::vector<DataRange>& operands() const;
  [[nodiscard]] const std::vector<Literal>& literals() const;
  [[nodiscard]] const std::vector<Facet>& facets() const;

 private:
  struct Node;
  DataRange(Kind kind, Iri iri, std::shared_ptr<const Node> node);
  Kind kind_;
  Iri iri_;
  std::shared_ptr<const Node> node_;
};

/// A class expression of OWL 2, an immutable value. Copies share; a named class owns no memory. However deep,
/// neither copying nor destroying recurses.
class ClassExpression {
 public:
  enum class Kind : std::uint8_t {
    Class,         ///< iri()
    Intersection,  ///< operands()
    Union,         ///< operands()
    Complement,    ///< filler()
    OneOf,         ///< individuals()
    Some,          ///< property(), filler()
    Only,          ///< property(), filler()
    HasValue,      ///< property(), individuals()[0]
    HasSelf,       ///< property()
    Min,           ///< property(), cardinality(), filler(); owl:Thing where unqualified
    Max,
    Exactly,
    DataSome,  ///< data_properties() (one, or more for n-ary ranges), range()
    DataOnly,
    DataHasValue,  ///< data_properties()[0], literal()
    DataMin,       ///< data_properties()[0], cardinality(), range(); rdfs:Literal where unqualified
    DataMax,
    DataExactly
  };

  ClassExpression();  ///< owl:Thing
  static ClassExpression named(Iri iri);
  static ClassExpression thing();
  static ClassExpression nothing();
  /// No operand gives owl:Thing, one gives itself.
  static ClassExpression intersection(std::vector<ClassExpression> operands);
  /// No operand gives owl:Nothing, one gives itself.
  static ClassExpression union_of(std::vector<ClassExpression> operands);
  static ClassExpression complement(ClassExpression operand);
  static ClassExpression one_of(std::vector<Iri> individuals);
  static ClassExpression some(ObjectProperty property, ClassExpression filler);
  static ClassExpression only(ObjectProperty property, ClassExpression filler);
  static ClassExpression has_value(ObjectProperty property, Iri individual);
  static ClassExpression has_self(ObjectProperty property);
  /// \param kind  Min, Max or Exactly.
  static ClassExpression cardinality_of(Kind kind, std::uint32_t n, ObjectProperty property,
                                        ClassExpression filler);
  /// \param kind  DataSome or DataOnly.
  static ClassExpression data_quantified(Kind kind, std::vector<Iri> properties, DataRange range);
  static ClassExpression data_has_value(Iri property, Literal literal);
  /// \param kind  DataMin, DataMax or DataExactly.
  static ClassExpression data_cardinality(Kind kind, std::uint32_t n, Iri property, DataRange range);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] bool is_named() const { return kind_ == Kind::Class; }
  [[nodiscard]] bool is_thing() const;
  [[nodiscard]] bool is_nothing() const;
  [[nodiscard]] Iri iri() const { return iri_; }  ///< Of Class.
  [[nodiscard]] const std::vector<ClassExpression>& operands() const;
  [[nodiscard]] const ClassExpression& filler() const;  ///< \pre the kind has one
  [[nodiscard]] ObjectProperty property() const;
  [[nodiscard]] const std::vector<Iri>& individuals() const;
  [[nodiscard]] const std::vector<Iri>& data_properties() const;
  [[nodiscard]] const DataRange& range() const;  ///< \pre the kind has one
  [[nodiscard]] const Literal& literal() const;  ///< \pre DataHasValue
  [[nodiscard]] std::uint32_t cardinality() const;
  [[nodiscard]] std::uint32_t depth() const;  ///< 0 for a named class.
  /// Same address of the shared node or same class: a cheap sufficient test for equality.
  [[nodiscard]] bool identical(const ClassExpression& other) const;

 private:
  struct Node;
  ClassExpression(Kind kind, Iri iri, std::shared_ptr<const Node> node);
  static ClassExpression make(Kind kind, Node&& node);
  Kind kind_;
  Iri iri_;
  std::shared_ptr<const Node> node_;
};

}  // namespace heed::owl
