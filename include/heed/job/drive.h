#pragma once

#include <heed/job/scenario.h>
#include <heed/report/drive.h>
#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>
#include <heed/util/progress.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace heed::job {

struct DriveOptions {
  std::string output;                              ///< Folder; empty: nothing is written.
  std::string command;                             ///< How to repeat it.
  std::vector<std::string> controllers, profiles;  ///< Names; empty: all.
  std::optional<std::string> thing;                ///< An entity, or "none"; none: the scenario's.
  std::optional<std::uint64_t> seed;
  std::optional<std::uint32_t> roads;
  std::string sumo;  ///< The module; empty: sim::load_sumo() looks for it.
  util::Progress progress{};
};

struct Driven {
  report::DriveResult result;
  util::Diagnostics warnings;  ///< Controllers that do not exist are left out.
};

/// Synthesizes and verifies the controllers of \p scenario and drives each down every road under every
/// profile, in a simulator of traffic (docs/formats/drive.md). What is seen on road i is trace i of the seed,
/// as heed simulate draws it. Writes `drive.csv`, `drive-summary.csv`, `drive.json`, `drive-speed.svg`,
/// `drive-braking.svg`, `drive-metres.svg`; a run that fails leaves nothing behind.
/// \throws util::InputError  also `no-sumo`; util::LimitExceeded
[[nodiscard]] Driven drive(const Scenario& scenario, const DriveOptions& options, util::Budget& budget);

}  // namespace heed::job
