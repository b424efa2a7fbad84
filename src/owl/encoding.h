#pragma once

#include <heed/util/source.h>

namespace heed::owl {

/// \p source in UTF-8. UTF-16 with a byte order mark is converted, and XML that declares UTF-16, ISO-8859-1
/// or US-ASCII; places are those of the converted text. \throws InputError  another encoding (`encoding`), or
/// bytes that are none of it (`bad-encoding`)
[[nodiscard]] util::SourceText in_utf8(const util::SourceText& source);

}  // namespace heed::owl
