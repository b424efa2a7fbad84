#include "ranks.h"

#include "arguments.h"
#include "mpi/module.h"

#include <fmt/format.h>

#include <dlfcn.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace heed::cli {

/// Found by the run path of the program. It is never unloaded: MPI keeps what must outlive it.
struct Ranks::Module {
  decltype(&heed_mpi_start) start = nullptr;
  decltype(&heed_mpi_first_failed) first_failed = nullptr;
  decltype(&heed_mpi_sum) sum = nullptr;
  decltype(&heed_mpi_tell) tell = nullptr;
  decltype(&heed_mpi_finish) finish = nullptr;

  static std::unique_ptr<const Module> load() {
    // Open MPI's own plugins look for its symbols among those that everybody sees.
    void* const library = dlopen("libheed_mpi.so", RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) return nullptr;
    auto module = std::make_unique<Module>();
    const auto find = [&]<class Function>(Function& function, const char* name) {
      function = reinterpret_cast<Function>(dlsym(library, name));
      return function != nullptr;
    };
    const bool whole = find(module->start, "heed_mpi_start") &&
                       find(module->first_failed, "heed_mpi_first_failed") &&
                       find(module->sum, "heed_mpi_sum") && find(module->tell, "heed_mpi_tell") &&
                       find(module->finish, "heed_mpi_finish");
    return whole ? std::move(module) : nullptr;
  }
};

namespace {

/// A number that Open MPI's mpirun leaves in the environment of each process; \p otherwise where it does not.
int from_mpirun(const char* name, int otherwise) {
  const char* const text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing else runs yet
  return text == nullptr ? otherwise : std::atoi(text);
}

void mute(std::FILE* stream) {
  (void)!std::freopen("/dev/null", "w", stream);
}

}  // namespace

std::unique_ptr<Ranks> Ranks::join() {
  if (from_mpirun("OMPI_COMM_WORLD_SIZE", 1) < 2) return nullptr;
  const bool first = from_mpirun("OMPI_COMM_WORLD_RANK", 0) == 0;
  if (!first) mute(stdout);
  auto module = Module::load();
  if (!module) {
    if (!first) mute(stderr);
    throw UsageError("mpirun started several processes, but this program was built without MPI",
                     "install libopenmpi-dev (scripts/setup extras), then configure with -DHEED_MPI=ON");
  }
  return std::unique_ptr<Ranks>(new Ranks(std::move(module)));
}

Ranks::Ranks(std::unique_ptr<const Module> module) : module_(std::move(module)) {
  if (module_->start(&rank_, &size_) != 0) throw std::runtime_error("MPI cannot be started");
}

Ranks::~Ranks() {
  module_->finish();
}

unsigned Ranks::rank() const {
  return static_cast<unsigned>(rank_);
}

unsigned Ranks::size() const {
  return static_cast<unsigned>(size_);
}

void Ranks::meet() {
  speaker_ = module_->first_failed(0);
  if (speaker_ >= 0) throw PeerFailed();
}

void Ranks::sum(std::span<std::uint64_t> counts) {
  meet();
  module_->sum(counts.data(), static_cast<int>(counts.size()));
}

Ending Ranks::end(Ending own) {
  // Who learnt of a failure in meet() has been in the call that the others make here.
  if (speaker_ < 0) speaker_ = module_->first_failed(own.failed ? 1 : 0);
  if (speaker_ < 0) return own;
  std::uint64_t head[2] = {static_cast<std::uint64_t>(own.code), own.message.size()};
  module_->tell(speaker_, reinterpret_cast<char*>(head), sizeof head);
  Ending told{static_cast<int>(head[0]), true, std::move(own.message)};
  told.message.resize(head[1]);
  module_->tell(speaker_, told.message.data(), static_cast<int>(head[1]));
  if (rank_ != 0) told.message.clear();
  return told;
}

}  // namespace heed::cli
