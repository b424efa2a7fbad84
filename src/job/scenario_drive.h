#pragma once

#include "toml_table.h"

#include <heed/job/scenario.h>

namespace heed::job {

/// `[drive]` of \p root (docs/formats/drive.md); every key has a default, and so has the table.
/// \throws util::InputError
[[nodiscard]] DrivePart read_drive(TomlTable& root, const std::optional<EvaluatePart>& evaluate,
                                   const util::Limits& limits);

}  // namespace heed::job
