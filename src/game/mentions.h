#pragma once

#include <heed/logic/formula.h>
#include <heed/spec/symbols.h>

#include <set>
#include <string>

namespace heed::game {

/// The names in \p formula that stand for variables or definitions of the specification; a name that is the
/// value of the enumerated variable beside it is none. O(nodes).
[[nodiscard]] std::set<std::string> mentioned(const logic::Formula& formula, const spec::Symbols& symbols);

}  // namespace heed::game
