#pragma once

#include <heed/job/evaluate.h>
#include <heed/sim/rational.h>

#include <optional>

namespace heed::job {

/// What a controller is expected to do along a road: all of it exact. Needless: it reacts to what neither
/// obliges nor excuses. A miss: something that obliges to react ends in the outcome of a miss, or never.
struct RoadEvaluation {
  sim::Rational needless = 0, misses = 0;
  std::optional<sim::Rational> conflict;  ///< P(what is seen contradicts itself, somewhere on the road).
  sim::Rational missing = 0;              ///< P(no answer at some time).
  /// The same for each thing passed, when the road goes on for ever; nothing where that is too large.
  struct PerThing {
    sim::Rational needless = 0, misses = 0;
    std::optional<sim::Rational> conflicts;  ///< Share of things at which there is one.
  };
  std::optional<PerThing> long_run;
};

/// \throws util::InputError  a road names what is no entity
void check_roads(const Scenario& scenario, const World& world);

/// \param approaches  Of the same world; shared by the machines that are driven.
/// \throws util::InputError  an unknown thing; util::LimitExceeded  the chain of a profile is too large
[[nodiscard]] RoadEvaluation evaluate_road(const Scenario& scenario, const World& world,
                                           const ProfilePart& profile, const RoadPart& road,
                                           const model::Mealy& machine, Approaches& approaches,
                                           util::Budget& budget);

/// Which transitions of \p machine see a conflict: where `conflict` of [evaluate] holds, else its column
/// `observation_conflict`; nothing where it has neither.
[[nodiscard]] std::optional<std::vector<bool>> conflicts_of(const Scenario& scenario, const World& world,
                                                            const model::Mealy& machine);

/// P(a conflict during one approach of \p thing); nothing where the controller knows of none.
[[nodiscard]] std::optional<sim::Rational> conflict_probability(const Scenario& scenario, const World& world,
                                                                const ProfilePart& profile,
                                                                const model::Mealy& machine, Thing thing,
                                                                util::Budget& budget);

/// Whether \p thing, or something above it, prescribes one of \p behaviours.
[[nodiscard]] bool prescribes(const World& world, Thing thing, const std::vector<Word>& behaviours);

}  // namespace heed::job
