#include <heed/sim/traffic.h>
#include <heed/util/diagnostic.h>

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

namespace heed::sim {
namespace {

using Make = TrafficEngine* (*)();

/// Where the module may be: beside the program as built or as installed, else where the loader looks for
/// libraries.
std::vector<std::string> places(const std::string& module) {
  if (!module.empty()) return {module};
  std::vector<std::string> found;
#ifdef HEED_SUMO_MODULE
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  for (const char* folder : {"lib/heed", HEED_MODULE_FOLDER})
    if (!unknown) found.push_back((program.parent_path().parent_path() / folder / HEED_SUMO_MODULE).string());
  found.emplace_back(HEED_SUMO_MODULE);
#endif
  return found;
}

[[noreturn]] void missing(const std::string& why) {
  throw util::InputError(
      util::Location{}, "no-sumo", why,
      "install SUMO with `scripts/setup extras` (Debian: sumo, sumo-tools), then configure and build "
      "again; heed simulate needs none of it");
}

}  // namespace

std::unique_ptr<TrafficEngine> load_sumo(const std::string& module) {
  const std::vector<std::string> where = places(module);
  if (where.empty()) missing("this program was built without SUMO, the simulator of traffic");
  std::string reason;
  for (const std::string& path : where) {
    // Never unloaded: SUMO's libraries do not survive that.
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle == nullptr) {
      const char* told = dlerror();
      if (reason.empty() || std::filesystem::exists(path)) reason = told != nullptr ? told : "unknown";
      continue;
    }
    const auto make = reinterpret_cast<Make>(dlsym(handle, "heed_sumo_engine"));
    if (make == nullptr) missing("the module " + path + " is none of heed's");
    return std::unique_ptr<TrafficEngine>(make());
  }
  missing("SUMO, the simulator of traffic, cannot be loaded: " + reason);
}

}  // namespace heed::sim
