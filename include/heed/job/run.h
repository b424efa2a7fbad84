#pragma once

#include <heed/job/scenario.h>
#include <heed/report/result.h>
#include <heed/util/limits.h>
#include <heed/util/progress.h>

#include <cstdint>
#include <optional>
#include <string>

namespace heed::job {

struct RunOptions {
  std::string output;   ///< Folder for controllers, specifications and report; made when missing.
  std::string command;  ///< For the report: how to repeat it.
  std::optional<std::uint64_t> traces, seed;  ///< Instead of the scenario's.
  unsigned threads = 1;
  bool drive = false;  ///< Also in a simulator of traffic, into the report.
  util::Progress progress{};
};

/// The main job: knowledge, synthesis of each controller, verification, evaluation, report. Controllers are
/// written to disk and read back before they are evaluated. Everything is written into a folder beside the
/// output first and moved there at the end: a run that fails leaves nothing behind. Writes
/// `<name>.controller.json`, `<name>.gr1`, `report.html`, `report.json`. \throws util::InputError,
/// util::LimitExceeded
[[nodiscard]] report::RunResult run(const Scenario& scenario, const RunOptions& options,
                                    util::Budget& budget);

}  // namespace heed::job
