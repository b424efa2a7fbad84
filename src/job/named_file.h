#pragma once

#include <heed/job/scenario.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

namespace heed::job {

/// Reads a file that the scenario names; where it cannot be opened, the error points at that line of the
/// scenario. A \p file without a place was named on the command line.
template <class Read>
auto named_in_scenario(const Word& file, Read read) {
  try {
    return read();
  } catch (const util::InputError& error) {
    util::Diagnostic diagnostic = error.diagnostic();
    if (diagnostic.code != "unreadable" || file.location.line == 0 ||
        diagnostic.location.file_name() != file.text)
      throw;
    diagnostic.message = fmt::format("'{}': {}", file.text, diagnostic.message);
    diagnostic.location = file.location;
    throw util::InputError(std::move(diagnostic));
  }
}

}  // namespace heed::job
