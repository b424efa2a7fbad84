#pragma once

#include "arguments.h"

#include <heed/job/controller.h>
#include <heed/job/scenario.h>

#include <string>

namespace heed::cli {

[[nodiscard]] bool is_scenario(const std::string& path);  ///< Ends in .toml.
[[nodiscard]] job::Scenario load_scenario(const Arguments& arguments);
/// The knowledge of a scenario, or of an ontology with the roots that the options name, or that are guessed.
[[nodiscard]] job::KnowledgePart knowledge_part(const Arguments& arguments, util::Budget& budget,
                                                util::Diagnostics& notes);
/// The controllers that --controller names (default: all), in the order of the scenario. \throws UsageError
[[nodiscard]] std::vector<const job::ControllerPart*> chosen_controllers(const Arguments& arguments,
                                                                         const job::Scenario& scenario);

/// What reading the documents had to leave out, for standard error; of a kind that repeats itself the first
/// few. The catalogue's own warnings are not among these.
[[nodiscard]] util::Diagnostics reading_warnings(const job::Knowledge& knowledge);

}  // namespace heed::cli
