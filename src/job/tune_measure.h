#pragma once

#include <heed/job/evaluate.h>
#include <heed/job/tune.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace heed::job {

/// The figures of many machines. What does not depend on the machine (what a thing looks like under a
/// profile, its chain) is made once for all, what does not depend on the profile (how a machine is judged)
/// once for each, and machines that react alike are measured once.
class TuneMeasure {
 public:
  TuneMeasure(const Scenario& scenario, const World& world, util::Budget& budget);

  void add(model::Mealy machine);

  struct Place {
    std::size_t thing = 0;  ///< That is approached.
    std::size_t profile = 0, noise = 0;
  };
  /// Appends the figures of all machines, in the order in which they were added.
  void measure(const Place& place, Tuning& tuning);

 private:
  struct Machine {
    model::Mealy mealy;
    sim::Judge judge;
    std::vector<std::uint64_t> reactions;
  };
  /// Things that look alike, of which none asks for a reaction.
  struct Look {
    Thing first;
    unsigned long count = 0;
  };

  [[nodiscard]] std::vector<Look> looks(const ProfilePart& profile) const;
  [[nodiscard]] TuneFigure figure(const sim::LumpedOutcome& own) const;
  void add_braking(const sim::LumpedOutcome& own, TuneFigure& figure) const;

  const Scenario& scenario_;
  const World& world_;
  util::Budget& budget_;
  std::vector<Thing> needless_;  ///< What neither obliges to react nor excuses it, and nothing at all.
  std::vector<Machine> machines_;
  std::vector<std::size_t> of_;  ///< Per policy: its machine.
};

}  // namespace heed::job
