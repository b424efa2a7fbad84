#pragma once

#include <heed/owl/axiom.h>

#include <vector>

namespace heed::owl {

/// The names that an axiom is about, built-in ones and those of its annotations left out; by id, each once.
[[nodiscard]] std::vector<Iri> signature(const AxiomContent& axiom);
[[nodiscard]] std::vector<Iri> signature(const ClassExpression& expression);

}  // namespace heed::owl
