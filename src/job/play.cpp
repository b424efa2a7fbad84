#include "play_parts.h"
#include "verified.h"

#include <heed/awareness/explain.h>
#include <heed/job/play.h>
#include <heed/job/version.h>
#include <heed/owl/axiom.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::job {
namespace {

void refuse(const Scenario& scenario, const World& world) {
  if (!world.plant.deterministic())
    throw util::InputError(scenario.plant.path.location, "nondeterministic-plant",
                           "an action of the plant has several outcomes, and a page has nobody to choose one",
                           "heed run and heed exec take such plants");
  for (const ProfilePart& profile : scenario.profiles)
    if (profile.spec.cells > play_cell_limit)
      throw util::InputError(profile.spec.location, "too-many-cells",
                             fmt::format("a page shows no way of {} cells", profile.spec.cells),
                             fmt::format("at most {}", play_cell_limit));
}

class Maker {
 public:
  Maker(const Scenario& scenario, const PlayOptions& options, util::Budget& budget)
      : scenario_(scenario), options_(options), budget_(budget) {}

  PlayResult make() {
    world_ = load_world(scenario_, budget_.limits(), budget_);
    refuse(scenario_, world_);
    for (const ControllerPart& part : scenario_.controllers) make_player(part);
    report::Play& play = result_.play;
    fill_frame();
    if (players_.empty()) return std::move(result_);
    for (const model::Variable& input : players_.front().machine.inputs) add_input(input);
    fill_play_catalogue(play, scenario_, world_);
    fill_observations();
    fill_play_candidates(play, world_, budget_);
    fill_play_profiles(play, scenario_, world_, players_.front().machine, budget_);
    std::set<owl::AxiomId> axioms;
    for (const Player& player : players_)
      play.controllers.push_back(play_controller(play, scenario_, world_, player, axioms));
    fill_axioms(axioms);
    play.approached = approached();
    return std::move(result_);
  }

 private:
  void make_player(const ControllerPart& part) {
    if (options_.progress)
      options_.progress(
          "synthesize and verify " + part.name.text,
          static_cast<double>(players_.size()) / static_cast<double>(scenario_.controllers.size()));
    Player player{&part, design(scenario_, world_, part), {}};
    check_evaluate(scenario_, world_, player.design);
    std::optional<model::Mealy> machine =
        verified_machine(scenario_, world_, part, player.design, budget_, result_.warnings);
    if (!machine) return;
    player.machine = std::move(*machine);
    players_.push_back(std::move(player));
  }

  void fill_frame() {
    report::Play& play = result_.play;
    play.scenario = scenario_.name;
    play.description = scenario_.description;
    play.versions = {{"heed", version()}};
    play.cells = scenario_.profiles.empty() ? 5 : scenario_.profiles.front().spec.cells;
    play.seed = options_.seed.value_or(play.seed);
    fill_plant();
    for (const Player& player : players_)
      if (!player.part->beside || play.subject.empty()) play.subject = player.part->name.text;
    if (!scenario_.evaluate) return;
    const EvaluatePart& evaluate = *scenario_.evaluate;
    play.thing = evaluate.thing;
    play.kind = evaluate.kind;
    if (!options_.seed) play.seed = static_cast<std::uint32_t>(evaluate.seed);
    if (evaluate.speed_wanted) play.speed = report::PlaySpeed{evaluate.cell_metres, evaluate.speed_kmh};
    play.event = evaluate.event.text;
    for (const OutcomePart& outcome : evaluate.outcomes) play.outcomes.push_back(outcome.label);
    play.rest = evaluate.rest;
    play.miss = evaluate.miss;
  }

  void fill_plant() {
    report::PlayPlant& plant = result_.play.plant;
    plant.states = world_.plant.states;
    for (const auto& [name, holds] : world_.plant.labels) {
      plant.labels.emplace_back(name, std::vector<std::size_t>{});
      for (std::size_t s = 0; s < holds.size(); ++s)
        if (holds[s]) plant.labels.back().second.push_back(s);
    }
    plant.values = world_.plant.values;
    for (const auto& [name, codes] : plant.values) {
      const auto [low, high] = std::minmax_element(codes.begin(), codes.end());
      if (plant.way.empty() && *low == 0 && *high + 1 == static_cast<std::int32_t>(result_.play.cells))
        plant.way = name;
    }
  }

  void add_input(const model::Variable& input) {
    const model::Domain& domain = input.domain;
    result_.play.inputs.push_back({input.name, domain.kind == model::Domain::Kind::Boolean, domain.low,
                                   domain.high, domain.values, input.comment});
  }

  void fill_observations() {
    std::set<std::vector<std::int32_t>> letters;
    for (const Player& player : players_)
      letters.insert(player.machine.input_letters.begin(), player.machine.input_letters.end());
    result_.play.observations.assign(letters.begin(), letters.end());
  }

  void fill_axioms(const std::set<owl::AxiomId>& ids) {
    for (const auto& axiom : awareness::axiom_texts(world_.knowledge.catalogue, {ids.begin(), ids.end()}))
      result_.play.axioms.push_back({owl::to_string(axiom.id), axiom.text,
                                     std::string(axiom.location.file_name()), axiom.location.line});
  }

  /// What the scenario says, else what a controller recognises first.
  [[nodiscard]] std::optional<std::size_t> approached() const {
    const awareness::Catalogue& catalogue = world_.knowledge.catalogue;
    const std::vector<std::size_t> leaves = play_leaves(catalogue);
    std::vector<std::size_t> wanted;
    if (scenario_.evaluate && scenario_.evaluate->approached) {
      const Word& word = *scenario_.evaluate->approached;
      wanted.push_back(catalogue.entity(awareness::Name(word.text, word.location)));
    }
    for (const Player& player : players_)
      for (const auto& recognised : player.design.recognition.entities) wanted.push_back(recognised.entity);
    for (const std::size_t entity : wanted) {
      const auto found = std::find(leaves.begin(), leaves.end(), entity);
      if (found != leaves.end()) return static_cast<std::size_t>(found - leaves.begin());
    }
    return std::nullopt;
  }

  const Scenario& scenario_;
  const PlayOptions& options_;
  util::Budget& budget_;
  PlayResult result_;
  World world_;
  std::vector<Player> players_;
};

}  // namespace

PlayResult play(const Scenario& scenario, const PlayOptions& options, util::Budget& budget) {
  return Maker(scenario, options, budget).make();
}

}  // namespace heed::job
