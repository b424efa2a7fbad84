#include "assumed.h"
#include "describe.h"
#include "plant_values.h"
#include "staging.h"

#include <heed/job/clashes.h>
#include <heed/job/drive.h>
#include <heed/job/evaluate.h>
#include <heed/job/road.h>
#include <heed/job/run.h>
#include <heed/job/tune.h>
#include <heed/job/version.h>
#include <heed/report/write.h>
#include <heed/sim/statistics.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <map>
#include <utility>

namespace heed::job {
namespace {

/// Wall time per stage, for the one place of the report that may differ from run to run.
class Stages {
 public:
  Stages(report::Timings& timings, const util::Progress& progress) : timings_(timings), progress_(progress) {}
  template <class Work>
  auto operator()(const std::string& name, double done, Work work) {
    if (progress_) progress_(name, done);
    const auto start = std::chrono::steady_clock::now();
    const auto note = [&] {
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const auto same = std::find_if(timings_.stages.begin(), timings_.stages.end(),
                                     [&](const auto& stage) { return stage.name == name; });
      if (same == timings_.stages.end())
        timings_.stages.push_back({name, seconds});
      else
        same->seconds += seconds;
    };
    auto result = work();
    note();
    return result;
  }

 private:
  report::Timings& timings_;
  const util::Progress& progress_;
};

/// One controller of the scenario on its way through the job.
struct Candidate {
  const ControllerPart* part;
  Design design;
  Synthesized done;
  std::optional<model::Mealy> machine;  ///< Read back from disk.
  std::optional<sim::Judge> judge;      ///< Of the machine, with runs that never react apart.
};

std::string probability_text(const sim::Figure& p) {
  return p.exact ? sim::decimal(*p.exact, 6) : fmt::format("{:.6f}", p.value);
}

/// Roads and conflicts take the whole chain of a profile, which lumping does without: nothing where it is too
/// large.
template <class Found, class Work>
std::optional<Found> within_size(const Work& work) {
  try {
    return work();
  } catch (const util::LimitExceeded& limit) {
    if (limit.kind() != util::LimitExceeded::Kind::Size) throw;
    return std::nullopt;
  }
}

class Job {
 public:
  Job(const Scenario& scenario, const RunOptions& options, util::Budget& budget)
      : scenario_(scenario),
        options_(options),
        budget_(budget),
        staging_(options.output),
        stages_(result_.timings, options.progress),
        approaches_(world_, budget) {}

  report::RunResult run() {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    world_ =
        stages_("read and classify", 0, [&] { return load_world(scenario_, budget_.limits(), budget_); });
    check_roads(scenario_, world_);
    fill_frame();
    add_notes(impossible_values(scenario_, world_.plant));
    for (const ControllerPart& part : scenario_.controllers) make_controller(part);
    describe_knowledge();
    if (scenario_.evaluate && !scenario_.profiles.empty()) evaluate_all();
    if (options_.drive) stages_("drive in traffic", 0.97, [&] { return drive_in_traffic(), 0; });
    result_.headline = report::headline_of(result_);
    result_.timings.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result_.timings.cpu_seconds = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    result_.timings.peak_bytes = util::peak_resident_bytes();
    staging_.write("report.html", report::to_html(result_));
    staging_.write("report.json", report::to_json(result_));
    staging_.commit();
    return std::move(result_);
  }

 private:
  void fill_frame() {
    result_.scenario = scenario_.name;
    result_.description = scenario_.description;
    result_.command = options_.command;
    result_.inputs = {{"scenario", scenario_.path}, {"ontology", scenario_.knowledge.ontology.text}};
    if (!scenario_.plant.path.text.empty()) result_.inputs.push_back({"plant", scenario_.plant.path.text});
    result_.warnings = world_.knowledge.diagnostics;
    for (const util::Diagnostic& note : world_.perception.notes) result_.warnings.push_back(note);
    result_.versions = {{"heed", version()}};
    result_.method = describe_method(scenario_, world_, 0, 0);
    if (!scenario_.evaluate) return;
    result_.thing = scenario_.evaluate->thing;
    result_.kind = scenario_.evaluate->kind;
    result_.miss_label = scenario_.evaluate->outcomes[scenario_.evaluate->miss].label;
    result_.seed = options_.seed.value_or(scenario_.evaluate->seed);
    result_.confidence = scenario_.evaluate->confidence;
    result_.method = describe_method(scenario_, world_, options_.traces.value_or(scenario_.evaluate->traces),
                                     result_.seed);
  }

  [[nodiscard]] double progress_of(std::size_t controller) const {
    return 0.1 + 0.5 * static_cast<double>(controller) / static_cast<double>(scenario_.controllers.size());
  }

  void make_controller(const ControllerPart& part) {
    Candidate candidate{&part, {}, {}, std::nullopt, std::nullopt};
    const double progress = progress_of(candidates_.size());
    candidate.design = stages_("compose", progress, [&] { return design(scenario_, world_, part); });
    check_evaluate(scenario_, world_, candidate.design);
    add_notes(settle_clashes(scenario_, world_, candidate.design, budget_));
    candidate.done = stages_("synthesize and verify " + part.name.text, progress, [&] {
      return synthesize(candidate.design, scenario_.perception.on_violation, budget_);
    });
    report::Controller described = describe_controller(world_, part, candidate.design, candidate.done);
    staging_.write(part.name.text + ".gr1", spec::write_gr1(candidate.design.composed.spec));
    if (described.verdict == report::Verdict::Verified) {
      described.file = part.name.text + ".controller.json";
      const std::string path =
          staging_.write(described.file, model::write_mealy(*candidate.done.result.machine));
      candidate.machine = read_back(path);
      candidate.done.result.machine.reset();
    } else {
      staging_.discard(part.name.text + ".controller.json");
    }
    add_notes(candidate.design.recognition.notes);
    add_notes(candidate.design.composed.notes);
    result_.controllers.push_back(std::move(described));
    candidates_.push_back(std::move(candidate));
  }

  /// The file is heed's own: the limit for inputs does not apply.
  [[nodiscard]] model::Mealy read_back(const std::string& path) const {
    util::Limits limits = budget_.limits();
    limits.input_bytes = 0;
    return model::read_mealy(util::read_file(path, limits), limits);
  }

  /// Several controllers say the same of the same plant; once is enough.
  void add_notes(const util::Diagnostics& notes) {
    for (const util::Diagnostic& note : notes) {
      const bool known = std::any_of(result_.warnings.begin(), result_.warnings.end(), [&](const auto& w) {
        return w.code == note.code && w.message == note.message;
      });
      if (!known) result_.warnings.push_back(note);
    }
  }

  /// The controller that the report is about: the last of the main comparison.
  [[nodiscard]] const Candidate& subject() const {
    for (auto it = candidates_.rbegin(); it != candidates_.rend(); ++it)
      if (!it->part->beside && it->machine) return *it;
    return candidates_.back();
  }

  void describe_knowledge() {
    std::vector<const Design*> designs;
    for (const Candidate& candidate : candidates_) designs.push_back(&candidate.design);
    result_.ontology = describe_ontology(scenario_, world_, designs);
    result_.knowledge = describe_sigma(world_, subject().design);
    result_.specification = describe_specification(subject().design.composed.spec);
    result_.subject = subject().part->name.text;
  }

  [[nodiscard]] std::size_t approached() const {
    const awareness::Catalogue& catalogue = world_.knowledge.catalogue;
    if (const auto& word = scenario_.evaluate->approached)
      return catalogue.entity(awareness::Name(word->text, word->location));
    for (const auto& recognised : subject().design.recognition.entities)
      if (catalogue.entities[recognised.entity].is_leaf()) return recognised.entity;
    return 0;
  }

  void evaluate_all() {
    const std::size_t entity = approached();
    for (const ProfilePart& profile : scenario_.profiles) {
      result_.profiles.push_back({profile.spec.name, profile.title, profile.description});
      for (const Candidate& candidate : candidates_)
        if (candidate.machine)
          result_.charts.push_back(
              stages_("evaluate", 0.6, [&] { return chart(profile, candidate, entity); }));
    }
    stages_("drive past the catalogue", 0.8, [&] { return drive_past_everything(), 0; });
    for (const RoadPart& road : scenario_.roads)
      stages_("drive along roads", 0.9, [&] { return drive_along(road), 0; });
    if (scenario_.tune && !result_.charts.empty())
      stages_("compare policies", 0.95, [&] { return compare_policies(), 0; });
    if (scenario_.evaluate->speed_wanted && !result_.charts.empty()) fill_speed(entity);
  }

  [[nodiscard]] report::Chart chart(const ProfilePart& profile, const Candidate& candidate,
                                    std::size_t entity) {
    EvaluateOptions how{options_.traces.value_or(scenario_.evaluate->traces), result_.seed, options_.threads,
                        false};
    const Evaluation found = evaluate(scenario_, world_, profile, *candidate.machine, entity, how, budget_);
    report::Chart chart{profile.spec.name, candidate.part->name.text};
    chart.traces = found.sampled.traces;
    std::vector<double> probabilities;
    for (std::size_t c = 0; c < found.categories.size(); ++c) {
      report::Bar bar{found.categories[c], number(found.figures.probability[c])};
      probabilities.push_back(bar.exact.value);
      if (chart.traces > 0) {
        bar.sampled = found.sampled.count[c];
        const sim::Interval interval = sim::wilson(bar.sampled, chart.traces, result_.confidence);
        bar.low = interval.low;
        bar.high = interval.high;
      }
      chart.bars.push_back(std::move(bar));
    }
    if (chart.traces > 0) {
      const sim::ChiSquare test = sim::chi_square(found.sampled.count, probabilities);
      chart.chi_square = test.statistic;
      chart.degrees_of_freedom = test.degrees;
      chart.p_value = test.p_value;
    }
    note_violations(profile, candidate, found.figures);
    note_assumptions(profile, candidate, entity, chart);
    const sim::ReactionDistance distance = sim::reaction_distance(found.figures);
    chart.reaction = number(distance.mean);
    if (distance.when_it_reacts) chart.reaction_when_it_reacts = number(*distance.when_it_reacts);
    chart.conflict =
        maybe(within_size<std::optional<sim::Rational>>([&] {
                return conflict_probability(scenario_, world_, profile, *candidate.machine, entity, budget_);
              }).value_or(std::nullopt));
    return chart;
  }

  void note_violations(const ProfilePart& profile, const Candidate& candidate,
                       const sim::LumpedOutcome& figures) {
    const auto note = [&](const sim::Figure& p, std::string_view what) {
      if (p.exact ? *p.exact == 0 : p.value == 0) return;
      result_.warnings.push_back(
          {util::Severity::Warning,
           profile.spec.location,
           "assumption-broken",
           fmt::format("under {} the assumptions of '{}' break with probability {}: {}", profile.spec.name,
                       candidate.part->name.text, probability_text(p), what),
           "drop the assumption, or let perception latch",
           {}});
    };
    note(figures.fallback, "the stated fallback answers");
    note(figures.missing, "there is no answer, the run ends there");
  }

  /// What is assumed may break although the controller does without it: the profile and the specification
  /// then speak of different perception.
  void note_assumptions(const ProfilePart& profile, const Candidate& candidate, std::size_t entity,
                        report::Chart& chart) {
    const ReadyApproach& ready = approaches_.ready(profile, *candidate.machine, entity);
    if (!ready.chain) return;
    const auto broken =
        assumptions_broken(candidate.design.composed.spec, ready, *candidate.machine, budget_);
    chart.broken = number(broken);
    if (broken == 0 || !candidate.done.assumptions_dropped) return;
    add_notes(
        {{util::Severity::Warning,
          profile.spec.location,
          "assumption-not-kept",
          fmt::format("on an approach under {} perception breaks what is assumed of it with probability {}; "
                      "controllers that keep their guarantees without it answer all the same",
                      profile.spec.name, sim::decimal(broken, 6)),
          "let the assumptions say what the profile does",
          {}}});
  }

  /// The leaves of the catalogue, then the open road. Things that look alike are driven past once.
  void drive_past_everything() {
    const awareness::Catalogue& catalogue = world_.knowledge.catalogue;
    for (std::size_t e = 0; e < catalogue.entities.size(); ++e) {
      if (!catalogue.entities[e].is_leaf() || !catalogue.entities[e].satisfiable) continue;
      result_.catalogue.push_back(describe_entity(scenario_, world_, e));
      drive_past(result_.catalogue.back(), e);
    }
    result_.catalogue.push_back({"", "nothing there"});
    drive_past(result_.catalogue.back(), std::nullopt);
  }

  void drive_past(report::CatalogueEntry& entry, Thing thing) {
    for (const ProfilePart& profile : scenario_.profiles)
      for (Candidate& candidate : candidates_)
        if (candidate.machine)
          entry.encounters.push_back(
              encounter(profile, candidate, entry, past_figures(profile, candidate, thing)));
  }

  const sim::LumpedOutcome& past_figures(const ProfilePart& profile, Candidate& candidate, Thing thing) {
    const ReadyApproach& ready = approaches_.ready(profile, *candidate.machine, thing);
    const auto [found, added] =
        past_.try_emplace(std::pair<const ReadyApproach*, const Candidate*>(&ready, &candidate));
    if (!added) return found->second;
    if (!candidate.judge) candidate.judge = make_judge(scenario_, world_, *candidate.machine, true);
    return found->second = exact_figures(ready, *candidate.machine, *candidate.judge, budget_);
  }

  [[nodiscard]] report::Encounter encounter(const ProfilePart& profile, const Candidate& candidate,
                                            const report::CatalogueEntry& entry,
                                            const sim::LumpedOutcome& figures) const {
    const sim::Figure never = figures.probability.back();
    const sim::Figure missed = figures.probability[scenario_.evaluate->miss] + never;
    report::Encounter encounter{profile.spec.name, candidate.part->name.text, number(complement(missed))};
    if (entry.prescribes_halt) encounter.miss = number(missed);
    if (!entry.prescribes_halt && !entry.prescribes_give_way)
      encounter.needless = number(complement(never + figures.undefined));
    return encounter;
  }

  static std::optional<report::Number> maybe(const std::optional<sim::Rational>& value) {
    return value ? std::optional(number(*value)) : std::nullopt;
  }

  void note_road_too_large(const RoadPart& road, const ProfilePart& profile) {
    add_notes(
        {{util::Severity::Warning,
          road.name.location,
          "road-too-large",
          fmt::format(
              "the road '{}' is not driven under {}: that takes the profile's whole chain, which is too "
              "large",
              road.name.text, profile.spec.name),
          "fewer features, or fewer cells",
          {}}});
  }

  void drive_along(const RoadPart& road) {
    report::Road described{road.name.text, road.title, describe_road(world_, road), road.length};
    for (const ProfilePart& profile : scenario_.profiles)
      for (const Candidate& candidate : candidates_) {
        if (!candidate.machine) continue;
        const auto driven = within_size<RoadEvaluation>([&] {
          return evaluate_road(scenario_, world_, profile, road, *candidate.machine, approaches_, budget_);
        });
        if (!driven) {
          note_road_too_large(road, profile);
          continue;
        }
        const RoadEvaluation& found = *driven;
        report::Drive drive{profile.spec.name, candidate.part->name.text, number(found.needless),
                            number(found.misses)};
        drive.conflict = maybe(found.conflict);
        drive.no_answer = number(found.missing);
        if (found.long_run) {
          drive.long_needless = number(found.long_run->needless);
          drive.long_misses = number(found.long_run->misses);
          drive.long_conflicts = maybe(found.long_run->conflicts);
        }
        described.drives.push_back(std::move(drive));
      }
    if (!described.drives.empty()) result_.roads.push_back(std::move(described));
  }

  void drive_in_traffic() {
    DriveOptions options;
    options.command = "heed drive " + scenario_.path;
    options.seed = options_.seed;
    Driven driven = drive(scenario_, options, budget_);
    if (!driven.result.runs.empty()) result_.driving = std::move(driven.result);
  }

  void compare_policies() {
    TuneOptions options = tune_options(scenario_);
    options.simple = true;
    const auto tuning =
        within_size<Tuning>([&] { return std::optional(tune(scenario_, world_, options, budget_)); });
    if (tuning) {
      result_.tuning = describe_tuning(scenario_, *tuning, options);
      return;
    }
    add_notes({{util::Severity::Warning,
                {},
                "policies-too-large",
                "no policies are compared: under some profile that is too large",
                "fewer features, or no [tune]",
                {}}});
  }

  void fill_speed(std::size_t entity) {
    const ProfilePart& profile = scenario_.profiles.front();
    const std::uint32_t cells = profile.spec.cells;
    result_.speed =
        report::speed_picture(scenario_.evaluate->cell_metres, scenario_.evaluate->speed_kmh, cells - 1);
    if (!subject().machine) return;
    const model::Mealy& machine = *subject().machine;
    result_.road = states_on_the_way(world_, profile, machine, std::nullopt, cells);
    for (report::SpeedCurve& curve : result_.speed.curves)
      curve.states = states_on_the_way(world_, profile, machine, entity, cells - 1 - curve.cells);
  }

  const Scenario& scenario_;
  const RunOptions& options_;
  util::Budget& budget_;
  Staging staging_;
  report::RunResult result_;
  Stages stages_;
  World world_;
  Approaches approaches_;
  std::map<std::pair<const ReadyApproach*, const Candidate*>, sim::LumpedOutcome> past_;  ///< Only looked up.
  std::vector<Candidate> candidates_;
};

}  // namespace

report::RunResult run(const Scenario& scenario, const RunOptions& options, util::Budget& budget) {
  return Job(scenario, options, budget).run();
}

}  // namespace heed::job
