#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace heed::bench {

/// A catalogue like real ones: entities in three levels of groups, features under functional roles (ten
/// shapes, ten ground colours, ten border colours, twenty texts, the rest symbols), three to five per leaf,
/// some shared by many; no two leaves are described alike.
struct SignCatalogue {
  std::size_t entities = 1000;  ///< Groups and the root included; from 20.
  std::size_t features = 200;   ///< From 60.
  std::uint64_t seed = 1;
};

/// OWL in functional style. The same bytes for the same values, everywhere.
[[nodiscard]] std::string write_catalogue(const SignCatalogue& wanted);

/// Writes `catalogue.ofn`, `car.fts` (five cells) and `scenario.toml` into \p folder, which is made when
/// missing: the values of each functional role are one input, and halting is stopping. Controllers:
/// `definition`, and `common` of a closed catalogue. \returns the path of the scenario. \throws
/// util::InputError  the folder cannot be written
std::string write_scenario(const SignCatalogue& wanted, const std::string& folder);

}  // namespace heed::bench
