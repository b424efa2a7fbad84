#pragma once

#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <string>
#include <string_view>

namespace heed::util {

/// Reads a regular file ("-" is standard input) whole. \throws InputError  missing, unreadable, a folder, or
/// larger than `limits.input_bytes`, which is checked before reading.
[[nodiscard]] SourceText read_file(const std::string& path, const Limits& limits = {});

/// Writes to a temporary file beside \p path and renames it: a reader sees the old file or the new one, never
/// a part. \throws InputError  when the folder is missing or not writable.
void write_file(const std::string& path, std::string_view content);

/// `path` as seen from the folder of \p base_file, unless it is absolute.
[[nodiscard]] std::string resolve_path(const std::string& base_file, const std::string& path);

}  // namespace heed::util
