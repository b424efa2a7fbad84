#pragma once

#include "graph.h"
#include "ontology_data.h"

namespace heed::owl {

/// What the built-in names are.
void add_builtin_kinds(KindTable& kinds, IriTable& iris);

/// What \p graph declares: `x rdf:type owl:Class` and the like.
void collect_declared(const Graph& graph, KindTable& kinds);

/// What the names of \p graph must be by the way they are used, where no declaration says it (imported
/// documents may be missing, and many authors forget). \returns whether anything was added: repeat over all
/// documents until nothing is.
bool infer_from_use(const Graph& graph, KindTable& kinds, const IriTable& iris);

[[nodiscard]] bool is_datatype(Iri iri, const KindTable& kinds, const IriTable& iris);

}  // namespace heed::owl
