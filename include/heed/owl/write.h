#pragma once

#include <heed/owl/ontology.h>

#include <string>

namespace heed::owl {

/// A whole document in functional-style syntax with full IRIs: all axioms in their order, one a line, and the
/// annotations of the ontology. It imports nothing, because an Ontology holds what its imports say. Reading it
/// gives the same axioms. O(length of the result).
[[nodiscard]] std::string write_functional(const Ontology& ontology);

}  // namespace heed::owl
