#include "staging.h"
#include "verified.h"

#include <heed/job/drive.h>
#include <heed/job/evaluate.h>
#include <heed/job/version.h>
#include <heed/sim/sample.h>
#include <heed/sim/traffic.h>
#include <heed/spec/compose.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace heed::job {
namespace {

/// SUMO's cost for a step grows faster than the number of its cars.
constexpr std::uint32_t roads_at_once = 1000;
/// Where pictures of a car's way end, in metres behind the line.
constexpr double shown_behind = 20;

/// What each transition of a machine means on the road.
std::vector<sim::Manoeuvre> manoeuvres_of(const Scenario& scenario, const World& world,
                                          const model::Mealy& machine) {
  const DrivePart& drive = scenario.drive;
  std::vector<logic::Formula> formulas{drive.stop ? drive.stop->formula : scenario.evaluate->event.formula};
  for (const SpeedLevelPart& level : drive.slow) formulas.push_back(level.when.formula);
  std::vector<std::string> plant_names;
  for (const auto& [name, states] : world.plant.labels) plant_names.push_back(name);
  for (const auto& [name, values] : world.plant.values) plant_names.push_back(name);
  for (logic::Formula& formula : formulas)
    formula = spec::expand_plant(world.perception.over_inputs(formula), world.plant);
  const auto holds = hold_at_transitions(formulas, machine, plant_names);
  std::vector<sim::Manoeuvre> result(machine.transitions.size());
  for (std::size_t t = 0; t < result.size(); ++t) {
    if (holds[0][t]) {
      result[t].kind = sim::Manoeuvre::Kind::Stop;
      continue;
    }
    for (std::size_t level = 0; level < drive.slow.size(); ++level)
      if (holds[level + 1][t]) {
        result[t] = {sim::Manoeuvre::Kind::Slow, drive.slow[level].speed};
        break;
      }
  }
  return result;
}

/// One controller in as many cars as there are roads: each reads its own trace, cell by cell.
class Crew {
 public:
  Crew(const sim::Run& run, std::vector<sim::Manoeuvre> manoeuvres)
      : run_(run), manoeuvres_(std::move(manoeuvres)) {}

  struct Seat {
    std::vector<std::uint64_t> seen;  ///< Per cell.
    std::uint32_t state = 0, category = sim::Judge::none;
    std::optional<std::uint32_t> cells_left;
    bool lost = false;  ///< The machine had no answer.
    sim::Manoeuvre manoeuvre;
  };

  void board(const sim::Sampler& sampler, std::uint64_t seed, const sim::RoadBatch& batch) {
    seats_.assign(batch.count, {});
    for (std::uint32_t road = 0; road < batch.count; ++road) {
      seats_[road].seen = sampler.trace(seed, batch.first + road);
      read(seats_[road], run_.binding.blank, std::nullopt);
      seats_[road].manoeuvre = {};  // nothing is commanded before the horizon
    }
  }

  sim::Manoeuvre decide(std::uint32_t road, std::uint32_t cell) {
    Seat& seat = seats_[road];
    model::Valuation observation = run_.binding.blank;
    for (const sim::Binding::Wire& wire : run_.binding.wires)
      if ((seat.seen[cell] >> wire.feature & 1) != 0) observation[wire.input] = wire.value;
    read(seat, observation, static_cast<std::uint32_t>(seat.seen.size() - 1 - cell));
    return seat.manoeuvre;
  }

  /// \returns an index into the judge's categories, or one past them where there was no answer.
  [[nodiscard]] std::size_t outcome(std::uint32_t road) const {
    const Seat& seat = seats_[road];
    if (seat.category != sim::Judge::none) return seat.category;
    return seat.lost ? run_.judge.categories.size() : run_.judge.never;
  }
  [[nodiscard]] std::optional<std::uint32_t> cells_left(std::uint32_t road) const {
    return seats_[road].cells_left;
  }

 private:
  void read(Seat& seat, const model::Valuation& observation, std::optional<std::uint32_t> cells_left) {
    if (seat.lost) return;
    const auto letter = run_.machine.input_letter(observation);
    const auto* row = letter ? run_.machine.find(seat.state, *letter) : nullptr;
    if (row == nullptr) {
      seat.lost = true;
      return;
    }
    const auto transition = static_cast<std::size_t>(row - run_.machine.transitions.data());
    seat.state = row->next;
    seat.manoeuvre = manoeuvres_[transition];
    if (seat.category != sim::Judge::none || run_.judge.event[transition] == sim::Judge::none) return;
    seat.category = run_.judge.event[transition];
    seat.cells_left = cells_left;
  }

  sim::Run run_;
  std::vector<sim::Manoeuvre> manoeuvres_;
  std::vector<Seat> seats_;
};

report::DriveRoad describe(const sim::RoadMeasure& measure) {
  report::DriveRoad road;
  road.overshoot = measure.overshoot;
  road.line_speed = measure.line_speed;
  road.peak_deceleration = measure.peak_deceleration;
  road.peak_jerk = measure.peak_jerk;
  road.time_lost = measure.time_lost;
  road.least_gap = measure.least_gap;
  road.least_time = measure.least_time;
  road.follower_deceleration = measure.follower_deceleration;
  road.collision = measure.collision;
  road.conflict = measure.conflict;
  return road;
}

/// Up to the halt, or a little behind the line.
std::vector<report::DrivePoint> points_of(const sim::Trajectory& trajectory) {
  std::vector<report::DrivePoint> points;
  for (std::size_t time = 0; time < trajectory.times(); ++time) {
    const sim::CarState& state = trajectory.at(time);
    points.push_back({state.position, state.speed * 3.6});
    if (state.speed <= 1e-3 || state.position > shown_behind) break;
  }
  return points;
}

template <class Part>
std::vector<const Part*> chosen(const std::vector<Part>& parts, const std::vector<std::string>& names,
                                const std::string& kind, std::string (*name_of)(const Part&)) {
  std::vector<std::string> known;
  for (const Part& part : parts) known.push_back(name_of(part));
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw util::InputError(util::Location{}, "unknown-name",
                             fmt::format("the scenario has no {} '{}'", kind, name),
                             util::suggestion(name, known));
  std::vector<const Part*> result;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (names.empty() || std::find(names.begin(), names.end(), known[i]) != names.end())
      result.push_back(&parts[i]);
  return result;
}

class Driver {
 public:
  Driver(const Scenario& scenario, const DriveOptions& options, util::Budget& budget)
      : scenario_(scenario), options_(options), budget_(budget) {}

  Driven drive() {
    if (!scenario_.evaluate || scenario_.profiles.empty())
      throw util::InputError(util::Location{}, "missing-key",
                             "the scenario has no [[profile]] and [evaluate]",
                             "they say what is seen and what counts");
    if (!scenario_.drive.wanted)
      throw util::InputError(util::Location{}, "no-road",
                             "the scenario does not say that its machine drives on a road, nor how fast",
                             "add [drive] with cell_metres and speed_kmh (docs/formats/drive.md)");
    parts_ = chosen<ControllerPart>(scenario_.controllers, options_.controllers, "controller",
                                    [](const ControllerPart& part) { return part.name.text; });
    profiles_ = chosen<ProfilePart>(scenario_.profiles, options_.profiles, "profile",
                                    [](const ProfilePart& part) { return part.spec.name; });
    engine_ = sim::load_sumo(options_.sumo);
    world_ = load_world(scenario_, budget_.limits(), budget_);
    thing_ = find_thing();
    fill_frame();
    for (const ControllerPart* part : parts_) make_machine(*part);
    for (const ProfilePart* profile : profiles_)
      for (const model::Mealy& machine : machines_) drive_profile(*profile, machine);
    order_traces();
    write();
    return std::move(driven_);
  }

 private:
  [[nodiscard]] Thing find_thing() const {
    const awareness::Catalogue& catalogue = world_.knowledge.catalogue;
    if (options_.thing == "none") return std::nullopt;
    if (options_.thing) return catalogue.entity(*options_.thing);
    const auto& approached = scenario_.evaluate->approached;
    if (!approached)
      throw util::InputError(util::Location{}, "missing-key", "what stands on the road?",
                             "name it with --thing, or as 'approached' in [evaluate]");
    return catalogue.entity(awareness::Name(approached->text, approached->location));
  }

  void fill_frame() {
    report::DriveResult& result = driven_.result;
    const sim::RoadSetting& setting = scenario_.drive.setting;
    result.scenario = scenario_.name;
    result.command = options_.command;
    result.thing = thing_ ? world_.knowledge.catalogue.entities[*thing_].label : "nothing";
    result.seed = options_.seed.value_or(scenario_.drive.seed.value_or(scenario_.evaluate->seed));
    result.roads = options_.roads.value_or(scenario_.drive.roads);
    result.cell_metres = setting.cell;
    result.speed_kmh = setting.speed * 3.6;
    result.most_deceleration = setting.most_deceleration;
    result.conflict_seconds = setting.conflict_seconds;
    result.followers = setting.followers;
    result.cells = 0;
    for (const ProfilePart* profile : profiles_) {
      result.cells = std::max(result.cells, profile->spec.cells);
      result.profiles.push_back({profile->spec.name, profile->title});
    }
    fill_setting();
    for (const OutcomePart& outcome : scenario_.evaluate->outcomes) result.outcomes.push_back(outcome.label);
    result.outcomes.emplace_back("no answer");
    result.miss = scenario_.evaluate->miss;
    result.versions = {{"heed", version()}, {"simulator", engine_->version()}};
  }

  void fill_setting() {
    const sim::RoadSetting& setting = scenario_.drive.setting;
    auto& out = driven_.result.setting;
    out = {{"cell_metres", setting.cell},
           {"speed_kmh", setting.speed * 3.6},
           {"step_seconds", setting.step},
           {"most_deceleration", setting.most_deceleration},
           {"comfortable_deceleration", setting.comfortable_deceleration},
           {"acceleration", setting.acceleration},
           {"brake_seconds", setting.brake_seconds},
           {"halt_seconds", setting.halt_seconds},
           {"followers", setting.followers},
           {"shortest_headway_seconds", setting.shortest_headway},
           {"longest_headway_seconds", setting.longest_headway},
           {"follower_deceleration", setting.follower_deceleration},
           {"shortest_reaction_seconds", setting.shortest_reaction},
           {"longest_reaction_seconds", setting.longest_reaction},
           {"conflict_seconds", setting.conflict_seconds},
           {"jerk_seconds", setting.jerk_seconds}};
  }

  void progress(const std::string& stage, double done) const {
    if (options_.progress) options_.progress(stage, done);
  }

  /// What is judged, and what [drive] asks of a step: each as an event would be.
  void check_formulas(const Design& designed) const {
    check_evaluate(scenario_, world_, designed);
    std::vector<WrittenFormula> asked;
    if (scenario_.drive.stop) asked.push_back(*scenario_.drive.stop);
    for (const SpeedLevelPart& level : scenario_.drive.slow) asked.push_back(level.when);
    Scenario as_event = scenario_;
    for (const WrittenFormula& formula : asked) {
      as_event.evaluate->event = formula;
      check_evaluate(as_event, world_, designed);
    }
  }

  void make_machine(const ControllerPart& part) {
    progress("synthesize and verify " + part.name.text, 0);
    const Design designed = design(scenario_, world_, part);
    check_formulas(designed);
    std::optional<model::Mealy> machine =
        verified_machine(scenario_, world_, part, designed, budget_, driven_.warnings);
    if (!machine) return;
    machines_.push_back(std::move(*machine));
    driven_.result.controllers.push_back({part.name.text, part.title, part.beside});
  }

  void drive_profile(const ProfilePart& profile, const model::Mealy& machine) {
    const Approach road = approach(profile, world_, machine, thing_, budget_);
    const sim::Judge judge = make_judge(scenario_, world_, machine, false);
    const sim::Run run{road.chain, machine, road.binding, judge};
    const sim::Sampler sampler(run, budget_);
    Crew crew(run, manoeuvres_of(scenario_, world_, machine));
    report::DriveResult& result = driven_.result;
    report::DriveRun out{profile.spec.name, machine.name, {}};
    sim::RoadSetting setting = scenario_.drive.setting;
    setting.cells = profile.spec.cells;
    const double all = static_cast<double>(profiles_.size() * machines_.size());
    for (sim::RoadBatch batch{result.seed, 0, 0}; batch.first < result.roads; batch.first += batch.count) {
      batch.count =
          static_cast<std::uint32_t>(std::min<std::uint64_t>(roads_at_once, result.roads - batch.first));
      progress(fmt::format("drive {} under {}", machine.name, profile.spec.name),
               static_cast<double>(result.runs.size()) / all);
      crew.board(sampler, result.seed, batch);
      const auto driven = drive_batch(setting, batch, crew);
      for (std::uint32_t i = 0; i < batch.count; ++i) {
        report::DriveRoad one = describe(sim::measure(driven[i], setting));
        one.road = batch.first + i;
        one.outcome = crew.outcome(i);
        one.cells_left = crew.cells_left(i);
        keep_trace(out, one, driven[i]);
        out.roads.push_back(one);
      }
    }
    result.runs.push_back(std::move(out));
  }

  std::vector<sim::Trajectory> drive_batch(const sim::RoadSetting& setting, const sim::RoadBatch& batch,
                                           Crew& crew) {
    const auto decide = [&](std::uint32_t road, std::uint32_t cell) { return crew.decide(road, cell); };
    try {
      return sim::drive_roads(*engine_, setting, batch, decide, budget_);
    } catch (const sim::TrafficError& error) {
      throw util::InputError(util::Location{}, "simulator", error.what(),
                             "it needs a temporary folder that it can write to (TMPDIR)");
    }
  }

  /// The first road of each way to end, of each controller.
  void keep_trace(const report::DriveRun& run, const report::DriveRoad& road,
                  const sim::Trajectory& trajectory) {
    if (!shown_.emplace(run.controller, road.outcome, road.cells_left.value_or(UINT32_MAX)).second) return;
    driven_.result.traces.push_back(
        {run.profile, run.controller, road.road, road.outcome, road.cells_left, points_of(trajectory)});
  }

  void order_traces() {
    const auto& controllers = driven_.result.controllers;
    const auto rank = [&](const report::DriveTrace& trace) {
      const auto found = std::find_if(controllers.begin(), controllers.end(),
                                      [&](const auto& c) { return c.name == trace.controller; });
      return std::pair(found - controllers.begin(),
                       -static_cast<std::int64_t>(trace.cells_left.value_or(0)) - (trace.cells_left ? 1 : 0));
    };
    std::stable_sort(driven_.result.traces.begin(), driven_.result.traces.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  }

  void write() const {
    if (options_.output.empty()) return;
    const report::DriveResult& result = driven_.result;
    Staging staging(options_.output);
    staging.write("drive.csv", report::to_csv(result));
    staging.write("drive-summary.csv", report::summary_csv(result));
    staging.write("drive.json", report::to_json(result));
    staging.write("drive-speed.svg", report::speed_svg(result));
    staging.write("drive-braking.svg", report::braking_svg(result));
    staging.write("drive-metres.svg", report::metres_svg(result));
    staging.commit();
  }

  const Scenario& scenario_;
  const DriveOptions& options_;
  util::Budget& budget_;
  std::unique_ptr<sim::TrafficEngine> engine_;
  World world_;
  Thing thing_;
  std::vector<const ControllerPart*> parts_;
  std::vector<const ProfilePart*> profiles_;
  std::vector<model::Mealy> machines_;
  std::set<std::tuple<std::string, std::size_t, std::uint32_t>> shown_;
  Driven driven_;
};

}  // namespace

Driven drive(const Scenario& scenario, const DriveOptions& options, util::Budget& budget) {
  return Driver(scenario, options, budget).drive();
}

}  // namespace heed::job
