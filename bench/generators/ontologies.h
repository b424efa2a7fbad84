#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace heed::bench {

/// A large terminology: class i stands below class i / 8; every third has an existential over one of twenty
/// properties; some are defined as a class with an existential; one property is transitive, one follows from
/// a chain.
struct Terminology {
  std::size_t classes = 100'000;     ///< From 8.
  std::size_t definitions = 10'000;  ///< At most `classes`.
  std::uint64_t seed = 1;
};

/// Signs that are defined by the values they have (hasValue and one-of), and individuals with role
/// assertions.
struct PopulatedSigns {
  std::size_t kinds = 50;
  std::size_t individuals = 60;
  std::size_t axioms = 700;  ///< Reached by role assertions.
  std::uint64_t seed = 1;
};

/// OWL in functional style. The same bytes for the same values, everywhere.
[[nodiscard]] std::string write_terminology(const Terminology& wanted);
[[nodiscard]] std::string write_populated(const PopulatedSigns& wanted);

/// The terminology as RDF/XML in the manner of editors: one element per class, entities in attribute values.
[[nodiscard]] std::string write_terminology_rdf(const Terminology& wanted);

}  // namespace heed::bench
