#pragma once

#include <heed/util/limits.h>

#include <cstddef>
#include <string>
#include <vector>

namespace heed::dl {

struct Command {
  std::vector<std::string> words;  ///< The program, a path or a name that PATH knows, and its arguments.
  double seconds;
  std::size_t memory_bytes;  ///< Of address space; 0: no limit.
};

struct Finished {
  bool found = true;  ///< The program could be started.
  int exit_code = 0;  ///< Where it ended by itself.
  int signal = 0;     ///< That ended it, or 0.
  std::string log{};  ///< Both outputs, the first MiB.
};

/// Runs a program to its end, without input. It and what it started are killed when time is up.
/// \throws util::LimitExceeded  the time of \p command, or \p budget
[[nodiscard]] Finished run(const Command& command, util::Budget& budget);

}  // namespace heed::dl
