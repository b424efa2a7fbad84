#pragma once

#include <heed/spec/gr1.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <string>

namespace heed::spec {

/// Reads slugs' input format (docs/formats/slugsin.md): Boolean variables, formulas in prefix notation, one
/// constraint a line. The parts of a block `$ n f0 ... f(n-1)` that `? i` recalls become shared subformulas,
/// so the result is never larger than the file. Constraints of `*_TRANS` speak of steps: one without a primed
/// name says nothing about a state that is never left, and becomes `φ & X true` (docs/formats/slugsin.md,
/// "Semantics"). A top-level conjunction of an init or trans line becomes several clauses. O(bytes).
/// \throws util::InputError  with the position and the nearest known word
[[nodiscard]] Gr1 read_slugsin(const util::SourceText& source, const util::Limits& limits = {});

/// Writes \p spec for slugs, with the same verdict: memories and definitions become outputs with defining
/// constraints, integers and enumerations are encoded in bits `x@0.low.high`, `x@1`, ... (least significant
/// first), shared subformulas become blocks. Deterministic.
/// \throws util::InputError  code "not-expressible": Moore timing, initial quantifiers other than
/// forall-exists
[[nodiscard]] std::string write_slugsin(const Gr1& spec);

}  // namespace heed::spec
