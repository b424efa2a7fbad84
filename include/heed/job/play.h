#pragma once

#include <heed/job/scenario.h>
#include <heed/report/play.h>
#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>
#include <heed/util/progress.h>

#include <cstdint>
#include <optional>

namespace heed::job {

struct PlayOptions {
  std::optional<std::uint32_t> seed;  ///< Of the first draw, instead of the scenario's.
  util::Progress progress{};
};

/// The page's data, and what to tell whoever makes it: controllers that do not exist are left out, with a
/// warning.
struct PlayResult {
  report::Play play;
  util::Diagnostics warnings;
};

/// Most cells of a way that the page shows.
inline constexpr std::size_t play_cell_limit = 400;

/// Synthesizes and verifies every controller of \p scenario and gathers what the page needs of them, of the
/// catalogue and of the profiles. No profile or [evaluate] is needed. \throws util::InputError
/// "nondeterministic-plant", "too-many-cells", and whatever the files deserve; util::LimitExceeded
[[nodiscard]] PlayResult play(const Scenario& scenario, const PlayOptions& options, util::Budget& budget);

}  // namespace heed::job
