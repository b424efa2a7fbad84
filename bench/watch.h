#pragma once

#include <ctime>
#include <stdexcept>
#include <string>

namespace heed::bench {

class Watch {
 public:
  /// CPU seconds since the last call.
  double lap() {
    const std::clock_t now = std::clock(), before = last_;
    last_ = now;
    return static_cast<double>(now - before) / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t last_ = std::clock();
};

/// A figure of something wrong is none. \throws std::runtime_error
inline void insist(bool right, const std::string& fault) {
  if (!right) throw std::runtime_error("refused: " + fault);
}

}  // namespace heed::bench
