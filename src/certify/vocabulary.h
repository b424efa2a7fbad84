#pragma once

#include <heed/model/symbolic.h>
#include <heed/spec/gr1.h>

namespace heed::certify {

/// The variables are those of the specification, in its order. \throws util::InputError
void check_vocabulary(const model::Claim& claim, const spec::Gr1& spec);
/// The columns are those of the specification, in its order. \throws util::InputError
void check_vocabulary(const model::SymbolicController& controller, const spec::Gr1& spec);

}  // namespace heed::certify
