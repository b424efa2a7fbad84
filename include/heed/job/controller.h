#pragma once

#include <heed/awareness/perception.h>
#include <heed/awareness/policy.h>
#include <heed/awareness/sigma.h>
#include <heed/check/verify.h>
#include <heed/job/knowledge.h>
#include <heed/job/scenario.h>
#include <heed/model/fts.h>
#include <heed/spec/compose.h>
#include <heed/strategy/synthesize.h>

#include <optional>
#include <string>
#include <vector>

namespace heed::job {

/// What all controllers of a scenario share: knowledge, plant, and what is perceived.
struct World {
  Knowledge knowledge;
  model::Fts plant;
  std::vector<std::uint32_t> initial_states;
  awareness::Perception perception;
};

/// What perception reports of the catalogue's things, as the scenario says.
[[nodiscard]] awareness::Perception perceive(const PerceptionPart& part,
                                             const awareness::Catalogue& catalogue);

/// \throws util::InputError  of any of the files; an entity without possible instance.
[[nodiscard]] World load_world(const Scenario& scenario, const util::Limits& limits, util::Budget& budget);

/// When a controller counts things as recognised, and what it is then to do.
[[nodiscard]] awareness::Recognition recognise(const ControllerPart& part,
                                               const awareness::Catalogue& catalogue,
                                               const awareness::Perception& perception);

/// One controller's specification, before it is played.
struct Design {
  awareness::Recognition recognition;
  std::vector<awareness::SigmaFormula> sigma;
  spec::Composed composed;  ///< With every assumption.
};

[[nodiscard]] Design design(const Scenario& scenario, const World& world, const ControllerPart& part);

/// \p spec without the assumptions on perception; nothing when it has none.
[[nodiscard]] std::optional<spec::Gr1> without_perception_assumptions(const spec::Gr1& spec);

/// One controller, played and checked.
struct Synthesized {
  strategy::Result result;                ///< `machine` carries name, assumptions and notes when realizable.
  std::optional<check::Verdict> verdict;  ///< Of the machine against the whole specification.
  bool assumptions_dropped = false;       ///< It wins without the assumptions on perception, checked as well.
};

/// Synthesizes and verifies. A machine that the check refuses is a defect of heed: the verdict says so,
/// nobody hides it.
[[nodiscard]] Synthesized synthesize(const Design& design, Violation on_violation, util::Budget& budget);

}  // namespace heed::job
