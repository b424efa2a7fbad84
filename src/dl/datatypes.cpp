#include "datatypes.h"

#include <heed/owl/vocabulary.h>

#include <algorithm>
#include <array>
#include <utility>

namespace heed::dl {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 24> above = {{
    {HEED_XSD "byte", HEED_XSD "short"},
    {HEED_XSD "short", HEED_XSD "int"},
    {HEED_XSD "int", HEED_XSD "long"},
    {HEED_XSD "long", HEED_XSD "integer"},
    {HEED_XSD "unsignedByte", HEED_XSD "unsignedShort"},
    {HEED_XSD "unsignedShort", HEED_XSD "unsignedInt"},
    {HEED_XSD "unsignedInt", HEED_XSD "unsignedLong"},
    {HEED_XSD "unsignedLong", HEED_XSD "nonNegativeInteger"},
    {HEED_XSD "positiveInteger", HEED_XSD "nonNegativeInteger"},
    {HEED_XSD "nonNegativeInteger", HEED_XSD "integer"},
    {HEED_XSD "negativeInteger", HEED_XSD "nonPositiveInteger"},
    {HEED_XSD "nonPositiveInteger", HEED_XSD "integer"},
    {HEED_XSD "integer", HEED_XSD "decimal"},
    {HEED_XSD "decimal", HEED_OWL "rational"},
    {HEED_OWL "rational", HEED_OWL "real"},
    {HEED_XSD "dateTimeStamp", HEED_XSD "dateTime"},
    {HEED_XSD "language", HEED_XSD "token"},
    {HEED_XSD "NMTOKEN", HEED_XSD "token"},
    {HEED_XSD "NCName", HEED_XSD "Name"},
    {HEED_XSD "Name", HEED_XSD "token"},
    {HEED_XSD "token", HEED_XSD "normalizedString"},
    {HEED_XSD "normalizedString", HEED_XSD "string"},
    {HEED_XSD "string", HEED_RDF "PlainLiteral"},
    {HEED_RDF "langString", HEED_RDF "PlainLiteral"},
}};

constexpr std::array<std::string_view, 9> primitive = {
    HEED_OWL "real",      HEED_RDF "PlainLiteral", HEED_XSD "boolean",
    HEED_XSD "float",     HEED_XSD "double",       HEED_XSD "dateTime",
    HEED_XSD "hexBinary", HEED_XSD "base64Binary", HEED_XSD "anyURI"};

}  // namespace

std::string datatype_above(std::string_view iri) {
  for (const auto& [below, super] : above)
    if (below == iri) return std::string(super);
  return {};
}

bool is_primitive_datatype(std::string_view iri) {
  return std::find(primitive.begin(), primitive.end(), iri) != primitive.end();
}

}  // namespace heed::dl
