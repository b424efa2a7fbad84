#include <heed/util/limits.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace heed::util {
namespace {
/// What may be added without asking the system, which takes some microseconds: far below how exactly a limit
/// is kept.
constexpr std::size_t too_little_to_ask = std::size_t{1} << 23;
}  // namespace

Budget::Budget(const Limits& limits) : limits_(limits), start_(std::chrono::steady_clock::now()) {}

double Budget::elapsed_seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Budget::check() {
  if (cancelled_.load(std::memory_order_relaxed))
    throw LimitExceeded(LimitExceeded::Kind::Cancelled, "cancelled");
  ++calls_;
  if (limits_.seconds > 0 && (calls_ & 15U) == 0 && elapsed_seconds() > limits_.seconds)
    throw LimitExceeded(LimitExceeded::Kind::Time,
                        "time limit reached (" + std::to_string(limits_.seconds) + " s)");
  if (limits_.memory_bytes > 0 && (calls_ & 1023U) == 0) reserve(0);
}

void Budget::reserve(std::size_t bytes) {
  if (limits_.memory_bytes == 0) return;
  asked_for_ += bytes;
  if (bytes != 0 && asked_for_ < std::min(too_little_to_ask, limits_.memory_bytes / 64)) return;
  asked_for_ = 0;
  if (resident_bytes() + bytes > limits_.memory_bytes)
    throw LimitExceeded(LimitExceeded::Kind::Memory,
                        "memory limit reached (" + std::to_string(limits_.memory_bytes >> 20) + " MiB)");
}

std::size_t resident_bytes() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0;
  unsigned long size = 0, resident = 0;
  const int read = std::fscanf(file, "%lu %lu", &size, &resident);
  std::fclose(file);
  return read == 2 ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

std::size_t peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace heed::util
