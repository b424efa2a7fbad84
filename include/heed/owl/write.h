#pragma once

#include <heed/owl/ontology.h>

#include <string>

namespace heed::owl {

/// A whole document in functional-style syntax with full IRIs: all axioms in their order, one a line, and the
/// annotations of the ontology. It imports nothing, because an Ontology holds what its imports say. Reading
/// it gives the same axioms. O(length of the result).
[[nodiscard]] std::string write_functional(const Ontology& ontology);

/// The same as Turtle, with the prefixes of the ontology. Names that are used without a declaration get one;
/// axioms of more than two equivalent classes, equivalent properties or same individuals become pairs, as in
/// RDF.
[[nodiscard]] std::string write_turtle(const Ontology& ontology);

}  // namespace heed::owl
