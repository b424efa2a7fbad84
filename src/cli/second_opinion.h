#pragma once

#include "arguments.h"
#include "output.h"

#include <heed/job/knowledge.h>
#include <heed/util/limits.h>

#include <optional>
#include <string>

namespace heed::cli {

struct SecondOpinion {
  std::string text;  ///< A paragraph.
  Json json;
};

/// What \p reasoner ("konclude") adds to heed's own; nothing for "own". \throws UsageError  an unknown word
/// \throws util::InputError  as dl::ask_konclude
[[nodiscard]] std::optional<SecondOpinion> second_opinion(const std::string& reasoner,
                                                          const job::Knowledge& knowledge,
                                                          util::Budget& budget);

}  // namespace heed::cli
