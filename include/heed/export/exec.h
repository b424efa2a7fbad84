#pragma once

#include <heed/export/symbolic_runner.h>
#include <heed/model/mealy.h>

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

namespace heed::exporter {

/// The line protocol of `heed exec` (docs/formats/exec.md): one JSON observation in, one JSON reaction out.
/// Every line is answered with exactly one line, whatever its bytes are; nothing is thrown for bad input.
class LineExecutor {
 public:
  static constexpr std::size_t max_line = std::size_t{64} * 1024;  ///< Bytes of a line without its end.

  /// \throws InputError  the machine has no states or two inputs of one name
  explicit LineExecutor(model::Mealy machine);
  /// The same for a symbolic controller.
  explicit LineExecutor(SymbolicRunner runner);
  ~LineExecutor();
  LineExecutor(LineExecutor&&) noexcept;
  LineExecutor& operator=(LineExecutor&&) noexcept;

  /// The answer to one line, without a line feed. O(length of line and answer). Of a line longer than
  /// `max_line` the first `max_line + 1` bytes suffice.
  [[nodiscard]] std::string line(std::string_view json);

  /// Lines from \p in to \p out until one of them ends. Holds at most one line in memory; writes out when
  /// nothing more is waiting to be read.
  void run(std::istream& in, std::ostream& out);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heed::exporter
