#pragma once

#include <heed/job/controller.h>
#include <heed/util/diagnostic.h>

#include <string>
#include <vector>

namespace heed::job {

/// How a binding of the scenario stands to the others, for one controller.
struct Precedence {
  std::string name;                             ///< Of the definition, such as "prescribed_halt".
  bool prescribed = false;                      ///< Whether anything that is recognised prescribes it.
  logic::Formula unless = logic::truth(false);  ///< It gives way while this holds; over definitions.
};

/// One per binding of \p scenario, in its order. A behaviour gives way to those that come before it in
/// `priority` and whose plant formula excludes its own, unless these give way themselves.
[[nodiscard]] std::vector<Precedence> precedences(const Scenario& scenario, const World& world,
                                                  const awareness::Recognition& recognition);

/// Pairs of behaviours whose plant formulas exclude each other and that perception can bring about together
/// whatever the plant does, each with an example: a note where a priority settles it. \throws
/// util::InputError "conflicting-behaviours"  where none does
[[nodiscard]] util::Diagnostics settle_clashes(const Scenario& scenario, const World& world,
                                               const Design& design, util::Budget& budget);

}  // namespace heed::job
