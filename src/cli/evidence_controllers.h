#pragma once

#include "output.h"

#include <heed/awareness/glimpse.h>
#include <heed/job/scenario.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace heed::cli {

/// What the controllers of a scenario do while an entity comes into view: on each of its features alone, on
/// all of them together, and on the entity read whole.
class ControllerEvidence {
 public:
  /// \param scenario  nullptr: no controllers. All outlive this object.
  ControllerEvidence(const awareness::Catalogue& catalogue, const awareness::Perception& perception,
                     const job::Scenario* scenario);
  [[nodiscard]] std::string text(const awareness::Approach& approach) const;
  [[nodiscard]] Json json(const awareness::Approach& approach) const;

 private:
  struct Controller {
    std::string name;
    awareness::Recognition recognition;
  };
  struct Sight {
    std::string words;  ///< "red", "all of it"
    std::set<std::string> seen;
  };
  [[nodiscard]] std::vector<Sight> sights(const awareness::Approach& approach) const;
  [[nodiscard]] std::string reaction(const std::vector<std::size_t>& behaviours) const;
  [[nodiscard]] std::string line(const Controller& controller, const awareness::Approach& approach) const;

  const awareness::Catalogue& catalogue_;
  const awareness::Perception& perception_;
  std::vector<Controller> controllers_;
  std::map<std::size_t, std::string> bound_;  ///< Behaviours, and what of the plant they are.
};

}  // namespace heed::cli
