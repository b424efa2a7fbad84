#pragma once

#include <heed/logic/nodes.h>

namespace heed::spec {

using logic::Nodes;

[[nodiscard]] inline bool is_comparison(logic::Op op) {
  return op >= logic::Op::Eq && op <= logic::Op::Ge;
}

/// Always, Eventually, ... and the past: what a clause of GR(1) cannot hold.
[[nodiscard]] inline bool is_temporal_beyond_next(logic::Op op) {
  return op > logic::Op::Next;
}

}  // namespace heed::spec
