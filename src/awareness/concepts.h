#pragma once

#include <heed/awareness/catalogue.h>

#include <vector>

namespace heed::awareness {

[[nodiscard]] owl::ClassExpression concept_of(const Feature& feature);
/// An individual that is read as a kind of things stands for itself: what it inherits along a role of its own
/// follows in no OWL reasoner.
[[nodiscard]] owl::ClassExpression concept_of(const Entity& entity);

/// What a reasoner is asked for an entry of the catalogue.
[[nodiscard]] std::vector<Inclusion> inclusions_below(const Catalogue& catalogue, std::size_t entity,
                                                      std::size_t ancestor);
[[nodiscard]] std::vector<Inclusion> inclusions_has(const Catalogue& catalogue, std::size_t entity,
                                                    std::size_t feature);
/// One for each role of actions: any of them will do.
[[nodiscard]] std::vector<Inclusion> inclusions_prescribes(const Catalogue& catalogue, std::size_t entity,
                                                           std::size_t behaviour);
[[nodiscard]] std::vector<Inclusion> inclusions_impossible(const Catalogue& catalogue, std::size_t entity);
[[nodiscard]] std::vector<Inclusion> inclusions_special(const Catalogue& catalogue, std::size_t behaviour,
                                                        std::size_t general);

}  // namespace heed::awareness
