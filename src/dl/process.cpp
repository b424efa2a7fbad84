#include "process.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

namespace heed::dl {
namespace {

constexpr int cannot_start = 127;
constexpr std::size_t log_bytes = std::size_t{1} << 20;

/// Both ends of a pipe; what is still open is closed at the end.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) ends_ = {-1, -1};
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  [[nodiscard]] int read_end() const { return ends_[0]; }
  [[nodiscard]] int write_end() const { return ends_[1]; }
  void close_end(std::size_t which) {
    if (ends_[which] >= 0) ::close(ends_[which]);
    ends_[which] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// A child in a process group of its own; killed, with what it started, unless it was waited for.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (id_ <= 0) return;
    ::kill(-id_, SIGKILL);
    ::kill(id_, SIGKILL);
    (void)wait();
  }
  int wait() {
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) continue;
    id_ = 0;
    return status;
  }

 private:
  pid_t id_;
};

/// Between fork and exec only what signal handlers may do is allowed.
[[noreturn]] void become(char* const* words, int output, std::size_t memory_bytes) {
  ::setpgid(0, 0);
  if (memory_bytes != 0) {
    const rlimit limit{memory_bytes, memory_bytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execvp(words[0], words);
  ::_exit(cannot_start);
}

/// Reads until the other end is closed by all who have it.
std::string read_all(int from, double seconds, util::Budget& budget) {
  const auto start = std::chrono::steady_clock::now();
  std::string log;
  std::array<char, 4096> buffer{};
  for (;;) {
    budget.check();
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (elapsed > seconds)
      throw util::LimitExceeded(util::LimitExceeded::Kind::Time,
                                fmt::format("the external reasoner did not end within {:g} s", seconds));
    pollfd waiting{from, POLLIN, 0};
    if (::poll(&waiting, 1, 100) <= 0) continue;
    const ssize_t count = ::read(from, buffer.data(), buffer.size());
    if (count == 0 || (count < 0 && errno != EINTR)) return log;
    if (count > 0 && log.size() < log_bytes) log.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Finished run(const Command& command, util::Budget& budget) {
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  Pipe pipe;
  if (pipe.read_end() < 0) return {.found = false};
  const pid_t id = ::fork();
  if (id < 0) return {.found = false};
  if (id == 0) become(words.data(), pipe.write_end(), command.memory_bytes);
  Child child(id);
  pipe.close_end(1);
  Finished out;
  out.log = read_all(pipe.read_end(), command.seconds, budget);
  const int status = child.wait();
  if (WIFEXITED(status)) out.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) out.signal = WTERMSIG(status);
  out.found = out.exit_code != cannot_start;
  return out;
}

}  // namespace heed::dl
