#pragma once

#include <heed/spec/gr1.h>

#include <string>

namespace heed::spec {

[[nodiscard]] std::string to_string(Origin origin);                   ///< "task", "plant", ...
[[nodiscard]] std::string to_string(Timing timing);                   ///< "mealy", "moore"
[[nodiscard]] std::string to_string(InitialQuantifiers quantifiers);  ///< "forall-exists", ...
[[nodiscard]] std::string to_string(const model::Domain& domain);     ///< "boolean", "0..4", "{go, halt}"

/// A listing for people: every part with its clauses, each with where it comes from and the axioms behind it.
/// Ends in a newline; deterministic. Not meant to be read back: write_gr1() is.
[[nodiscard]] std::string listing(const Gr1& spec);

}  // namespace heed::spec
