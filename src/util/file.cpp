#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

namespace heed::util {
namespace {

Location whole_file(const std::string& path) {
  return {std::make_shared<const std::string>(path), 0, 0};
}

/// What may be meant by a path that cannot be opened: a file beside it with nearly that name.
std::string meant_by(const std::string& path) {
  const std::filesystem::path wanted(path);
  const std::filesystem::path folder = wanted.has_parent_path() ? wanted.parent_path() : ".";
  std::error_code error;
  std::vector<std::string> names;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    names.push_back(it->path().filename().string());
  if (error) return fmt::format("there is no folder '{}' that can be read", folder.string());
  std::sort(names.begin(), names.end());
  const std::string near = nearest(wanted.filename().string(), names);
  return near.empty() || near == wanted.filename() ? "check the path"
                                                   : fmt::format("did you mean '{}'?", near);
}

[[noreturn]] void too_large(const std::string& path, const Limits& limits) {
  throw InputError(whole_file(path), "file-too-large",
                   fmt::format("the file is larger than the limit of {} bytes", limits.input_bytes),
                   "raise the limit with --max-input");
}

/// Closes the descriptor whatever happens.
struct Descriptor {
  int fd = -1;
  explicit Descriptor(int f) : fd(f) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) close(fd);
  }
};

std::string read_all(int fd, const std::string& path, const Limits& limits, std::size_t expected) {
  std::string text;
  text.reserve(expected);
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t n = read(fd, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0)
      throw InputError(whole_file(path), "unreadable", fmt::format("cannot read: {}", std::strerror(errno)));
    if (n == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
    if (limits.input_bytes != 0 && text.size() > limits.input_bytes) too_large(path, limits);
  }
}

}  // namespace

SourceText read_file(const std::string& path, const Limits& limits) {
  if (path == "-") return {"<stdin>", read_all(0, "<stdin>", limits, 0)};
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.fd < 0) {
    const int error = errno;
    throw InputError(whole_file(path), "unreadable", fmt::format("cannot open: {}", std::strerror(error)),
                     error == EACCES ? "check who may read it" : meant_by(path));
  }
  struct stat info {};
  if (fstat(file.fd, &info) != 0 || S_ISDIR(info.st_mode))
    throw InputError(whole_file(path), "unreadable", "is a folder, expected a file", "name a file in it");
  const auto size = S_ISREG(info.st_mode) ? static_cast<std::size_t>(info.st_size) : 0;
  if (limits.input_bytes != 0 && size > limits.input_bytes) too_large(path, limits);
  return {path, read_all(file.fd, path, limits, size)};
}

void write_file(const std::string& path, std::string_view content) {
  std::string temporary = path + ".XXXXXX";
  const auto fail = [&](std::string_view what) {
    const int error = errno;
    unlink(temporary.c_str());
    throw InputError(whole_file(path), "unwritable",
                     fmt::format("cannot {}: {}", what, std::strerror(error)));
  };
  Descriptor file(mkstemp(temporary.data()));
  if (file.fd < 0) fail("create");
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t n = write(file.fd, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("write");
    done += static_cast<std::size_t>(n);
  }
  const mode_t mask = umask(0);
  umask(mask);
  if (fchmod(file.fd, 0666 & ~mask) != 0) fail("set permissions of");
  if (rename(temporary.c_str(), path.c_str()) != 0) fail("rename to");
}

std::string resolve_path(const std::string& base_file, const std::string& path) {
  const std::filesystem::path target(path);
  if (target.is_absolute() || base_file.empty()) return path;
  return (std::filesystem::path(base_file).parent_path() / target).lexically_normal().string();
}

}  // namespace heed::util
