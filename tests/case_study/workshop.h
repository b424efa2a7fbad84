#pragma once

#include <heed/job/controller.h>
#include <heed/job/run.h>

#include <filesystem>
#include <string>
#include <vector>

namespace case_study {

namespace fs = std::filesystem;
using namespace heed;

/// A folder of its own that goes away at the end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string path(const std::string& name = {}) const;

 private:
  std::string path_;
};

[[nodiscard]] std::string read(const std::string& path);
void write(const std::string& path, const std::string& text);

/// \p text with every \p from replaced by \p to; a failure when there is none.
[[nodiscard]] std::string replaced(std::string text, const std::string& from, const std::string& to);

/// The example's three files, copied, to be edited.
class Example {
 public:
  Example();
  [[nodiscard]] std::string scenario() const { return folder_.path("stop-sign.toml"); }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }
  /// Replaces all occurrences of \p from in the file \p name.
  void edit(const std::string& name, const std::string& from, const std::string& to);

 private:
  Folder folder_;
};

/// What a run of the job left: its result, and what it wrote.
struct Outcome {
  job::Scenario scenario;
  report::RunResult result;
};
[[nodiscard]] Outcome run_job(const std::string& scenario, const std::string& output,
                              std::uint64_t traces = 0);
[[nodiscard]] job::Scenario read_scenario(const std::string& path);
[[nodiscard]] model::Mealy read_controller(const std::string& path);
[[nodiscard]] spec::Gr1 read_specification(const std::string& path);

/// What the program said.
struct Said {
  int exit_code = -1;
  std::string out, err;
};
/// Runs the program with words that need no quoting but spaces, in \p folder.
[[nodiscard]] Said heed_says(const std::vector<std::string>& words, const std::string& folder = {});

}  // namespace case_study
