#pragma once

#include <heed/report/drive.h>
#include <heed/util/diagnostic.h>
#include <heed/util/source.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What one `heed run` found, as plain values: whoever runs the job fills them, the writers of this room read
/// them. Texts are plain UTF-8 (the writers escape); names and labels may hold anything. Everything but
/// `Timings` depends on the input and the seed alone.
namespace heed::report {

/// A figure: `exact` is a rational such as "129691/144000" ("0" and "1" for integers) or empty where only the
/// decimal is known, then with |true - value| <= error.
struct Number {
  std::string exact{};
  double value = 0;
  double error = 0;
};

/// A file that was read. `digest` in hexadecimal, may be empty.
struct InputFile {
  std::string role;  ///< Such as "scenario", "ontology", "plant".
  std::string path;
  std::string digest{};
};

/// An axiom as the ontology states it.
struct Axiom {
  std::string id;    ///< Stable within the run, such as "a17"; formulas refer to it.
  std::string text;  ///< Such as "StopSign SubClassOf: hasMainColour some Red".
  util::Location location{};
};

/// The part of the ontology that mattered, and how large the whole is.
struct Ontology {
  std::string iri{};
  std::string file{};
  std::uint64_t axioms = 0, classes = 0, properties = 0, individuals = 0;
  std::uint64_t entities = 0, features = 0, behaviours = 0;  ///< Of the catalogue.
  std::vector<Axiom> excerpt{};  ///< Axioms behind the controllers, in the order of the file.
};

/// One formula of σ.
struct KnowledgeFormula {
  std::string id;        ///< Such as "k3".
  std::string kind;      ///< "subclass", "recognition", "prescription", "disjointness".
  std::string text;      ///< LTL, such as "G(sign & red & octagon -> stop)".
  std::string sentence;  ///< In words.
  std::vector<Axiom> axioms{};
};

struct SpecificationClause {
  std::string text;
  std::string origin;                 ///< "task", "plant", "knowledge", "perception", "binding", "lowering".
  std::vector<std::string> axioms{};  ///< Ids of axioms.
};

/// One part of the specification, such as "env_safety", with a title in words.
struct SpecificationSection {
  std::string name;
  std::string title;
  std::vector<SpecificationClause> clauses{};
};

/// Minimal evidence for one thing.
struct EvidenceRule {
  std::vector<std::string> evidence;  ///< Together they suffice, such as {"red", "octagon"}.
  std::string recognises;
  std::vector<std::string> axioms{};  ///< Ids of axioms.
};

enum class Verdict : std::uint8_t {
  Verified,     ///< Realizable, and the independent check agrees.
  Refuted,      ///< The check refuses the machine: a defect of heed.
  Unrealizable  ///< No controller exists.
};

struct Controller {
  std::string name;    ///< As in the scenario; charts and catalogue refer to it.
  std::string title;   ///< For people, such as "Perception tree".
  std::string policy;  ///< In words, such as "any two of sign, red, octagon are seen now".
  /// Shown beside the main comparison, as `tree-or-full` is: its charts do not enter the headline.
  bool beside = false;
  Verdict verdict = Verdict::Verified;
  std::uint64_t states = 0, transitions = 0, states_before_minimisation = 0;
  std::uint64_t product_states = 0, product_edges = 0;  ///< What the check looked at.
  bool relies_on_broken_justice = false;
  std::vector<std::string> assumptions{};  ///< On the environment, as formulas.
  std::vector<std::string> notes{};    ///< Such as "keeps its guarantees without the perception assumptions".
  std::vector<std::string> reasons{};  ///< Unrealizable or refuted: why, sentence by sentence.
  std::string file{};                  ///< Where the machine was written; empty when it was not.
  std::vector<EvidenceRule> evidence{};
};

struct Profile {
  std::string name;                        ///< Such as "P1"; charts and catalogue refer to it.
  std::string title;                       ///< Such as "visibility grows linearly".
  std::vector<std::string> description{};  ///< Line by line.
};

/// One outcome of a chart. The interval is around sampled / traces.
struct Bar {
  std::string label;  ///< "infeasible", "stop in 1", ...
  Number exact{};
  std::uint64_t sampled = 0;
  double low = 0, high = 0;
};

/// The outcomes of one controller under one profile; the exact figures of the bars add up to 1.
struct Chart {
  std::string profile, controller;
  std::vector<Bar> bars{};
  std::uint64_t traces = 0;  ///< 0: not sampled.
  double chi_square = 0;
  unsigned degrees_of_freedom = 0;
  double p_value = 1;
  std::optional<Number> reaction{};  ///< Expected distance of the reaction in cells, 0 where there is none.
  std::optional<Number> reaction_when_it_reacts{};  ///< The same over the runs with a reaction.
  std::optional<Number> conflict{};  ///< P(what is seen contradicts itself); where the controller can tell.
  std::optional<Number> broken{};    ///< P(an assumption on perception breaks), whatever answers then.
};

/// Driving past one thing with one controller under one profile.
struct Encounter {
  std::string profile, controller;
  Number stop{};                 ///< The car stops in time.
  std::optional<Number> miss{};  ///< Only where the thing prescribes halting: it does not.
  std::optional<Number>
      needless{};  ///< Only where it prescribes neither halting nor giving way: the car stops all the same.
};

/// What one controller is expected to do along a road under one profile.
struct Drive {
  std::string profile, controller;
  Number needless{}, misses{};                                             ///< How many, on the whole road.
  std::optional<Number> conflict{};                                        ///< P(somewhere on the road).
  Number no_answer{};                                                      ///< P(somewhere on the road).
  std::optional<Number> long_needless{}, long_misses{}, long_conflicts{};  ///< A thing, in the long run.
};

/// Things passed one after another.
struct Road {
  std::string name, title;
  std::string description;  ///< What stands there.
  std::uint64_t length = 0;
  std::vector<Drive> drives{};
};

/// One sign of the catalogue, or the open road (`name` empty).
struct CatalogueEntry {
  std::string name;
  std::string label;  ///< For people.
  std::string group{};
  std::vector<std::string> features{};
  std::vector<std::string> behaviours{};  ///< Prescribed, inherited ones included.
  bool prescribes_halt = false;
  bool prescribes_give_way = false;
  std::vector<Encounter> encounters{};
};

/// "Stop in n": how hard the car brakes when it learns of the sign with n cells to go.
struct SpeedCurve {
  struct Point {
    double metres_to_sign;
    double kmh;
  };
  std::string label;                  ///< Such as "stop in 3".
  unsigned cells = 0;                 ///< n.
  double deceleration = 0;            ///< m/s^2.
  std::vector<std::string> states{};  ///< The plant's states on the way, such as M0 M4 M3 S2 S1 S0.
  std::vector<Point> points{};        ///< From the horizon to the sign.
};

struct SpeedPicture {
  double cell_metres = 10;
  double speed_kmh = 50;
  unsigned horizon_cells = 4;
  std::vector<SpeedCurve> curves{};
};

/// One policy under one profile at one level of noise.
struct TunedPolicy {
  std::string policy, profile;
  std::string noise = "0";   ///< "1/20"
  std::string controller{};  ///< The controller of the run that is this policy; may be empty.
  Number miss{}, needless{}, distance{};
  std::optional<Number> braking{}, hardest{};  ///< m/s^2, mean and largest; where the machine brakes.
  bool on_front = false;                       ///< Nothing beats it.
};

/// Policies side by side.
struct Tuning {
  std::vector<TunedPolicy> figures{};   ///< By profile, noise, misses.
  std::vector<std::string> left_out{};  ///< Policies without figures, with the reason.
  std::string bound{};                  ///< On needless reactions, "1/10"; empty: none.
  std::string best{};                   ///< The policy with the fewest misses within it; empty: none.
  std::uint64_t things = 0;             ///< That a needless reaction is the mean over.
  bool whole = false;                   ///< All policies that there are, not only the simple ones.
};

struct Version {
  std::string name;
  std::string version;
};

/// What depends on the machine and the hour: the only part that differs between two runs.
struct Timings {
  struct Stage {
    std::string name;
    double seconds;
  };
  std::vector<Stage> stages{};
  double cpu_seconds = 0;
  double wall_seconds = 0;
  std::uint64_t peak_bytes = 0;  ///< 0: unknown.
};

struct RunResult {
  std::string scenario;                 ///< Name of the job.
  std::string description{};            ///< One or two sentences; may be empty.
  std::string command{};                ///< How to repeat it.
  std::vector<std::string> headline{};  ///< The answer; see headline_of().
  /// The controller that the headline is about; empty: the verified one with the fewest misses on average.
  std::string subject{};
  std::string miss_label = "infeasible";  ///< The bar that counts as a miss.
  std::string thing = "the stop sign";    ///< What is to be detected, with its article.
  std::string kind = "sign";              ///< What the things of the catalogue are called, in the singular.
  std::vector<InputFile> inputs{};
  Ontology ontology{};
  std::vector<KnowledgeFormula> knowledge{};
  std::vector<SpecificationSection> specification{};
  util::Diagnostics warnings{};
  std::vector<Controller> controllers{};
  std::vector<Profile> profiles{};
  std::vector<Chart> charts{};
  std::vector<CatalogueEntry> catalogue{};
  std::vector<Road> roads{};
  /// The car's way past the sign without a stop, such as M0 M4 M3 M2 M1 M0.
  std::vector<std::string> road{};
  SpeedPicture speed{};
  Tuning tuning{};                       ///< Empty: no policies were compared.
  std::optional<DriveResult> driving{};  ///< In a simulator of traffic; none: not asked for.
  std::uint64_t seed = 0;
  double confidence = 0.95;           ///< Of the intervals.
  std::string interval = "Wilson";    ///< Their kind.
  std::vector<std::string> method{};  ///< What is assumed and how it was computed, sentence by sentence.
  std::vector<Version> versions{};
  Timings timings{};
};

/// The answer in sentences, from the charts, verdicts and catalogue alone. Deterministic; empty where there
/// is nothing to say. O(size of the result).
[[nodiscard]] std::vector<std::string> headline_of(const RunResult& result);

/// "Stop in n" for n = 1 ... \p horizon_cells: constant speed up to the cell where the sign becomes known,
/// then constant deceleration v^2 / (2 n cell) to rest at the sign. States are left empty. \pre cell_metres >
/// 0, speed_kmh >= 0
[[nodiscard]] SpeedPicture speed_picture(double cell_metres, double speed_kmh, unsigned horizon_cells);

}  // namespace heed::report
