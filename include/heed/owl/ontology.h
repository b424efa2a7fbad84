#pragma once

#include <heed/owl/axiom.h>
#include <heed/owl/iri.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace heed::owl {

struct Label {
  std::string text;
  std::string language;  ///< May be empty.
  util::Location location;
};

struct Import {
  std::string iri;
  util::Location location;
};

struct OntologyData;

/// The axioms of one ontology document, or of an import closure. An immutable value; copies share.
class Ontology {
 public:
  Ontology();  ///< No axiom; knows the built-in names.
  explicit Ontology(std::shared_ptr<const OntologyData> data);

  /// In the order of their ids; includes declarations and annotations.
  [[nodiscard]] const std::vector<Axiom>& axioms() const;
  [[nodiscard]] const Axiom& axiom(AxiomId id) const;  ///< \pre 1 <= id.number <= axioms().size()

  [[nodiscard]] std::string_view text(Iri iri) const;  ///< In full; "_:b3" for an anonymous individual.
  [[nodiscard]] bool is_anonymous(Iri iri) const;
  [[nodiscard]] std::optional<Iri> find(std::string_view text) const;  ///< By full text.
  /// All entities, in the order of their ids, whose full text, local name, prefixed name or rdfs:label is \p
  /// name.
  [[nodiscard]] std::vector<Iri> lookup(std::string_view name) const;
  [[nodiscard]] std::size_t iri_count() const;  ///< Ids are 0 ... iri_count() - 1.

  /// Declared or used as such. The built-in ones are not listed by entities().
  [[nodiscard]] bool is(EntityKind kind, Iri iri) const;
  [[nodiscard]] std::vector<Iri> entities(EntityKind kind) const;  ///< In the order of their ids.

  [[nodiscard]] const std::vector<Label>& labels(Iri iri) const;
  /// For people: the label in \p language, else one without language, else the first one, else local_name().
  [[nodiscard]] std::string name(Iri iri, std::string_view language = "en") const;
  /// After the last '#', '/' or ':'; the whole text when nothing follows it.
  [[nodiscard]] std::string_view local_name(Iri iri) const;

  [[nodiscard]] std::string_view iri() const;  ///< Of the root document; empty when it has none.
  [[nodiscard]] std::string_view version_iri() const;
  [[nodiscard]] const std::vector<Import>& imports() const;  ///< Of all documents read, in order of reading.
  [[nodiscard]] const std::vector<Annotation>& annotations() const;  ///< Of the root document.
  /// Prefix (without colon) and namespace, in the order of the root document.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prefixes() const;

 private:
  std::shared_ptr<const OntologyData> data_;
};

}  // namespace heed::owl
