#include "staging.h"

#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

namespace heed::job {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw util::InputError(util::Location{std::make_shared<const std::string>(path), 0, 0}, "unwritable",
                         fmt::format("cannot write the output folder: {}", what),
                         "choose another folder with --output");
}

}  // namespace

Staging::Staging(std::string target) : target_(std::move(target)) {
  while (target_.size() > 1 && target_.back() == '/') target_.pop_back();
  std::error_code error;
  const fs::path parent = fs::path(target_).parent_path();
  if (!parent.empty()) fs::create_directories(parent, error);
  if (error) fail(target_, error.message());
  if (fs::exists(target_) && !fs::is_directory(target_)) fail(target_, "it is a file");
  folder_ = target_ + ".XXXXXX";
  if (mkdtemp(folder_.data()) == nullptr) {
    const std::string attempted = std::exchange(folder_, {});
    fail(target_, "no temporary folder beside it");
  }
}

Staging::~Staging() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

std::string Staging::write(const std::string& name, std::string_view content) {
  std::string path = folder_ + '/' + name;
  util::write_file(path, content);
  names_.push_back(name);
  return path;
}

void Staging::commit() {
  std::error_code error;
  fs::create_directories(target_, error);
  if (error) fail(target_, error.message());
  for (const std::string& name : names_) {
    fs::rename(folder_ + '/' + name, target_ + '/' + name, error);
    if (error) fail(target_ + '/' + name, error.message());
  }
  for (const std::string& name : discarded_) fs::remove(target_ + '/' + name, error);
  names_.clear();
}

}  // namespace heed::job
