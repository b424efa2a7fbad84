#pragma once

#include <heed/util/diagnostic.h>

namespace heed::owl {

/// Whether a message of reading says that an axiom was left out: a rule, a statement that belongs to no
/// axiom, a broken list and the like (docs/formats/owl.md), not a doubtful name.
[[nodiscard]] bool leaves_out(const util::Diagnostic& message);

}  // namespace heed::owl
