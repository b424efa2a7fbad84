#include "manchester_frames.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::owl {
namespace {

constexpr unsigned most_annotation_depth = 32;

}  // namespace

/// Frames state a symmetric axiom at both of its names: the second time it is the same axiom.
bool ManchesterFrames::said_before(const AxiomContent& content) {
  std::vector<Iri> names;
  const auto classes = [&](const std::vector<ClassExpression>& parts) {
    for (const ClassExpression& part : parts)
      if (part.is_named()) names.push_back(part.iri());
    if (names.size() != parts.size()) names.clear();
  };
  const auto properties = [&](const std::vector<ObjectProperty>& parts) {
    for (const ObjectProperty part : parts)
      if (!part.inverse) names.push_back(part.iri);
    if (names.size() != parts.size()) names.clear();
  };
  if (const auto* a = std::get_if<EquivalentClasses>(&content)) classes(a->classes);
  if (const auto* a = std::get_if<DisjointClasses>(&content)) classes(a->classes);
  if (const auto* a = std::get_if<EquivalentObjectProperties>(&content)) properties(a->properties);
  if (const auto* a = std::get_if<DisjointObjectProperties>(&content)) properties(a->properties);
  if (const auto* a = std::get_if<InverseObjectProperties>(&content)) properties({a->first, a->second});
  if (const auto* a = std::get_if<EquivalentDataProperties>(&content)) names = a->properties;
  if (const auto* a = std::get_if<DisjointDataProperties>(&content)) names = a->properties;
  if (const auto* a = std::get_if<SameIndividual>(&content)) names = a->individuals;
  if (const auto* a = std::get_if<DifferentIndividuals>(&content)) names = a->individuals;
  if (names.size() != 2) return false;
  const auto [low, high] = std::minmax(names[0], names[1]);
  return !pairs_.emplace(content.index(), low, high).second;
}

void ManchesterFrames::emit(AxiomContent content, std::vector<Annotation> notes, std::size_t offset) {
  if (notes.empty() && said_before(content)) return;
  parsed_.drafts.push_back({std::move(content), std::move(notes), static_cast<std::uint32_t>(offset)});
}

Iri ManchesterFrames::entity(EntityKind kind) {
  const Iri out = kind == EntityKind::NamedIndividual ? read_.any_name() : read_.name();
  names_.use(kind, out);
  return out;
}

std::vector<Annotation> ManchesterFrames::annotations() {
  return annotations(0);
}

std::vector<Annotation> ManchesterFrames::annotations(unsigned depth) {
  std::vector<Annotation> out;
  while (lexer_.next_word() == "Annotations:") {
    if (depth > most_annotation_depth)
      lexer_.fail(lexer_.offset(), "nesting",
                  fmt::format("annotations of annotations nest more than {} deep", most_annotation_depth),
                  "annotate the axiom itself");
    lexer_.word();
    do out.push_back(annotation(depth));
    while (lexer_.take(','));
  }
  return out;
}

Annotation ManchesterFrames::annotation(unsigned depth) {
  std::vector<Annotation> inner = annotations(depth + 1);
  const Iri property = entity(EntityKind::AnnotationProperty);
  if (read_.at_literal()) return {property, read_.literal(), std::move(inner)};
  return {property, read_.any_name(), std::move(inner)};
}

ManchesterFrames::Subject ManchesterFrames::subject_of(EntityKind kind) {
  Subject out;
  if (kind == EntityKind::Class) {
    out.expression = read_.class_expression();
    out.named = out.expression.is_named();
    out.iri = out.expression.iri();
  } else if (kind == EntityKind::ObjectProperty) {
    out.property = read_.property();
    out.named = !out.property.inverse;
    out.iri = out.property.iri;
  } else {
    out.iri = entity(kind);
  }
  out.named = out.named && !names_.iris().text(out.iri).starts_with("_:");
  return out;
}

ManchesterFrames::Section ManchesterFrames::section(EntityKind kind, std::string_view word) {
  struct Row {
    EntityKind kind;
    std::string_view word;
    Section section;
  };
  using M = ManchesterFrames;
  using K = EntityKind;
  static constexpr Row rows[] = {{K::Class, "SubClassOf:", &M::sub_class},
                                 {K::Class, "SuperClassOf:", &M::super_class},
                                 {K::Class, "EquivalentTo:", &M::equivalent_class},
                                 {K::Class, "DisjointWith:", &M::disjoint_class},
                                 {K::Class, "DisjointUnionOf:", &M::disjoint_union},
                                 {K::Class, "HasKey:", &M::has_key},
                                 {K::ObjectProperty, "Domain:", &M::domain},
                                 {K::ObjectProperty, "Range:", &M::range},
                                 {K::ObjectProperty, "Characteristics:", &M::characteristics},
                                 {K::ObjectProperty, "SubPropertyOf:", &M::sub_property},
                                 {K::ObjectProperty, "SuperPropertyOf:", &M::super_property},
                                 {K::ObjectProperty, "EquivalentTo:", &M::equivalent_property},
                                 {K::ObjectProperty, "DisjointWith:", &M::disjoint_property},
                                 {K::ObjectProperty, "InverseOf:", &M::inverse},
                                 {K::ObjectProperty, "Inverses:", &M::inverse},
                                 {K::ObjectProperty, "SubPropertyChain:", &M::chain},
                                 {K::DataProperty, "Domain:", &M::data_domain},
                                 {K::DataProperty, "Range:", &M::data_range},
                                 {K::DataProperty, "Characteristics:", &M::data_characteristics},
                                 {K::DataProperty, "SubPropertyOf:", &M::sub_data_property},
                                 {K::DataProperty, "EquivalentTo:", &M::equivalent_data_property},
                                 {K::DataProperty, "DisjointWith:", &M::disjoint_data_property},
                                 {K::AnnotationProperty, "Domain:", &M::annotation_domain},
                                 {K::AnnotationProperty, "Range:", &M::annotation_range},
                                 {K::AnnotationProperty, "SubPropertyOf:", &M::sub_annotation_property},
                                 {K::Datatype, "EquivalentTo:", &M::datatype},
                                 {K::NamedIndividual, "Types:", &M::types},
                                 {K::NamedIndividual, "Facts:", &M::facts},
                                 {K::NamedIndividual, "SameAs:", &M::same},
                                 {K::NamedIndividual, "DifferentFrom:", &M::different}};
  for (const Row& row : rows)
    if (row.kind == kind && row.word == word) return row.section;
  return nullptr;
}

void ManchesterFrames::frame(EntityKind kind) {
  const std::size_t offset = lexer_.offset();
  lexer_.word();
  const Subject subject = subject_of(kind);
  const bool is_new = subject.named && subject.iri.id >= vocabulary::size;
  if (is_new && declared_.emplace(kind, subject.iri).second) emit(Declaration{kind, subject.iri}, {}, offset);
  for (;;) {
    const std::string_view word = lexer_.next_word();
    const std::size_t place = lexer_.offset();
    if (word == "Annotations:") {
      about(subject);
      continue;
    }
    const Section handler = section(kind, word);
    if (handler == nullptr) {
      const bool ends = lexer_.at_end() || is_manchester_frame(word);
      if (ends) return;
      lexer_.fail(place, "unknown-word", fmt::format("{} does not go on here in this frame", lexer_.found()),
                  "a section begins with a word such as 'SubClassOf:', parts of a list are separated by ','");
    }
    lexer_.word();
    (this->*handler)(subject);
  }
}

/// "Annotations:" of the frame's subject itself.
void ManchesterFrames::about(const Subject& subject) {
  const std::size_t begin = lexer_.offset();
  if (!subject.named && !names_.iris().text(subject.iri).starts_with("_:"))
    lexer_.fail(begin, "syntax", "only a name can be annotated");
  lexer_.word();
  do {
    lexer_.peek();
    const std::size_t offset = lexer_.offset();
    Annotation a = annotation(0);
    emit(AnnotationAssertion{a.property, subject.iri, std::move(a.value)}, std::move(a.annotations), offset);
  } while (lexer_.take(','));
}

void ManchesterFrames::equal_properties(bool equivalent, std::vector<Annotation> notes, std::size_t offset) {
  std::vector<ObjectProperty> objects;
  std::vector<Iri> data;
  do {
    lexer_.peek();
    const std::size_t place = lexer_.offset();
    if (lexer_.next_word() != "inverse" && lexer_.ahead() != '(' && read_.is_data_property(read_.name())) {
      lexer_.go_back(place);
      data.push_back(entity(EntityKind::DataProperty));
    } else {
      lexer_.go_back(place);
      objects.push_back(read_.property());
    }
  } while (lexer_.take(','));
  if (!objects.empty() && !data.empty())
    lexer_.fail(offset, "wrong-argument", "object and data properties stand in one list");
  if (objects.size() + data.size() < 2) lexer_.fail(offset, "too-few", "the list needs two properties");
  if (data.empty() && equivalent)
    emit(EquivalentObjectProperties{std::move(objects)}, std::move(notes), offset);
  else if (data.empty())
    emit(DisjointObjectProperties{std::move(objects)}, std::move(notes), offset);
  else if (equivalent)
    emit(EquivalentDataProperties{std::move(data)}, std::move(notes), offset);
  else
    emit(DisjointDataProperties{std::move(data)}, std::move(notes), offset);
}

void ManchesterFrames::list_of_equals() {
  const std::size_t offset = lexer_.offset();
  const std::string_view word = lexer_.word();
  if (word == "Rule:") {
    names_.warn(offset, "swrl", "a rule is no axiom of OWL 2 and is left out",
                "write it as class axioms where that is possible");
    while (!lexer_.at_end() && !is_manchester_frame(lexer_.next_word())) lexer_.skip();
    return;
  }
  std::vector<Annotation> notes = annotations();
  if (word == "EquivalentProperties:" || word == "DisjointProperties:")
    return equal_properties(word == "EquivalentProperties:", std::move(notes), offset);
  if (word == "EquivalentClasses:" || word == "DisjointClasses:") {
    std::vector<ClassExpression> classes;
    do classes.push_back(read_.class_expression());
    while (lexer_.take(','));
    if (classes.size() < 2) lexer_.fail(offset, "too-few", "the list needs two classes");
    if (word == "EquivalentClasses:")
      return emit(EquivalentClasses{std::move(classes)}, std::move(notes), offset);
    return emit(DisjointClasses{std::move(classes)}, std::move(notes), offset);
  }
  std::vector<Iri> individuals;
  do individuals.push_back(read_.individual());
  while (lexer_.take(','));
  if (individuals.size() < 2) lexer_.fail(offset, "too-few", "the list needs two individuals");
  if (word == "SameIndividual:")
    return emit(SameIndividual{std::move(individuals)}, std::move(notes), offset);
  emit(DifferentIndividuals{std::move(individuals)}, std::move(notes), offset);
}

void ManchesterFrames::sub_class(const Subject& s) {
  each([&]() -> AxiomContent { return SubClassOf{s.expression, read_.class_expression()}; });
}
void ManchesterFrames::super_class(const Subject& s) {
  each([&]() -> AxiomContent { return SubClassOf{read_.class_expression(), s.expression}; });
}
void ManchesterFrames::equivalent_class(const Subject& s) {
  each([&]() -> AxiomContent { return EquivalentClasses{{s.expression, read_.class_expression()}}; });
}
void ManchesterFrames::disjoint_class(const Subject& s) {
  each([&]() -> AxiomContent { return DisjointClasses{{s.expression, read_.class_expression()}}; });
}

void ManchesterFrames::disjoint_union(const Subject& s) {
  std::vector<Annotation> notes = annotations();
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  if (!s.named) lexer_.fail(offset, "wrong-argument", "only a named class is a disjoint union");
  DisjointUnion out{s.iri, {}};
  do out.parts.push_back(read_.class_expression());
  while (lexer_.take(','));
  emit(std::move(out), std::move(notes), offset);
}

/// The properties stand one behind the other, without commas.
void ManchesterFrames::has_key(const Subject& s) {
  std::vector<Annotation> notes = annotations();
  lexer_.peek();
  const std::size_t offset = lexer_.offset();
  HasKey out{s.expression, {}, {}};
  do {
    lexer_.take(',');
    lexer_.peek();
    const std::size_t place = lexer_.offset();
    const bool is_name = lexer_.next_word() != "inverse" && lexer_.ahead() != '(';
    const Iri name = is_name ? read_.name() : Iri{};
    lexer_.go_back(place);
    if (is_name && read_.is_data_property(name))
      out.data_properties.push_back(entity(EntityKind::DataProperty));
    else
      out.object_properties.push_back(read_.property());
  } while (lexer_.peek() == '<' || lexer_.peek() == '(' || lexer_.peek() == ',' ||
           (!lexer_.next_word().empty() && !is_manchester_keyword(lexer_.next_word())));
  emit(std::move(out), std::move(notes), offset);
}

void ManchesterFrames::datatype(const Subject& s) {
  each([&]() -> AxiomContent { return DatatypeDefinition{s.iri, read_.data_range()}; });
}
void ManchesterFrames::types(const Subject& s) {
  each([&]() -> AxiomContent { return ClassAssertion{read_.class_expression(), s.iri}; });
}

void ManchesterFrames::facts(const Subject& s) {
  each([&]() -> AxiomContent {
    const bool negative = read_.take_word("not");
    const ObjectProperty property = [&] {
      if (lexer_.next_word() == "inverse" || lexer_.peek() == '(') return read_.property();
      return ObjectProperty{read_.name(), false};
    }();
    if (read_.at_literal() && !property.inverse) {
      names_.use(EntityKind::DataProperty, property.iri);
      return DataPropertyAssertion{property.iri, s.iri, read_.literal(), negative};
    }
    names_.use(EntityKind::ObjectProperty, property.iri);
    return ObjectPropertyAssertion{property, s.iri, read_.individual(), negative};
  });
}

void ManchesterFrames::same(const Subject& s) {
  each([&]() -> AxiomContent { return SameIndividual{{s.iri, read_.individual()}}; });
}
void ManchesterFrames::different(const Subject& s) {
  each([&]() -> AxiomContent { return DifferentIndividuals{{s.iri, read_.individual()}}; });
}

}  // namespace heed::owl
