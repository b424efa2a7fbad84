#include "support.h"

namespace heed::owl::test {
namespace {

/// Each flawed file stands beside a file NAME.expected: first line "line:column code", second a part of the
/// message.
TEST(Regress, FlawedDocumentsGetTheirMessage) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(HEED_SOURCE_DIR) + "/tests/regress/owl/flawed")) {
    if (entry.path().extension() == ".expected") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const std::string expected = util::read_file(entry.path().string() + ".expected").text();
    const std::size_t end = expected.find('\n');
    util::Diagnostics diagnostics;
    try {
      (void)load(entry.path().string(), {}, {}, diagnostics);
    } catch (const util::InputError& error) {
      diagnostics.insert(diagnostics.begin(), error.diagnostic());
    }
    ASSERT_FALSE(diagnostics.empty());
    const util::Diagnostic& first = diagnostics.front();
    EXPECT_EQ(
        std::to_string(first.location.line) + ":" + std::to_string(first.location.column) + " " + first.code,
        expected.substr(0, end));
    const std::string part = expected.substr(end + 1, expected.find('\n', end + 1) - end - 1);
    EXPECT_NE(first.message.find(part), std::string::npos) << first.message;
    ++count;
  }
  EXPECT_GE(count, 15U);
}

}  // namespace
}  // namespace heed::owl::test
