#pragma once

#include <heed/spec/gr1.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace heed::spec {

/// The languages in which a GR(1) specification can be read and written.
enum class Dialect : std::uint8_t { Gr1, Slugsin, StructuredSlugs, Gr1c };

[[nodiscard]] std::string_view to_string(Dialect dialect);  ///< "gr1", "slugsin", "structuredslugs", "gr1c"
[[nodiscard]] std::optional<Dialect> dialect_named(std::string_view word);

/// By the extension of the file's name (`.gr1`, `.slugsin`, `.structuredslugs`, `.spc`), else by its content:
/// sections in capitals are slugs' (structured where a line of theirs is not in prefix notation), a part such
/// as `SYSGOAL:` is gr1c's, anything else is heed's own. O(bytes).
[[nodiscard]] Dialect dialect_of(const util::SourceText& source);

/// Reads in the dialect of dialect_of(). \throws util::InputError
[[nodiscard]] Gr1 read_any(const util::SourceText& source, const util::Limits& limits = {});
/// \throws util::InputError  code "not-expressible": what \p dialect cannot say, with the reason
[[nodiscard]] std::string write_as(const Gr1& spec, Dialect dialect);

}  // namespace heed::spec
