#include "dialects/verdict.h"

#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace heed::dialects {
namespace {

namespace fs = std::filesystem;

/// Files that are read but not solved here, each with its reason.
const std::set<std::string> not_solved{
    "ex_basicEvasion.slugsin",       // no tool's verdict is known
    "basicEvasion.structuredslugs",  // the same
};
/// Files in formats that are none of ours: sections OUTPUT_S and OUTPUT_F, or OUTPUT_B.
const std::set<std::string> foreign{"ex_fastslow_IROS.slugsin", "ex_interleave.slugsin"};

fs::path corpus() {
  const char* given = std::getenv("HEED_CORPUS");
  return given != nullptr ? fs::path(given) : fs::path(HEED_SOURCE_DIR) / ".." / "shared" / "corpus";
}

std::vector<fs::path> files(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> out;
  if (!fs::exists(folder)) return out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == extension && entry.path().parent_path().filename() != "flawed")
      out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

/// The verdict of each file that the folder's manifest lists.
std::map<std::string, std::string> manifest(const fs::path& folder) {
  std::map<std::string, std::string> out;
  std::istringstream lines(util::read_file((folder / "MANIFEST.csv").string()).text());
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() > 6) out[cells[0]] = cells[6];
  }
  return out;
}

spec::Gr1 read(const fs::path& path) {
  return spec::read_any(util::read_file(path.string()));
}

/// What ran and what did not, by name; a file that is skipped without a reason fails.
class Account {
 public:
  void ran() { ++ran_; }
  void skip(const std::string& name) {
    skipped_.push_back(name);
    EXPECT_TRUE(not_solved.contains(name)) << name << " was skipped without being on the list of exceptions";
  }
  ~Account() {
    fmt::print("{} files ran, {} skipped", ran_, skipped_.size());
    for (const auto& name : skipped_) fmt::print(" {}", name);
    fmt::print("\n");
  }
  Account() = default;
  Account(const Account&) = delete;
  Account& operator=(const Account&) = delete;

 private:
  std::size_t ran_ = 0;
  std::vector<std::string> skipped_;
};

void expect_refusal(const fs::path& path) {
  try {
    (void)read(path);
    ADD_FAILURE() << path << " is refused by the tool whose format it claims";
  } catch (const util::InputError& error) {
    EXPECT_GT(error.diagnostic().location.line, 0U) << path;
    EXPECT_GT(error.diagnostic().location.column, 0U) << path;
  }
}

void solve_all(const fs::path& folder, const std::string& extension, const std::string& prefix,
               const std::string& manifest_extension) {
  const auto expected = manifest(folder);
  Account account;
  for (const fs::path& path : files(folder, extension)) {
    const std::string name = path.filename().string();
    const auto entry = expected.find(prefix + path.stem().string() + manifest_extension);
    ASSERT_NE(entry, expected.end()) << name;
    if (entry->second == "SYNTAX" || foreign.contains(name)) {
      expect_refusal(path);
      account.ran();
      continue;
    }
    const spec::Gr1 spec = read(path);
    if (not_solved.contains(name)) {
      account.skip(name);
      continue;
    }
    EXPECT_EQ(verdict(spec, 20), entry->second) << name;
    account.ran();
  }
}

class DialectCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(corpus() / "slugs")) GTEST_SKIP() << "no corpus at " << corpus();
  }
};

TEST_F(DialectCorpus, slugsin_files_have_their_verdicts) {
  solve_all(corpus() / "slugs", ".slugsin", "", ".slugsin");
}

TEST_F(DialectCorpus, structuredslugs_files_have_the_verdicts_of_their_translations) {
  solve_all(corpus() / "slugs", ".structuredslugs", "ex_", ".slugsin");
}

TEST_F(DialectCorpus, gr1c_files_have_their_verdicts_and_reachability_games_are_refused) {
  solve_all(corpus() / "gr1c", ".spc", "", ".spc");
}

TEST_F(DialectCorpus, flawed_gr1c_files_are_refused_with_a_position) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(corpus() / "gr1c" / "flawed")) {
    expect_refusal(entry.path());
    ++count;
  }
  fmt::print("{} files ran, 0 skipped\n", count);
  EXPECT_GT(count, 0U);
}

TEST_F(DialectCorpus, spectra_translations_all_read) {
  const auto all = files(corpus() / "spectra" / "slugsin", ".slugsin");
  for (const fs::path& path : all) EXPECT_NO_THROW((void)read(path)) << path;
  fmt::print("{} files ran, 0 skipped\n", all.size());
  EXPECT_FALSE(all.empty());
}

/// Small files: those of at most 1,600 bytes, in every dialect and back.
TEST_F(DialectCorpus, small_files_keep_their_verdict_in_every_dialect) {
  std::size_t count = 0;
  for (const auto& [folder, extension] :
       {std::pair{"slugs", ".slugsin"}, {"slugs", ".structuredslugs"}, {"gr1c", ".spc"}})
    for (const fs::path& path : files(corpus() / folder, extension)) {
      const std::string text = util::read_file(path.string()).text();
      if (text.size() > 1600) continue;
      std::optional<spec::Gr1> spec;
      try {
        spec = read(path);
      } catch (const util::InputError&) {
        continue;  // reachability games; told above
      }
      const std::string expected = verdict(*spec, 20);
      for (const spec::Dialect dialect : all_dialects)
        EXPECT_EQ(verdict(again(*spec, dialect), 20), expected) << path << ' ' << to_string(dialect);
      ++count;
    }
  fmt::print("{} files ran\n", count);
  EXPECT_GT(count, 40U);
}

}  // namespace
}  // namespace heed::dialects
