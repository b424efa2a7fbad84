#pragma once

#include <heed/owl/ontology.h>

#include <string>
#include <vector>

namespace heed::owl {

/// For people, in the style of the Manchester syntax, with labels: `Stop sign SubClassOf hasColour some Red`.
[[nodiscard]] std::string to_text(const Axiom& axiom, const Ontology& ontology);
[[nodiscard]] std::string to_text(const ClassExpression& expression, const Ontology& ontology);

/// Functional-style syntax with full IRIs: `SubClassOf(<...#StopSign> <...#Sign>)`.
[[nodiscard]] std::string to_functional(const Axiom& axiom, const Ontology& ontology);

/// A whole document that other OWL tools read: Ontology(...) around the axioms \p ids, one a line, each once
/// in the order given, with declarations of the entities they use.
[[nodiscard]] std::string to_functional(const std::vector<AxiomId>& ids, const Ontology& ontology);

}  // namespace heed::owl
