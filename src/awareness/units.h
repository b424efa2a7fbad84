#pragma once

#include <heed/awareness/catalogue.h>

#include <cstddef>
#include <vector>

namespace heed::awareness {

/// Entities that a thing may turn out to be.
struct Units {
  /// \param closed  leaves only; otherwise every entity, groups being candidates when no member is possible
  Units(const Catalogue& catalogue, bool closed);

  std::vector<std::size_t> entities;               ///< Satisfiable; members before their groups.
  std::vector<std::vector<std::size_t>> children;  ///< Per entity of the catalogue: satisfiable, proper.
};

[[nodiscard]] bool equivalent(const Catalogue& catalogue, std::size_t a, std::size_t b);
/// Whether \p a is \p b or below it.
[[nodiscard]] bool within(const Catalogue& catalogue, std::size_t a, std::size_t b);

/// Entities ordered so that each comes after everything strictly below it.
[[nodiscard]] std::vector<std::size_t> bottom_up(const Catalogue& catalogue);

}  // namespace heed::awareness
