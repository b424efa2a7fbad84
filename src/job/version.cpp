#include <heed/job/version.h>

namespace heed::job {

std::string version() {
  return HEED_VERSION;
}

}  // namespace heed::job
