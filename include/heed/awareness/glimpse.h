#pragma once

#include <heed/awareness/policy.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace heed::awareness {

/// How an entity comes to be recognised while its features come into view one after the other.
struct Approach {
  std::size_t entity;
  std::vector<Evidence> evidence;  ///< By which it is recognised or identified; see RecognisedEntity.
  bool evidence_complete = true;

  struct Confusion {
    std::size_t with;  ///< A candidate that is not one of its kind.
    /// Each of these features of the entity rules it out; empty: only several together do, or nothing.
    std::vector<std::size_t> until;
    bool ever = true;  ///< All its features together rule it out.
  };
  std::vector<Confusion> confusions{};  ///< The other leaves that not every single feature of it rules out.

  struct Glimpse {
    std::size_t feature;                  ///< Of the entity: seen, and nothing else.
    std::vector<std::size_t> candidates;  ///< What it may be.
    std::vector<std::size_t> common;      ///< What all of these prescribe.
  };
  std::vector<Glimpse> glimpses{};  ///< One per described feature that perception reports.
};

/// For every satisfiable entity, groups included: its evidence under the policy \p recognition (compiled with
/// PolicyOptions::Kind::Identifying), what it is confused with and what is certain meanwhile. \p closed  as
/// in PolicyOptions. Quadratic in the entities.
[[nodiscard]] std::vector<Approach> approaches(const Catalogue& catalogue, const Perception& perception,
                                               const Recognition& recognition, bool closed);

/// What a policy prescribes at a first step at which exactly these symbols are seen: behaviours, ascending.
[[nodiscard]] std::vector<std::size_t> prescribed_under(const Recognition& recognition,
                                                        const std::set<std::string>& seen);

}  // namespace heed::awareness
