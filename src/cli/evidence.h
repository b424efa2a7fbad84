#pragma once

#include "output.h"

#include <heed/job/knowledge.h>
#include <heed/job/scenario.h>

#include <string>

namespace heed::cli {

/// What `heed kb --evidence` shows. \p scenario  says what is reported, and what each of its controllers
/// does; without one everything is reported.
struct EvidenceView {
  std::string text;
  Json json;
};
[[nodiscard]] EvidenceView evidence_view(const job::Knowledge& knowledge, const job::Scenario* scenario,
                                         bool closed);

}  // namespace heed::cli
