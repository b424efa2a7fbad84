#pragma once

#include <heed/job/controller.h>
#include <heed/job/evaluate.h>
#include <heed/job/scenario.h>
#include <heed/model/mealy.h>
#include <heed/report/play.h>
#include <heed/util/limits.h>

#include <cstddef>
#include <set>
#include <vector>

/// The parts of play(): each fills its lists of report::Play from the pipeline's values.
namespace heed::job {

/// A verified controller.
struct Player {
  const ControllerPart* part;
  Design design;
  model::Mealy machine;
};

/// What approaches: the leaves of the catalogue that can exist, by their index in it.
[[nodiscard]] std::vector<std::size_t> play_leaves(const awareness::Catalogue& catalogue);

/// Symbols, features (all of the catalogue, with its indices), entities. \pre `inputs` are filled
void fill_play_catalogue(report::Play& play, const Scenario& scenario, const World& world);

/// What each observation can be. \pre `observations` and `symbols` are filled
void fill_play_candidates(report::Play& play, const World& world, util::Budget& budget);

/// Chains of every profile for every entity. \param machine  any of the controllers
void fill_play_profiles(report::Play& play, const Scenario& scenario, const World& world,
                        const model::Mealy& machine, util::Budget& budget);

/// Tables and reasons of one controller; the axioms that it names go to \p axioms. \pre `observations` are
/// filled
[[nodiscard]] report::PlayController play_controller(const report::Play& play, const Scenario& scenario,
                                                     const World& world, const Player& player,
                                                     std::set<owl::AxiomId>& axioms);

}  // namespace heed::job
