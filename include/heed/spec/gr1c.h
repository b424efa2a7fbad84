#pragma once

#include <heed/spec/gr1.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <string>

namespace heed::spec {

/// Reads gr1c's `.spc` (docs/formats/gr1c.md): `ENV: x y [0,3];` and the parts ENVINIT, ENVTRANS, ENVGOAL,
/// SYSINIT, SYSTRANS, SYSGOAL. The initial conditions are those of gr1c's default mode. \throws
/// util::InputError  with the position, what was expected and the nearest known word
[[nodiscard]] Gr1 read_gr1c(const util::SourceText& source, const util::Limits& limits = {});

/// Writes \p spec for gr1c, with the same verdict: memories and definitions become outputs with defining
/// constraints, integers and enumerations become `[0,n]`. \throws util::InputError  code "not-expressible"
/// with the reason
[[nodiscard]] std::string write_gr1c(const Gr1& spec);

}  // namespace heed::spec
