#pragma once

#include <heed/util/limits.h>

#include <map>
#include <string>

namespace heed::owl {

/// The `<uri name=".." uri=".."/>` entries of an OASIS catalogue as Protégé writes it: ontology IRI to file
/// path, relative ones seen from the catalogue. Empty where there is no such file. \throws InputError  not
/// XML
[[nodiscard]] std::map<std::string, std::string> read_catalog(const std::string& path,
                                                              const util::Limits& limits);

}  // namespace heed::owl
