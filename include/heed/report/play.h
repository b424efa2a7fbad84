#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the page of `heed play` is filled with (docs/formats/play.md): plain values, filled by whoever knows
/// the controllers. Indices count from 0 into the lists of Play.
namespace heed::report {

/// `values`: an enumeration; else the range low ... high, Boolean when that is 0 ... 1 and `boolean`.
struct PlayVariable {
  std::string name;
  bool boolean = true;
  std::int32_t low = 0, high = 1;
  std::vector<std::string> values{};
  std::string comment{};
};

/// A variable and what it is: "action", "plant", "recognised", ...
struct PlayColumn {
  PlayVariable variable;
  std::string role;
};

/// Something that perception can report: that an input has a value.
struct PlaySymbol {
  std::string name, label;
  std::string kind;  ///< "feature", "group", "whole", "missing", "view"
  std::size_t input = 0;
  std::int32_t value = 1;
  std::optional<std::size_t> feature{}, entity{};
};

struct PlayFeature {
  std::string label;
  std::string aspect;  ///< "main colour"; empty for a class.
  std::string value;   ///< "red"
};

struct PlayEntity {
  std::string name, label, group;
  std::vector<std::size_t> features{};
  std::vector<std::string> prescribes{};
  std::string react{};  ///< "must", "may" or empty.
  std::vector<std::size_t> shows{};
};

struct PlayPlant {
  std::vector<std::string> states{};
  std::vector<std::pair<std::string, std::vector<std::size_t>>> labels{};
  std::vector<std::pair<std::string, std::vector<std::int32_t>>> values{};
  std::string way{};
};

struct PlayDraw {
  std::string probability;
  std::size_t next = 0;
  std::vector<std::size_t> seen{};
};
using PlayChain = std::vector<std::vector<PlayDraw>>;  ///< Per state.

struct PlayApproach {
  std::size_t chain = 0;
  std::vector<std::size_t> symbols{};  ///< Per feature of the profile.
  bool sampled = false;
};

struct PlayProfile {
  std::string name, title;
  std::size_t cells = 0;
  std::vector<std::string> lines{};
  std::vector<PlayChain> chains{};
  std::vector<PlayApproach> approaches{};
  std::vector<std::size_t> of{};  ///< Per entity, then for nothing there.
};

struct PlayAxiom {
  std::string id, text, file;
  std::uint32_t line = 0;
};

struct PlayEvidence {
  std::vector<std::string> atoms, axioms;
  std::string sigma;
};
struct PlayRecognised {
  std::size_t column = 0;
  std::string label;
  std::vector<PlayEvidence> evidence{};
};

struct PlayCause {
  std::size_t column = 0;
  std::vector<std::string> axioms{};
  std::string sigma{};
};
struct PlayPrescribed {
  std::size_t column = 0;
  std::string label, effect;
  std::vector<PlayCause> because{};
};

struct PlaySigma {
  std::string id, kind, text, sentence;
  std::vector<std::string> axioms{};
};

struct PlayRow {
  std::size_t observation = 0, reaction = 0, next = 0;
  std::optional<std::size_t> outcome{};
  bool fallback = false;
};

struct PlayController {
  std::string name, title, policy;
  bool beside = false;
  std::vector<std::string> assumptions{}, notes{};
  std::vector<PlayColumn> outputs{};
  std::vector<std::vector<std::int32_t>> reactions{};
  std::vector<std::vector<PlayRow>> states{};
  std::vector<PlayRecognised> recognises{};
  std::vector<PlayPrescribed> prescribes{};
  std::vector<PlaySigma> sigma{};
};

struct PlayCandidates {
  std::vector<std::vector<std::size_t>> sets{};
  std::vector<std::size_t> of{};  ///< Per observation.
};

struct PlaySpeed {
  double cell_metres = 10, kmh = 50;
};

struct Play {
  std::string scenario, description{};
  std::string thing = "the thing", kind = "thing";
  std::optional<std::size_t> approached{};
  std::uint32_t seed = 1;
  std::size_t cells = 5;
  std::string subject{};
  std::vector<PlayVariable> inputs{};
  std::vector<PlaySymbol> symbols{};
  std::vector<PlayFeature> features{};
  std::vector<PlayEntity> entities{};
  PlayPlant plant{};
  std::optional<PlaySpeed> speed{};
  std::string event{};
  std::vector<std::string> outcomes{};
  std::size_t rest = 0, miss = 0;
  std::vector<PlayProfile> profiles{};
  std::vector<std::vector<std::int32_t>> observations{};
  std::optional<PlayCandidates> candidates{};
  std::vector<PlayAxiom> axioms{};
  std::vector<PlayController> controllers{};
  std::vector<std::pair<std::string, std::string>> versions{};
};

/// The document of docs/formats/play.md, compact, on one line. Invalid UTF-8 is replaced by U+FFFD. O(size)
[[nodiscard]] std::string to_json(const Play& play);

/// Whether this program was built with the page (Node and the packages of web/ were there).
[[nodiscard]] bool has_play_page();

/// The page with the data inside. \pre has_play_page()
[[nodiscard]] std::string to_html(const Play& play);

}  // namespace heed::report
