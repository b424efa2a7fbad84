#pragma once

#include "graph.h"
#include "ontology_data.h"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace heed::owl {

/// One graph into axioms, after "OWL 2 Mapping to RDF Graphs", section 3. A statement that leads an axiom
/// (rdfs:subClassOf, owl:disjointWith, ...) is met in document order and fetches the nodes it needs; each
/// statement used is marked. What is left unmarked at the end was not understood and is reported.
class Mapper {
 public:
  /// \param document  Number of the graph in its closure; keeps anonymous individuals apart.
  Mapper(Graph& graph, OntologyData& data, util::Diagnostics& diagnostics, const util::Limits& limits,
         std::size_t document);
  void run();

 private:
  enum class State : std::uint8_t { New, Open, Done, Bad };
  static constexpr std::uint32_t none = UINT32_MAX;

  // mapper.cpp: statements and annotations
  void add_annotated_statements();
  void index();
  void header();
  void header_statement(std::uint32_t at, bool is_root);
  void statement(std::uint32_t at);
  void report_rest();
  void report(std::uint32_t at, const char* code, std::string message, std::string hint = {});
  void emit(std::uint32_t at, AxiomContent content, std::vector<Annotation> annotations = {});
  std::vector<Annotation> annotations_of(Term node, unsigned depth = 0);
  std::vector<Annotation> reified(Term subject, Iri predicate, Term object, unsigned depth);
  [[nodiscard]] bool same(Term a, Term b) const;
  [[nodiscard]] bool is_annotation(Iri property) const;
  [[nodiscard]] bool is_structural(Iri predicate) const;
  [[nodiscard]] AnnotationValue annotation_value(Term term);
  [[nodiscard]] std::string show(Term term) const;

  // mapper_axioms.cpp: one function per family of axioms
  void typed(std::uint32_t at);
  void declaration(std::uint32_t at, EntityKind kind);
  bool characteristic(std::uint32_t at);
  void class_assertion(std::uint32_t at);
  void class_axiom(std::uint32_t at);
  void equivalent_class(std::uint32_t at);
  void direct_definition(std::uint32_t at);
  void disjoint_union(std::uint32_t at);
  void has_key(std::uint32_t at);
  void property_inclusion(std::uint32_t at);
  void property_chain(std::uint32_t at, Term head, Term super);
  void property_pair(std::uint32_t at);
  void inverse_pair(std::uint32_t at);
  void domain_or_range(std::uint32_t at);
  void individuals_pair(std::uint32_t at);
  void assertion(std::uint32_t at);
  void annotation_assertion(std::uint32_t at);
  void all_disjoint(std::uint32_t at);
  void negative_assertion(std::uint32_t at);

  // mapper_expressions.cpp: nodes
  std::optional<ClassExpression> class_of(Term root, std::uint32_t at);
  std::optional<std::vector<ClassExpression>> classes_of(Term list, std::uint32_t at);
  void visit(Term node, std::uint32_t at, std::vector<Term>& pending);
  std::vector<Term> class_parts(Term node);
  std::optional<ClassExpression> build_class(Term node, std::uint32_t at);
  std::optional<ClassExpression> build_connective(Term node, std::uint32_t connective, std::uint32_t at);
  std::optional<ClassExpression> build_restriction(Term node, std::uint32_t at);
  std::optional<ClassExpression> object_restriction(Term node, ObjectProperty property, std::uint32_t what);
  std::optional<ClassExpression> data_restriction(Term node, std::vector<Iri> properties, std::uint32_t what);
  std::optional<ClassExpression> known_class(Term node);
  std::optional<std::uint32_t> number_of(Term term, std::uint32_t at);
  std::optional<DataRange> range_of(Term node, std::uint32_t at, unsigned depth = 0);
  std::optional<DataRange> facets_of(Term node, std::uint32_t at);
  std::optional<ObjectProperty> property_of(Term node, std::uint32_t at);
  std::optional<std::vector<Term>> list_of(Term head, std::uint32_t at);
  std::optional<Iri> individual_of(Term node, std::uint32_t at);
  [[nodiscard]] bool is_data_range(Term node);
  [[nodiscard]] bool is_data_property(Term node) const;

  /// First statement of \p subject with \p predicate, or none.
  [[nodiscard]] std::uint32_t find(Term subject, Iri predicate) const;
  /// The object of it, marked as used.
  std::optional<Term> take(Term subject, Iri predicate);
  void take_type(Term node);
  struct Span {
    const std::uint32_t *first, *last;
    [[nodiscard]] const std::uint32_t* begin() const { return first; }
    [[nodiscard]] const std::uint32_t* end() const { return last; }
  };
  [[nodiscard]] Span statements_of(Term subject) const;
  [[nodiscard]] const Triple& triple(std::uint32_t at) const { return graph_.triples[at]; }
  [[nodiscard]] std::size_t row_of(Term subject) const {
    return subject.is_blank() ? subject.number() : graph_.blank_count + subject.number();
  }
  void use(EntityKind kind, Iri iri) { data_.kinds.add(kind, iri); }
  /// Has kind \p kind and no other kind of property that would go first.
  [[nodiscard]] bool is(EntityKind kind, Term term) const {
    return term.is_iri() && data_.kinds.has(kind, term.as_iri());
  }

  Graph& graph_;
  OntologyData& data_;
  util::Diagnostics& diagnostics_;
  const util::Limits& limits_;
  std::size_t document_;
  std::vector<std::uint32_t> rows_, order_;  ///< Statements by subject: order_[rows_[r] ... rows_[r + 1]].
  std::vector<bool> used_;
  std::vector<State> states_;                                      ///< By blank node.
  std::vector<ClassExpression> classes_;                           ///< By blank node, where Done.
  std::unordered_map<std::uint64_t, std::vector<Term>> reifiers_;  ///< By subject and predicate.
  std::vector<bool> undeclared_;                                   ///< By Iri: reported once.
  std::size_t first_diagnostic_ = 0;
};

}  // namespace heed::owl
