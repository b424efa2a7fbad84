#pragma once

#include <heed/model/mealy.h>
#include <heed/model/symbolic.h>
#include <heed/spec/gr1.h>

#include <cstdint>
#include <optional>
#include <string>

namespace heed::reference {

/// The machine that \p controller is, state by state, every observation tried. Nothing when there are more
/// than \p most states, or where a column leaves its domain.
[[nodiscard]] std::optional<model::Mealy> listed(const model::SymbolicController& controller,
                                                 std::uint32_t most = 20'000);

/// \p controller with one thing changed, as \p seed says: an answer, a first answer, an update, a definition,
/// what it takes for a met goal, or what it answers. Only what it does, never what it claims.
[[nodiscard]] model::SymbolicController mutated(const model::SymbolicController& controller,
                                                std::uint64_t seed);

/// \p claim with one set changed.
[[nodiscard]] model::Claim mutated(const model::Claim& claim, std::uint64_t seed);

}  // namespace heed::reference
