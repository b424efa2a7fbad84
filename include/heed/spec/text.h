#pragma once

#include <heed/spec/gr1.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <string>

namespace heed::spec {

/// Reads heed's own specification file `.gr1` (docs/formats/gr1.md). Requirements of its `[task]` section are
/// lowered to GR(1); the result is validated and its definitions are sorted. \throws util::InputError  with
/// the position, what was expected and the nearest known word.
[[nodiscard]] Gr1 read_gr1(const util::SourceText& source, const util::Limits& limits = {});

/// Writes what read_gr1() reads back: the same variables, roles, formulas, origins and axioms, hence
/// `write_gr1(read_gr1(write_gr1(s))) == write_gr1(s)`. The texts of clauses and locations are not kept.
[[nodiscard]] std::string write_gr1(const Gr1& spec);

}  // namespace heed::spec
