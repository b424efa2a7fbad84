#pragma once

#include "toml_table.h"

#include <heed/job/scenario.h>

namespace heed::job {

/// One `[[profile]]` (docs/formats/profile.md); sim::compile() checks what it means. \throws util::InputError
[[nodiscard]] ProfilePart read_profile(TomlTable& table, const util::Limits& limits);

/// One `[[road]]` (docs/formats/scenario.md); which things there are is checked by evaluate_road(). \throws
/// util::InputError
[[nodiscard]] RoadPart read_road(TomlTable& table);

/// `[tune]`. \throws util::InputError
[[nodiscard]] TunePart read_tune(TomlTable table);

}  // namespace heed::job
