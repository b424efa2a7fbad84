#pragma once

#include <string>
#include <string_view>

namespace heed::owl {

/// \p reference against \p base after RFC 3986, section 5.2. \p out is overwritten (a buffer to keep between
/// calls).
void resolve_iri(std::string_view base, std::string_view reference, std::string& out);

/// Whether it begins with a scheme.
[[nodiscard]] bool is_absolute_iri(std::string_view text);

/// The first character that no IRI may hold there (space, control, <>"{}|\^`; "_:" at the beginning names
/// what has no IRI), or npos.
[[nodiscard]] std::size_t first_bad_character(std::string_view iri);

/// Whether it is letters, then groups of letters and digits behind hyphens: what a language tag may be.
[[nodiscard]] bool is_language_tag(std::string_view text);

}  // namespace heed::owl
