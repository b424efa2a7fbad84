#pragma once

#include <heed/sim/team.h>

#include <exception>
#include <memory>
#include <string>

namespace heed::cli {

/// How a command ended: its exit code, and what is to be printed where it failed.
struct Ending {
  int code = 0;
  bool failed = false;
  std::string message;
};

/// Another process of the team has failed, and will say why.
class PeerFailed : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "another process failed"; }
};

/// The processes that one mpirun started. They run the same command on the same input and share what is
/// drawn; the first alone writes. All reach the same ending: whoever fails goes to end(), the others learn of
/// it in sum() or there.
class Ranks final : public sim::Team {
 public:
  /// \returns nothing where mpirun did not start this process together with others. \throws UsageError  It
  /// did, but this program was built without MPI.
  [[nodiscard]] static std::unique_ptr<Ranks> join();
  ~Ranks() override;

  [[nodiscard]] unsigned rank() const override;
  [[nodiscard]] unsigned size() const override;
  /// \throws PeerFailed
  void sum(std::span<std::uint64_t> counts) override;
  /// Waits until all have come as far. \throws PeerFailed
  void meet();
  /// The ending of the first process that failed, with its message for the one that writes; else one's own.
  /// To be called last, once, by everybody.
  [[nodiscard]] Ending end(Ending own);

 private:
  struct Module;
  explicit Ranks(std::unique_ptr<const Module> module);
  std::unique_ptr<const Module> module_;
  int rank_ = 0, size_ = 1;
  int speaker_ = -1;  ///< The first that failed, once everybody knows.
};

}  // namespace heed::cli
