#include <heed/owl/left_out.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace heed::owl {

bool leaves_out(const util::Diagnostic& message) {
  constexpr std::array<std::string_view, 17> codes = {
      "not-understood",  "swrl",           "broken-list",
      "cyclic-class",    "bad-class",      "bad-restriction",
      "bad-cardinality", "bad-data-range", "bad-property",
      "bad-value",       "bad-chain",      "bad-negative-assertion",
      "no-members",      "literal-class",  "literal-individual",
      "nesting",         "too-few"};
  return message.severity == util::Severity::Warning &&
         std::find(codes.begin(), codes.end(), message.code) != codes.end();
}

}  // namespace heed::owl
