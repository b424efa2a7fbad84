#pragma once

#include "output.h"

#include <heed/job/knowledge.h>
#include <heed/job/scenario.h>

#include <string>

namespace heed::cli {

/// What `heed kb --evidence` shows. \p perception  what is reported; empty: everything
struct EvidenceView {
  std::string text;
  Json json;
};
[[nodiscard]] EvidenceView evidence_view(const job::Knowledge& knowledge,
                                         const job::PerceptionPart& perception, bool closed);

}  // namespace heed::cli
