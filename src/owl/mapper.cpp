#include "mapper.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::owl {

namespace v = vocabulary;

util::Diagnostic warning_at(const util::SourceText& source, std::size_t offset, std::string code,
                            std::string message, std::string hint) {
  const util::InputError error(source, offset, std::move(code), std::move(message), std::move(hint));
  util::Diagnostic out = error.diagnostic();
  out.severity = util::Severity::Warning;
  return out;
}

namespace {

std::uint64_t pair_key(Term subject, Iri predicate) {
  return (static_cast<std::uint64_t>(subject.bits()) << 32) | predicate.id;
}

}  // namespace

Mapper::Mapper(Graph& graph, OntologyData& data, util::Diagnostics& diagnostics, const util::Limits& limits,
               std::size_t document)
    : graph_(graph), data_(data), diagnostics_(diagnostics), limits_(limits), document_(document) {}

void Mapper::run() {
  first_diagnostic_ = diagnostics_.size();
  add_annotated_statements();
  index();
  states_.assign(graph_.blank_count, State::New);
  classes_.resize(graph_.blank_count);
  header();
  for (std::uint32_t at = 0; at < graph_.triples.size(); ++at)
    if (!used_[at]) statement(at);
  report_rest();
}

/// `[a owl:Axiom; annotatedSource s; annotatedProperty p; annotatedTarget o]` stands for "s p o", written or
/// not.
void Mapper::add_annotated_statements() {
  struct Reified {
    Term parts[3];
    unsigned seen = 0;
    std::uint32_t offset = 0;
  };
  std::unordered_map<std::uint32_t, Reified> found;
  std::vector<Term> order;
  for (const Triple& t : graph_.triples) {
    const bool source = t.predicate == v::owl_annotated_source;
    const bool property = t.predicate == v::owl_annotated_property;
    if (!source && !property && t.predicate != v::owl_annotated_target) continue;
    auto& entry = found[t.subject.bits()];
    if (entry.seen == 0) order.push_back(t.subject);
    const unsigned which = source ? 0 : property ? 1 : 2;
    entry.parts[which] = t.object;
    entry.seen |= 1U << which;
    entry.offset = t.offset;
  }
  if (found.empty()) return;
  std::unordered_map<std::uint64_t, std::vector<Term>> objects;
  for (const Triple& t : graph_.triples) objects[pair_key(t.subject, t.predicate)].push_back(t.object);
  for (const Term node : order) {
    const Reified& entry = found[node.bits()];
    if (entry.seen != 7 || !entry.parts[1].is_iri() || entry.parts[0].is_literal()) continue;
    const std::uint64_t key = pair_key(entry.parts[0], entry.parts[1].as_iri());
    reifiers_[key].push_back(node);
    auto& stated = objects[key];
    if (std::any_of(stated.begin(), stated.end(), [&](Term t) { return same(t, entry.parts[2]); })) continue;
    graph_.add(entry.parts[0], entry.parts[1].as_iri(), entry.parts[2], entry.offset);
    stated.push_back(entry.parts[2]);
  }
}

void Mapper::index() {
  rows_.assign(graph_.blank_count + data_.iris.size() + 1, 0);
  for (const Triple& t : graph_.triples) ++rows_[row_of(t.subject) + 1];
  for (std::size_t row = 1; row < rows_.size(); ++row) rows_[row] += rows_[row - 1];
  order_.resize(graph_.triples.size());
  std::vector<std::uint32_t> next(rows_.begin(), rows_.end() - 1);
  for (std::uint32_t at = 0; at < graph_.triples.size(); ++at)
    order_[next[row_of(triple(at).subject)]++] = at;
  used_.assign(graph_.triples.size(), false);
}

Mapper::Span Mapper::statements_of(Term subject) const {
  const std::size_t row = row_of(subject);
  if (subject.is_literal() || row + 1 >= rows_.size()) return {nullptr, nullptr};
  return {order_.data() + rows_[row], order_.data() + rows_[row + 1]};
}

std::uint32_t Mapper::find(Term subject, Iri predicate) const {
  for (const std::uint32_t at : statements_of(subject))
    if (triple(at).predicate == predicate) return at;
  return none;
}

std::optional<Term> Mapper::take(Term subject, Iri predicate) {
  const std::uint32_t at = find(subject, predicate);
  if (at == none) return std::nullopt;
  used_[at] = true;
  return triple(at).object;
}

bool Mapper::same(Term a, Term b) const {
  return a == b ||
         (a.is_literal() && b.is_literal() && graph_.literals[a.number()] == graph_.literals[b.number()]);
}

void Mapper::header() {
  bool is_root = document_ == 0;
  for (std::uint32_t at = 0; at < graph_.triples.size(); ++at) {
    const Triple t = triple(at);
    if (t.predicate != v::rdf_type || !(t.object == v::owl_ontology) || used_[at]) continue;
    used_[at] = true;
    if (is_root && t.subject.is_iri()) data_.iri = data_.iris.text(t.subject.as_iri());
    for (const std::uint32_t inner : statements_of(t.subject))
      if (!used_[inner]) header_statement(inner, is_root);
    is_root = false;
  }
}

void Mapper::header_statement(std::uint32_t at, bool is_root) {
  const Triple t = triple(at);
  if (t.predicate == v::owl_imports && t.object.is_iri()) {
    data_.imports.push_back({std::string(data_.iris.text(t.object.as_iri())), graph_.source.at(t.offset)});
  } else if (t.predicate == v::owl_version_iri && t.object.is_iri()) {
    if (is_root) data_.version_iri = data_.iris.text(t.object.as_iri());
  } else if (t.predicate.id >= v::size || is_annotation(t.predicate)) {
    use(EntityKind::AnnotationProperty, t.predicate);
    Annotation annotation{t.predicate, annotation_value(t.object),
                          reified(t.subject, t.predicate, t.object, 0)};
    if (is_root) data_.annotations.push_back(std::move(annotation));
  } else {
    return;
  }
  used_[at] = true;
}

bool Mapper::is_annotation(Iri property) const {
  return data_.kinds.has(EntityKind::AnnotationProperty, property) &&
         !data_.kinds.has(EntityKind::ObjectProperty, property) &&
         !data_.kinds.has(EntityKind::DataProperty, property);
}

AnnotationValue Mapper::annotation_value(Term term) {
  if (term.is_literal()) return graph_.literals[term.number()];
  if (term.is_iri()) return term.as_iri();
  return data_.iris.intern(fmt::format("_:d{}b{}", document_, term.number()));
}

std::vector<Annotation> Mapper::reified(Term subject, Iri predicate, Term object, unsigned depth) {
  std::vector<Annotation> out;
  const auto nodes = reifiers_.find(pair_key(subject, predicate));
  if (nodes == reifiers_.end()) return out;
  for (const Term node : nodes->second) {
    const std::uint32_t target = find(node, v::owl_annotated_target);
    if (target == none || !same(triple(target).object, object)) continue;
    for (const Iri part : {v::owl_annotated_source, v::owl_annotated_property, v::owl_annotated_target})
      take(node, part);
    take_type(node);
    auto more = annotations_of(node, depth + 1);
    std::move(more.begin(), more.end(), std::back_inserter(out));
  }
  return out;
}

std::vector<Annotation> Mapper::annotations_of(Term node, unsigned depth) {
  std::vector<Annotation> out;
  for (const std::uint32_t at : statements_of(node)) {
    const Triple t = triple(at);
    if (used_[at] || is_structural(t.predicate) || t.predicate == v::rdf_type) continue;
    if (depth > 32) {
      report(at, "nesting", "annotations of annotations nest more than 32 deep", "annotate the axiom itself");
      continue;
    }
    used_[at] = true;
    use(EntityKind::AnnotationProperty, t.predicate);
    out.push_back({t.predicate, annotation_value(t.object), reified(node, t.predicate, t.object, depth)});
  }
  return out;
}

void Mapper::emit(std::uint32_t at, AxiomContent content, std::vector<Annotation> annotations) {
  const Triple t = triple(at);
  used_[at] = true;
  auto more = reified(t.subject, t.predicate, t.object, 0);
  std::move(more.begin(), more.end(), std::back_inserter(annotations));
  const AxiomId id{static_cast<std::uint32_t>(data_.axioms.size() + 1)};
  data_.axioms.push_back({id, std::move(content), graph_.source.at(t.offset), std::move(annotations)});
}

/// Statements that only make sense inside a node which some axiom fetches.
bool Mapper::is_structural(Iri predicate) const {
  switch (predicate.id) {
    case v::rdf_first.id:
    case v::rdf_rest.id:
    case v::owl_members.id:
    case v::owl_distinct_members.id:
    case v::owl_source_individual.id:
    case v::owl_assertion_property.id:
    case v::owl_target_individual.id:
    case v::owl_target_value.id:
    case v::owl_annotated_source.id:
    case v::owl_annotated_property.id:
    case v::owl_annotated_target.id:
      return true;
    default:
      return predicate.id >= v::owl_intersection_of.id && predicate.id < v::size;
  }
}

void Mapper::statement(std::uint32_t at) {
  switch (triple(at).predicate.id) {
    case v::rdf_type.id:
      return typed(at);
    case v::rdfs_sub_class_of.id:
    case v::owl_disjoint_with.id:
      return class_axiom(at);
    case v::owl_equivalent_class.id:
      return equivalent_class(at);
    case v::owl_intersection_of.id:
    case v::owl_union_of.id:
    case v::owl_complement_of.id:
    case v::owl_one_of.id:
      return direct_definition(at);
    case v::owl_disjoint_union_of.id:
      return disjoint_union(at);
    case v::owl_has_key.id:
      return has_key(at);
    case v::rdfs_sub_property_of.id:
      return property_inclusion(at);
    case v::owl_property_chain_axiom.id:
      return property_chain(at, triple(at).object, triple(at).subject);
    case v::owl_equivalent_property.id:
    case v::owl_property_disjoint_with.id:
      return property_pair(at);
    case v::owl_inverse_of.id:
      return inverse_pair(at);
    case v::rdfs_domain.id:
    case v::rdfs_range.id:
      return domain_or_range(at);
    case v::owl_same_as.id:
    case v::owl_different_from.id:
      return individuals_pair(at);
    default:
      if (!is_structural(triple(at).predicate)) assertion(at);
  }
}

std::string Mapper::show(Term term) const {
  if (term.is_blank()) return fmt::format("_:b{}", term.number());
  if (term.is_literal()) return fmt::format("\"{}\"", graph_.literals[term.number()].value.substr(0, 60));
  const std::string_view text = data_.iris.text(term.as_iri());
  const std::size_t cut = text.find_last_of("#/");
  return std::string(cut == std::string_view::npos || cut + 1 == text.size() ? text : text.substr(cut + 1));
}

void Mapper::report(std::uint32_t at, const char* code, std::string message, std::string hint) {
  used_[at] = true;
  diagnostics_.push_back(
      warning_at(graph_.source, triple(at).offset, code, std::move(message), std::move(hint)));
}

void Mapper::report_rest() {
  for (std::uint32_t at = 0; at < graph_.triples.size(); ++at) {
    if (used_[at]) continue;
    const Triple& t = triple(at);
    if (t.predicate == v::rdf_type && t.object == v::rdf_list) continue;
    report(at, "not-understood",
           fmt::format("no axiom of OWL 2 has the statement '{} {} {}'", show(t.subject),
                       show(Term::iri(t.predicate)), show(t.object)),
           "it was left out");
  }
  std::stable_sort(diagnostics_.begin() + static_cast<std::ptrdiff_t>(first_diagnostic_), diagnostics_.end(),
                   [](const util::Diagnostic& a, const util::Diagnostic& b) {
                     return std::pair(a.location.line, a.location.column) <
                            std::pair(b.location.line, b.location.column);
                   });
}

}  // namespace heed::owl
