#include "manchester_frames.h"

#include <fmt/format.h>

#include <array>

// The sections of property frames.

namespace heed::owl {

void ManchesterFrames::domain(const Subject& s) {
  each([&]() -> AxiomContent { return ObjectPropertyDomain{s.property, read_.class_expression()}; });
}
void ManchesterFrames::range(const Subject& s) {
  each([&]() -> AxiomContent { return ObjectPropertyRange{s.property, read_.class_expression()}; });
}
void ManchesterFrames::sub_property(const Subject& s) {
  each([&]() -> AxiomContent { return SubObjectPropertyOf{{s.property}, read_.property()}; });
}
void ManchesterFrames::super_property(const Subject& s) {
  each([&]() -> AxiomContent { return SubObjectPropertyOf{{read_.property()}, s.property}; });
}
void ManchesterFrames::equivalent_property(const Subject& s) {
  each([&]() -> AxiomContent { return EquivalentObjectProperties{{s.property, read_.property()}}; });
}
void ManchesterFrames::disjoint_property(const Subject& s) {
  each([&]() -> AxiomContent { return DisjointObjectProperties{{s.property, read_.property()}}; });
}
void ManchesterFrames::inverse(const Subject& s) {
  each([&]() -> AxiomContent { return InverseObjectProperties{s.property, read_.property()}; });
}

void ManchesterFrames::chain(const Subject& s) {
  each([&]() -> AxiomContent {
    std::vector<ObjectProperty> parts;
    do parts.push_back(read_.property());
    while (read_.take_word("o"));
    return SubObjectPropertyOf{std::move(parts), s.property};
  });
}

void ManchesterFrames::characteristics(const Subject& s) {
  static constexpr std::array<std::string_view, 7> words = {
      "Functional", "InverseFunctional", "Reflexive", "Irreflexive", "Symmetric", "Asymmetric", "Transitive"};
  each([&]() -> AxiomContent {
    const std::size_t offset = lexer_.offset();
    const std::string_view word = lexer_.word();
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == word) return ObjectPropertyCharacteristic{static_cast<Characteristic>(i), s.property};
    lexer_.fail(offset, "unknown-word", fmt::format("'{}' is no characteristic of an object property", word),
                util::suggestion(word, {words.begin(), words.end()}));
  });
}

void ManchesterFrames::data_characteristics(const Subject& s) {
  each([&]() -> AxiomContent {
    const std::size_t offset = lexer_.offset();
    const std::string_view word = lexer_.word();
    if (word == "Functional") return FunctionalDataProperty{s.iri};
    lexer_.fail(offset, "unknown-word", fmt::format("'{}' is no characteristic of a data property", word),
                "a data property can only be Functional");
  });
}

void ManchesterFrames::data_domain(const Subject& s) {
  each([&]() -> AxiomContent { return DataPropertyDomain{s.iri, read_.class_expression()}; });
}
void ManchesterFrames::data_range(const Subject& s) {
  each([&]() -> AxiomContent { return DataPropertyRange{s.iri, read_.data_range()}; });
}
void ManchesterFrames::sub_data_property(const Subject& s) {
  each([&]() -> AxiomContent { return SubDataPropertyOf{s.iri, entity(EntityKind::DataProperty)}; });
}
void ManchesterFrames::equivalent_data_property(const Subject& s) {
  each([&]() -> AxiomContent { return EquivalentDataProperties{{s.iri, entity(EntityKind::DataProperty)}}; });
}
void ManchesterFrames::disjoint_data_property(const Subject& s) {
  each([&]() -> AxiomContent { return DisjointDataProperties{{s.iri, entity(EntityKind::DataProperty)}}; });
}

void ManchesterFrames::annotation_domain(const Subject& s) {
  each([&]() -> AxiomContent { return AnnotationPropertyDomain{s.iri, read_.name()}; });
}
void ManchesterFrames::annotation_range(const Subject& s) {
  each([&]() -> AxiomContent { return AnnotationPropertyRange{s.iri, read_.name()}; });
}
void ManchesterFrames::sub_annotation_property(const Subject& s) {
  each([&]() -> AxiomContent {
    return SubAnnotationPropertyOf{s.iri, entity(EntityKind::AnnotationProperty)};
  });
}

}  // namespace heed::owl
