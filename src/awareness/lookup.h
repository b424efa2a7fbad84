#pragma once

#include <heed/awareness/catalogue.h>

#include <vector>

namespace heed::awareness {

/// The entity of \p ontology that \p name means, of one of \p kinds; an exact local name goes before labels.
/// \throws util::InputError  with \p code when there is none (nearest name), "ambiguous-name" when there are
/// several.
[[nodiscard]] owl::Iri find_in_ontology(const owl::Ontology& ontology, const Name& name,
                                        const std::vector<owl::EntityKind>& kinds, const std::string& code);

/// A thing of the catalogue under the words that a user may call it by.
struct Callable {
  std::size_t index;
  std::vector<std::string> words;  ///< The best first: a match of an earlier word goes before one of a later.
};

/// \throws util::InputError  as find_in_ontology(); \p noun is "entity", "feature", ...
[[nodiscard]] std::size_t find_callable(const std::vector<Callable>& things, const Name& name,
                                        const std::string& noun);

}  // namespace heed::awareness
