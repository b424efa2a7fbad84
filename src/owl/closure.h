#pragma once

#include "graph.h"
#include "ontology_data.h"

#include <memory>
#include <vector>

namespace heed::owl {

/// The statements of one document, whatever its syntax.
[[nodiscard]] Graph read_graph(const util::SourceText& source, ReadContext context);

/// The axioms of \p graphs, the root first. What a name is, is decided over all of them, so that a document
/// may use what another one declares.
[[nodiscard]] Ontology map_graphs(std::vector<Graph>& graphs, std::shared_ptr<OntologyData> data,
                                  const util::Limits& limits, util::Diagnostics& diagnostics);

}  // namespace heed::owl
