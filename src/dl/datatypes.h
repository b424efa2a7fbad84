#pragma once

#include <string>
#include <string_view>

namespace heed::dl {

/// The built-in datatype directly above the one with this IRI, of those whose values are all its values;
/// empty for one that has none and for names that are no built-in datatypes.
[[nodiscard]] std::string datatype_above(std::string_view iri);

/// Whether it is a built-in datatype without one above: no two of these have a value in common
/// (OWL 2 Structural Specification, section 4).
[[nodiscard]] bool is_primitive_datatype(std::string_view iri);

}  // namespace heed::dl
