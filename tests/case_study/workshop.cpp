#include "workshop.h"

#include <heed/spec/text.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace case_study {

Folder::Folder() : path_((fs::temp_directory_path() / "heed-case-study-XXXXXX").string()) {
  if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder");
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Folder::path(const std::string& name) const {
  return name.empty() ? path_ : path_ + '/' + name;
}

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in.good()) << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  EXPECT_TRUE(out.good()) << path;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  std::size_t count = 0;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
    ++count;
  }
  EXPECT_GT(count, 0U) << "not found: " << from;
  return text;
}

Example::Example() {
  for (const char* name : {"stop-sign.toml", "car.fts", "traffic-signs.owl"})
    fs::copy_file(fs::path(HEED_SOURCE_DIR) / "examples/stop-sign" / name, folder_.path(name));
}

void Example::edit(const std::string& name, const std::string& from, const std::string& to) {
  write(path(name), replaced(read(path(name)), from, to));
}

job::Scenario read_scenario(const std::string& path) {
  return job::read_scenario(util::read_file(path));
}

Outcome run_job(const std::string& scenario, const std::string& output, std::uint64_t traces) {
  Outcome outcome{read_scenario(scenario), {}};
  job::RunOptions options;
  options.output = output;
  options.traces = traces;
  util::Budget budget;
  outcome.result = job::run(outcome.scenario, options, budget);
  return outcome;
}

model::Mealy read_controller(const std::string& path) {
  return model::read_mealy(util::read_file(path));
}

spec::Gr1 read_specification(const std::string& path) {
  return spec::read_gr1(util::read_file(path));
}

Said heed_says(const std::vector<std::string>& words, const std::string& folder) {
  const Folder scratch;
  std::string command = folder.empty() ? "" : "cd '" + folder + "' && ";
  command += "'" HEED_PROGRAM "'";
  for (const std::string& word : words) command += " '" + word + "'";
  command += " >'" + scratch.path("out") + "' 2>'" + scratch.path("err") + "' </dev/null";
  const int status = std::system(command.c_str());
  Said said;
  said.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  said.out = read(scratch.path("out"));
  said.err = read(scratch.path("err"));
  return said;
}

}  // namespace case_study
