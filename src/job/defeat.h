#pragma once

#include <heed/job/controller.h>

#include <string>
#include <vector>

namespace heed::job {

/// What an observation shows: "sign, octagon, main_colour = red"; "nothing" where it shows nothing.
[[nodiscard]] std::string seen_words(const game::Values& observation);

/// The plant's state in a turn; empty where it has none.
[[nodiscard]] std::string state_of(const game::Turn& turn);

/// Why no controller exists, sentence by sentence. The first one is the short answer: in which state there is
/// no way out, what is seen then, which requirement fails and what the plant could do instead.
[[nodiscard]] std::vector<std::string> describe_defeat(const World& world,
                                                       const strategy::CounterPlay& counter);

}  // namespace heed::job
