#pragma once

#include <heed/util/source.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace heed::util {

enum class Severity { Note, Warning, Error };

/// One message about an input. `code` is a stable word for tests and JSON, such as "unknown-key".
struct Diagnostic {
  Severity severity = Severity::Warning;
  Location location;
  std::string code;
  std::string message;  ///< One sentence, no full stop; says what was found and what was expected.
  std::string hint;     ///< What to do about it; may be empty.
  std::string excerpt;  ///< The offending line and a caret line below it; may be empty.
};

/// "file:3:7: error: message [code]", then excerpt and "hint: ..." on lines of their own.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

/// What a user can break: the only exception for bad input. Ends in exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Diagnostic diagnostic);
  InputError(Location location, std::string code, std::string message, std::string hint = {});
  /// Adds the line and a caret from \p source.
  InputError(const SourceText& source, std::size_t offset, std::string code, std::string message,
             std::string hint = {});
  [[nodiscard]] const Diagnostic& diagnostic() const { return diagnostic_; }

 private:
  Diagnostic diagnostic_;
};

/// Warnings and notes that a stage hands on beside its result, in the order found.
using Diagnostics = std::vector<Diagnostic>;

/// The candidate closest to \p word by edit distance, if close enough to be a slip; else empty. O(n *
/// |word|^2).
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean 'x'?", or "known: a, b, c" where nothing is near (at most \p most names).
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                                     std::size_t most = 12);

}  // namespace heed::util
