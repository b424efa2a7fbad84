#include "parsed.h"

#include <heed/owl/vocabulary.h>

namespace heed::owl {

namespace v = vocabulary;

void append(Parsed& parsed, const util::SourceText& source, std::size_t number, OntologyData& data) {
  for (const auto& [iri, offset] : parsed.header.imports)
    data.imports.push_back({std::string(data.iris.text(iri)), source.at(offset)});
  if (number == 0) {
    if (parsed.has_iri) data.iri = data.iris.text(parsed.iri);
    if (parsed.has_version) data.version_iri = data.iris.text(parsed.version);
    data.annotations = std::move(parsed.annotations);
  }
  for (Draft& draft : parsed.drafts) {
    util::Location location = source.at(draft.offset);
    if (const auto* a = std::get_if<AnnotationAssertion>(&draft.content); a && a->property == v::rdfs_label)
      if (const auto* label = std::get_if<Literal>(&a->value))
        data.labels[a->subject.id].push_back({label->value, label->language, location});
    const AxiomId id{static_cast<std::uint32_t>(data.axioms.size() + 1)};
    data.axioms.push_back({id, std::move(draft.content), std::move(location), std::move(draft.annotations)});
  }
  parsed.drafts = {};
}

}  // namespace heed::owl
