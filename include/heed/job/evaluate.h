#pragma once

#include <heed/job/controller.h>
#include <heed/model/mealy.h>
#include <heed/model/symbolic.h>
#include <heed/sim/exact.h>
#include <heed/sim/lumping.h>
#include <heed/sim/run.h>
#include <heed/sim/sample.h>
#include <heed/util/limits.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace heed::job {

/// Which transitions of \p machine satisfy each of \p formulas, one flag per transition: formulas without
/// temporal operators over the names of its columns and inputs. \param replaced  names that could be used as
/// well and have been replaced already, such as the plant's labels; for suggestions. \throws util::InputError
/// a name that is no column, with the nearest one.
[[nodiscard]] std::vector<std::vector<bool>> hold_at_transitions(
    const std::vector<logic::Formula>& formulas, const model::Mealy& machine,
    const std::vector<std::string>& replaced = {});

/// Refuses an event or an outcome that no controller of \p design could be judged by, before any is made.
/// \throws util::InputError  an unknown name with the nearest one; a temporal operator other than Next over
/// the plant
void check_evaluate(const Scenario& scenario, const World& world, const Design& design);

/// How the runs of \p machine are judged: by the outcomes of the scenario, the first event decides. With \p
/// never_apart, runs without an event get a category of their own, the last one, instead of the one for the
/// rest.
[[nodiscard]] sim::Judge make_judge(const Scenario& scenario, const World& world, const model::Mealy& machine,
                                    bool never_apart);

/// The same for a machine by functions, which must outlive it, as must \p scenario and \p world.
[[nodiscard]] sim::SymbolicJudge make_judge(const Scenario& scenario, const World& world,
                                            const model::SymbolicController& machine, bool never_apart);

/// What is on the road: an entity of the catalogue, or nothing.
using Thing = std::optional<std::size_t>;

/// The chain of \p profile for \p thing and the wires from its features to the machine's inputs. A feature of
/// the profile is a reported symbol, present when the ontology entails it of the thing, or an enumerated
/// input, which shows the thing's value. \throws util::InputError  a feature that is neither.
struct Approach {
  sim::Chain chain;
  sim::Binding binding;
};
[[nodiscard]] Approach approach(const ProfilePart& profile, const World& world, const model::Mealy& machine,
                                Thing thing, util::Budget& budget);

/// The same before the chain is made of it.
struct PlannedApproach {
  sim::ProfileSpec profile;
  sim::Binding binding;
};
/// \param inputs  Of the machine \p controller.
[[nodiscard]] PlannedApproach plan_approach(const ProfilePart& profile, const World& world,
                                            const std::vector<model::Variable>& inputs,
                                            const std::string& controller, Thing thing);

/// An approach that is ready for any machine with the same inputs: nothing in it depends on what it answers.
struct ReadyApproach {
  PlannedApproach plan;
  std::optional<sim::Chain> chain;  ///< Where it is small.
};
[[nodiscard]] ReadyApproach ready_approach(const ProfilePart& profile, const World& world,
                                           const std::vector<model::Variable>& inputs,
                                           const std::string& controller, Thing thing, util::Budget& budget);

/// Approaches that several machines make: each is made ready once.
class Approaches {
 public:
  Approaches(const World& world, util::Budget& budget) : world_(world), budget_(budget) {}
  /// Valid as long as this.
  const ReadyApproach& ready(const ProfilePart& profile, const model::Mealy& machine, Thing thing);

 private:
  const World& world_;
  util::Budget& budget_;
  std::map<std::string, ReadyApproach> known_;
};

/// What the exact analysis finds of a machine on an approach. \param judge  Of that machine. \throws
/// util::LimitExceeded
[[nodiscard]] sim::LumpedOutcome exact_figures(const ReadyApproach& approach, const model::Mealy& machine,
                                               const sim::Judge& judge, util::Budget& budget);

/// What an approach looks like: the same text means the same distribution of observations.
[[nodiscard]] std::string appearance(const ProfilePart& profile, const World& world, Thing thing);

/// One chart: exact and sampled outcomes.
struct Evaluation {
  std::vector<std::string> categories;
  sim::LumpedOutcome figures;  ///< Of the exact analysis, rounded with a bound where fractions cost too much.
  sim::ExactOutcome exact;     ///< The same as fractions, where figures.exact.
  sim::SampleOutcome sampled;
  double confidence = 0;      ///< At which the intervals of `sampled` are to be taken.
  bool width_reached = true;  ///< False: `traces` came before EvaluateOptions::width.
};
struct EvaluateOptions {
  std::uint64_t traces = 0, seed = 1;
  unsigned threads = 1;
  bool never_apart = false;
  double width = 0;  ///< Above 0: sample until every interval is that narrow, at most `traces` times.
  sim::Team* team = nullptr;  ///< Shares the sampling.
};
[[nodiscard]] Evaluation evaluate(const Scenario& scenario, const World& world, const ProfilePart& profile,
                                  const model::Mealy& machine, Thing thing, const EvaluateOptions& options,
                                  util::Budget& budget);
/// For a machine by functions: \p options beside `never_apart` are not used, nothing is sampled.
[[nodiscard]] Evaluation evaluate(const Scenario& scenario, const World& world, const ProfilePart& profile,
                                  const model::SymbolicController& machine, Thing thing,
                                  const EvaluateOptions& options, util::Budget& budget);

/// The plant's states on the way when \p thing becomes visible as a whole in \p cell (or never, if \p cell is
/// past the last one); empty when the machine does not tell.
[[nodiscard]] std::vector<std::string> states_on_the_way(const World& world, const ProfilePart& profile,
                                                         const model::Mealy& machine, Thing thing,
                                                         std::uint32_t cell);

}  // namespace heed::job
