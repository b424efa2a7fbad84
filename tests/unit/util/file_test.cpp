#include "temporary_folder.h"

#include <heed/util/diagnostic.h>
#include <heed/util/file.h>
#include <heed/util/limits.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace heed::util {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

  test::TemporaryFolder folder_;
};

TEST_F(FileTest, WritesWholeAndReadsBack) {
  write_file(path("a"), "first");
  write_file(path("a"), "second");
  EXPECT_EQ(read_file(path("a")).text(), "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1)
      << "no temporary is left";
}

TEST_F(FileTest, RefusesWhatItCannotRead) {
  EXPECT_THROW((void)read_file(path("none")), InputError);
  EXPECT_THROW((void)read_file(folder_.path()), InputError);
  EXPECT_THROW(write_file(path("none/a"), "x"), InputError);
}

TEST_F(FileTest, HoldsTheSizeLimitBeforeReading) {
  write_file(path("a"), std::string(100, 'x'));
  Limits limits;
  limits.input_bytes = 99;
  EXPECT_THROW((void)read_file(path("a"), limits), InputError);
  limits.input_bytes = 100;
  EXPECT_EQ(read_file(path("a"), limits).text().size(), 100U);
}

TEST(ResolvePath, IsRelativeToTheFolderOfTheBase) {
  EXPECT_EQ(resolve_path("a/b.toml", "c.owl"), "a/c.owl");
  EXPECT_EQ(resolve_path("a/b.toml", "../c.owl"), "c.owl");
  EXPECT_EQ(resolve_path("a/b.toml", "/c.owl"), "/c.owl");
}

TEST(Budget, EndsWorkOnTimeMemoryAndCancellation) {
  Limits limits;
  limits.seconds = 1e-9;
  Budget time(limits);
  EXPECT_THROW(
      {
        for (int i = 0; i < 100; ++i) time.check();
      },
      LimitExceeded);
  limits = {};
  limits.memory_bytes = 1;
  Budget memory(limits);
  EXPECT_THROW(memory.reserve(1), LimitExceeded);
  Budget cancelled;
  cancelled.check();
  cancelled.cancel();
  EXPECT_THROW(cancelled.check(), LimitExceeded);
}

}  // namespace
}  // namespace heed::util
