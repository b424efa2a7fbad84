#pragma once

#include <heed/dl/reasoner.h>

#include <vector>

namespace heed::dl {

/// \param classes       All named classes but owl:Thing and owl:Nothing, by id.
/// \param supers        Beside it: all named superclasses of each, itself included, by id; of unsatisfiable
/// ones nothing. \param unsatisfiable Beside it. \param thing         Classes that are equivalent to
/// owl:Thing, by id.
[[nodiscard]] Taxonomy build_taxonomy(const std::vector<owl::Iri>& classes,
                                      const std::vector<std::vector<owl::Iri>>& supers,
                                      const std::vector<bool>& unsatisfiable,
                                      const std::vector<owl::Iri>& thing, std::size_t iri_count);

}  // namespace heed::dl
