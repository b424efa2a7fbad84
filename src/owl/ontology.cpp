#include "ontology_data.h"

#include "kinds.h"

#include <heed/owl/vocabulary.h>

#include <algorithm>
#include <cassert>

namespace heed::owl {

Ontology::Ontology() {
  auto data = std::make_shared<OntologyData>();
  add_builtin_kinds(data->kinds, data->iris);
  data_ = std::move(data);
}

Ontology::Ontology(std::shared_ptr<const OntologyData> data) : data_(std::move(data)) {}

const std::vector<Axiom>& Ontology::axioms() const {
  return data_->axioms;
}

const Axiom& Ontology::axiom(AxiomId id) const {
  assert(id.number >= 1 && id.number <= data_->axioms.size());
  return data_->axioms[id.number - 1];
}

std::string_view Ontology::text(Iri iri) const {
  return data_->iris.text(iri);
}
bool Ontology::is_anonymous(Iri iri) const {
  return text(iri).starts_with("_:");
}
std::optional<Iri> Ontology::find(std::string_view text) const {
  return data_->iris.find(text);
}
std::size_t Ontology::iri_count() const {
  return data_->iris.size();
}
bool Ontology::is(EntityKind kind, Iri iri) const {
  return data_->kinds.has(kind, iri);
}

std::vector<Iri> Ontology::entities(EntityKind kind) const {
  std::vector<Iri> out;
  for (std::uint32_t id = vocabulary::size; id < iri_count(); ++id)
    if (is(kind, Iri{id})) out.push_back(Iri{id});
  return out;
}

std::vector<Iri> Ontology::lookup(std::string_view name) const {
  std::string full;
  const std::size_t colon = name.find(':');
  if (colon != std::string_view::npos)
    for (const auto& [prefix, uri] : data_->prefixes)
      if (prefix == name.substr(0, colon)) full = uri + std::string(name.substr(colon + 1));
  std::vector<Iri> out;
  for (std::uint32_t id = 0; id < iri_count(); ++id) {
    const Iri iri{id};
    if (!data_->kinds.has_any(iri)) continue;
    const auto& known = labels(iri);
    if (text(iri) == name || local_name(iri) == name || (!full.empty() && text(iri) == full) ||
        std::any_of(known.begin(), known.end(), [&](const Label& label) { return label.text == name; }))
      out.push_back(iri);
  }
  return out;
}

const std::vector<Label>& Ontology::labels(Iri iri) const {
  static const std::vector<Label> nothing;
  const auto found = data_->labels.find(iri.id);
  return found == data_->labels.end() ? nothing : found->second;
}

std::string Ontology::name(Iri iri, std::string_view language) const {
  const auto& known = labels(iri);
  for (const Label& label : known)
    if (label.language == language) return label.text;
  for (const Label& label : known)
    if (label.language.empty()) return label.text;
  return known.empty() ? std::string(local_name(iri)) : known.front().text;
}

std::string_view Ontology::local_name(Iri iri) const {
  const std::string_view full = text(iri);
  const std::size_t cut = full.find_last_of("#/:");
  if (cut == std::string_view::npos || cut + 1 == full.size() || full.starts_with("_:")) return full;
  return full.substr(cut + 1);
}

std::string_view Ontology::iri() const {
  return data_->iri;
}
std::string_view Ontology::version_iri() const {
  return data_->version_iri;
}
const std::vector<Import>& Ontology::imports() const {
  return data_->imports;
}
const std::vector<Annotation>& Ontology::annotations() const {
  return data_->annotations;
}
const std::vector<std::pair<std::string, std::string>>& Ontology::prefixes() const {
  return data_->prefixes;
}

}  // namespace heed::owl
