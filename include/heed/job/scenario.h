#pragma once

#include <heed/logic/formula.h>
#include <heed/sim/profile.h>
#include <heed/sim/traffic.h>
#include <heed/strategy/synthesize.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace heed::job {

/// A word or text of the scenario and where it stands there.
struct Word {
  std::string text;
  util::Location location;
};

/// A formula and how the user wrote it.
struct WrittenFormula {
  logic::Formula formula;
  std::string text;
};

struct KnowledgePart {
  Word ontology;  ///< Path, already relative to the working folder.
  std::vector<Word> entities, features, behaviours, feature_roles, action_roles;
  std::optional<Word> subclass_role;
  bool sufficient = false;
  std::vector<Word> sufficient_entities;
  std::string language = "en";
  std::vector<std::pair<std::string, std::string>> imports;
  bool allow_missing_imports = false, allow_unsatisfiable = false, allow_left_out = false;
};

struct InputPart {
  Word what;
  std::string name;  ///< Empty: the catalogue's.
  bool whole = false;
  bool excluded = false;  ///< That it is missing is reported as well.
};

/// What answers an observation that breaks an assumption on perception.
enum class Violation : std::uint8_t { Drop, Latch, Undefined };

struct PerceptionPart {
  std::vector<InputPart> inputs;  ///< Empty: everything.
  bool enumerate = true;
  std::optional<WrittenFormula> persistent;
  std::vector<WrittenFormula> assume;
  bool blank_first = true;
  std::string full_view;  ///< Empty: none.
  Violation on_violation = Violation::Drop;
};

struct PlantPart {
  Word path;  ///< Empty: `text` is the plant.
  util::SourceText text;
  std::vector<Word> initial;
};

struct BindingPart {
  Word behaviour;
  WrittenFormula effect;
};

struct ControllerPart {
  Word name;
  std::string title;
  Word policy;
  std::vector<Word> entities, over, order;
  std::size_t k = 2;
  bool latch = false, beside = false;
  std::optional<bool> direct;
  std::optional<Word> behaviours;  ///< "cautious", "common", "brave".
  bool closed = false;
  std::vector<Word> fallback;
};

struct ProfilePart {
  std::string title;
  std::vector<std::string> description;  ///< The rules as written, one line each.
  sim::ProfileSpec spec;
};

struct OutcomePart {
  std::string label;
  std::optional<WrittenFormula> when;
};

/// What stands at one place of a road, and how likely.
struct RoadShare {
  Word thing;  ///< An entity, "none", or "any": each leaf of the catalogue with the same probability.
  sim::Rational probability;
};

/// A road that is driven along: one thing after another.
struct RoadPart {
  Word name;
  std::string title;
  std::vector<std::vector<RoadShare>> places;  ///< One round; a longer road begins again.
  std::uint32_t length = 0;                    ///< Places altogether.
};

struct EvaluatePart {
  WrittenFormula event;
  std::optional<WrittenFormula> conflict;
  std::vector<OutcomePart> outcomes;
  std::size_t rest = 0;  ///< The outcome without `when`.
  std::size_t miss = 0;
  std::string thing = "the thing", kind = "thing";
  std::optional<Word> approached;
  std::uint64_t traces = 10'000, seed = 1;
  double confidence = 0.95;
  std::vector<Word> must_react, may_react;
  double cell_metres = 10, speed_kmh = 50;
  bool speed_wanted = false;  ///< Where one of the two is given: the machine is one that brakes on a road.
};

/// Whether other policies are compared in the report, and by what.
struct TunePart {
  std::optional<sim::Rational> most_needless;
  std::vector<sim::Rational> noise{0};
};

/// A slower speed, and when it is kept.
struct SpeedLevelPart {
  WrittenFormula when;
  double speed = 0;  ///< m/s.
};

/// How the controllers are driven in a simulator of traffic (docs/formats/drive.md).
struct DrivePart {
  bool wanted = false;                 ///< Somewhere it is said that the machine drives on a road.
  std::optional<WrittenFormula> stop;  ///< Holds in the step from which the car brakes; none: the event.
  std::vector<SpeedLevelPart> slow;    ///< The first one that holds counts, unless the car stops.
  std::uint32_t roads = 1000;
  std::optional<std::uint64_t> seed;  ///< None: that of [evaluate].
  sim::RoadSetting setting;           ///< Its `cells` are the profile's.
};

/// One scenario file, syntax and words checked; names of the ontology and the plant are resolved by whoever
/// loads these.
struct Scenario {
  std::string path, name, description;
  KnowledgePart knowledge;
  PerceptionPart perception;
  PlantPart plant;
  std::vector<WrittenFormula> assumptions, guarantees;
  std::vector<BindingPart> bindings;
  std::vector<Word> priority;  ///< Of bound behaviours, the first counts most.
  bool only_when_prescribed = false;
  std::vector<ControllerPart> controllers;
  std::vector<ProfilePart> profiles;
  std::optional<EvaluatePart> evaluate;
  std::vector<RoadPart> roads;
  std::optional<TunePart> tune;
  DrivePart drive;
};

/// Reads a scenario (docs/formats/scenario.md). Paths inside are resolved against its folder. \throws
/// util::InputError
[[nodiscard]] Scenario read_scenario(const util::SourceText& source, const util::Limits& limits = {});

}  // namespace heed::job
