#pragma once

#include "saturation.h"

#include <heed/owl/axiom.h>

namespace heed::dl {

/// Whether the saturated theory entails an axiom, as far as the fragment goes; false where it cannot tell.
[[nodiscard]] bool is_entailed(const owl::AxiomContent& axiom, const Saturation& base, util::Budget& budget);

}  // namespace heed::dl
