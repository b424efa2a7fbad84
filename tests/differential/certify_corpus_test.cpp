// Specifications that nobody here wrote: every verdict certified, and every strategy of functions.
#include <heed/certify/certify.h>
#include <heed/spec/dialect.h>
#include <heed/strategy/synthesize.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace heed {
namespace {

namespace fs = std::filesystem;

fs::path corpus() {
  const char* given = std::getenv("HEED_CORPUS");
  return given != nullptr ? fs::path(given) : fs::path(HEED_SOURCE_DIR) / ".." / "shared" / "corpus";
}

std::vector<fs::path> files(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

/// Nothing for a file that is refused: formats of others, reachability games.
std::optional<spec::Gr1> read(const fs::path& path) {
  try {
    return spec::read_any(util::read_file(path.string()));
  } catch (const util::InputError&) {
    return std::nullopt;
  }
}

struct Counts {
  std::size_t realizable = 0, unrealizable = 0, strategies = 0;
  std::vector<std::string> late;
};

/// Certified within \p seconds altogether, or late.
void certify_one(const fs::path& path, double seconds, Counts& counts) {
  const std::optional<spec::Gr1> spec = read(path);
  if (!spec) return;
  util::Limits limits;
  limits.seconds = seconds;
  util::Budget budget(limits);
  strategy::Options options;
  options.form = strategy::Form::Symbolic;
  options.claim = true;
  options.only_realizability = true;
  try {
    const strategy::Result asked = strategy::synthesize(*spec, budget, options);
    const certify::Verdict verdict = certify::certify(*asked.claim, *spec, budget);
    EXPECT_TRUE(verdict.certified) << path << ": " << verdict.fault;
    ++(asked.realizable ? counts.realizable : counts.unrealizable);
    if (!asked.realizable) return;
    options.only_realizability = options.claim = false;
    const strategy::Result result = strategy::synthesize(*spec, budget, options);
    ASSERT_TRUE(result.symbolic) << path;
    const certify::Verdict strategy = certify::certify(*result.symbolic, *spec, budget);
    EXPECT_TRUE(strategy.certified) << path << ": " << strategy.fault;
    ++counts.strategies;
  } catch (const util::LimitExceeded&) {
    counts.late.push_back(path.filename().string());
  }
}

TEST(CertifyCorpus, VerdictsAndStrategiesAreCertified) {
  if (!fs::exists(corpus() / "slugs")) GTEST_SKIP() << "no corpus at " << corpus();
  Counts counts;
  for (const auto& [folder, extension] : {std::pair{"slugs", ".slugsin"}, {"gr1c", ".spc"}})
    for (const fs::path& path : files(corpus() / folder, extension)) certify_one(path, 2, counts);
  fmt::print("certified: {} realizable, {} unrealizable, {} strategies; late: {}\n", counts.realizable,
             counts.unrealizable, counts.strategies, fmt::join(counts.late, " "));
  EXPECT_GT(counts.realizable, 60U);
  EXPECT_GT(counts.unrealizable, 10U);
  EXPECT_GT(counts.strategies, 50U);
}

}  // namespace
}  // namespace heed
