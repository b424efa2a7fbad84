#pragma once

#include <heed/awareness/catalogue.h>
#include <heed/logic/formula.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace heed::awareness {

/// One symbol that perception reports.
struct Reported {
  enum class Reading {
    Automatic,  ///< A feature; an entity that has subentities counts as a feature of these, a leaf is read
                ///< whole.
    Feature,
    Whole  ///< The entity as such: seen_D.
  };
  Name what;           ///< Feature or entity of the catalogue.
  std::string atom{};  ///< Name of the symbol in formulas; empty: that of the catalogue.
  Reading reading = Reading::Automatic;
  /// Perception can also report that the feature is not there: a further Boolean input `no_<atom>`.
  bool excluded = false;
};

/// A variable of the environment. Free of any model of variables: whoever composes a specification converts
/// it.
struct PerceptionInput {
  /// What one value stands for.
  struct Meaning {
    std::size_t value;                      ///< Index into `values`; 1 for a Boolean input.
    std::string atom;                       ///< "red"
    std::optional<std::size_t> feature{};   ///< At most one of these three; none for `full_view`.
    std::optional<std::size_t> whole{};     ///< Entity that is read whole.
    std::optional<std::size_t> excluded{};  ///< Feature that is seen to be missing.
  };
  std::string name;                   ///< "main_colour" or, Boolean, "octagon".
  std::vector<std::string> values{};  ///< Empty: Boolean. Else "unknown", then one name per feature.
  std::vector<Meaning> meanings{};
};

/// What perception reports, against one catalogue.
struct Perception {
  std::vector<PerceptionInput> inputs;
  /// Each symbol as a formula over the inputs, in the order reported: `red` is `main_colour = red` or `red`.
  std::vector<std::pair<std::string, logic::Formula>> symbols;
  std::vector<bool> perceivable;           ///< Per feature of the catalogue.
  std::vector<std::string> feature_atom;   ///< Per feature; empty when not reported.
  std::vector<std::string> whole_atom;     ///< Per entity; empty when not reported.
  std::vector<std::string> excluded_atom;  ///< Per feature; empty when its absence is never reported.
  /// `no_red` is `full_view & !red`: symbols for absence that follow from a full view.
  std::vector<std::pair<std::string, logic::Formula>> absences;
  std::vector<util::Location> feature_location;  ///< Per feature: where the scenario reports it.
  util::Diagnostics notes;

  /// Replaces symbols by what they mean over the inputs.
  [[nodiscard]] logic::Formula over_inputs(const logic::Formula& formula) const;
};

struct PerceptionOptions {
  std::vector<Reported> reported;  ///< Empty: every most specific feature and every leaf, by their atoms.
  /// Features that are values of one functional role and exclude each other become one enumerated input when
  /// there are two or more of them. Off: every symbol is a Boolean input.
  bool enumerate = true;
  /// Name of a Boolean input that says that all there is to see is seen: while it holds, every reported
  /// feature that is not seen is excluded. Empty: none, and what is not seen is unknown.
  std::string full_view{};
};

/// \throws util::InputError  an unknown name with the nearest one; two symbols with one name; one thing
/// reported twice.
[[nodiscard]] Perception resolve_perception(const Catalogue& catalogue, const PerceptionOptions& options);

/// Symbols that exclude less than they could ("excludes-less"): values reported by a role of which a thing
/// may have several, though every entity has them by a role of which it has one. Each with the axioms by
/// which the narrower symbol would rule out an entity.
[[nodiscard]] std::vector<Warning> judge_perception(const Catalogue& catalogue, const Perception& perception);

}  // namespace heed::awareness
