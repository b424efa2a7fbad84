#pragma once

#include "toml_table.h"

#include <heed/job/scenario.h>

namespace heed::job {

/// One `[[profile]]` (docs/formats/profile.md); sim::compile() checks what it means. \throws util::InputError
[[nodiscard]] ProfilePart read_profile(TomlTable& table, const util::Limits& limits);

}  // namespace heed::job
