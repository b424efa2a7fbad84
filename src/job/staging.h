#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace heed::job {

/// A folder beside its target that takes files until all is well: commit() moves them over, the destructor
/// removes what was not committed.
class Staging {
 public:
  /// \throws util::InputError  the parent cannot be written.
  explicit Staging(std::string target);
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  /// \returns the path where the file stands until commit().
  std::string write(const std::string& name, std::string_view content);
  /// A file of this name from an earlier run goes away with commit().
  void discard(const std::string& name) { discarded_.push_back(name); }
  void commit();

 private:
  std::string target_, folder_;
  std::vector<std::string> names_, discarded_;
};

}  // namespace heed::job
