#pragma once

#include <heed/spec/gr1.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <string>

namespace heed::spec {

/// Reads the input of slugs' structured compiler (docs/formats/structuredslugs.md): Boolean variables and
/// integers `b:0...10`, infix formulas with comparisons of sums, one constraint a line. \throws
/// util::InputError  with the position, what was expected and the nearest known word
[[nodiscard]] Gr1 read_structured_slugs(const util::SourceText& source, const util::Limits& limits = {});

/// Writes \p spec for slugs' structured compiler, with the same verdict: memories and definitions become
/// outputs with defining constraints, enumerations become integers. \throws util::InputError  code
/// "not-expressible" with the reason
[[nodiscard]] std::string write_structured_slugs(const Gr1& spec);

}  // namespace heed::spec
