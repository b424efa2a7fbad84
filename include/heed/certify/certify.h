#pragma once

#include <heed/model/symbolic.h>
#include <heed/spec/gr1.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <string>

namespace heed::certify {

struct Verdict {
  bool certified = false;
  std::string fault;         ///< One sentence: what does not hold, and an example; empty when certified.
  std::uint64_t checks = 0;  ///< Implications that were looked at.
};

/// Decides whether \p claim proves its verdict about \p spec: in a manager of its own, with an encoding of
/// its own, sharing nothing with the solver (docs/semantics.md says what is looked at). A claim that is
/// refused proves nothing, in neither direction. Bits stand for the variables of the specification in its
/// order. Time: one controllable predecessor per rank. \throws util::InputError  variables that are not the
/// specification's; util::LimitExceeded
[[nodiscard]] Verdict certify(const model::Claim& claim, const spec::Gr1& spec, util::Budget& budget);

/// Decides whether \p controller keeps \p spec, by its own ranks: it begins in `winning`, stays there, breaks
/// no guarantee, answers every legal observation, and each goal comes nearer with each step, unless an
/// assumption fails. Its columns must be what the specification computes. \throws as above
[[nodiscard]] Verdict certify(const model::SymbolicController& controller, const spec::Gr1& spec,
                              util::Budget& budget);

}  // namespace heed::certify
