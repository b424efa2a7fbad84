#pragma once

#include <heed/awareness/catalogue.h>
#include <heed/awareness/perception.h>
#include <heed/logic/formula.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace heed::awareness {

/// When an entity counts as recognised (docs/awareness.md).
struct PolicyOptions {
  enum class Kind { Full, Tree, TreeOrFull, Definition, AtLeast };
  Kind kind = Kind::Definition;
  /// Entities that the policy recognises on their own; empty: all that are Defined or Declared (for Full: all
  /// that are read whole). Groups are always recognised through their members.
  std::vector<Name> entities{};
  /// AtLeast: features or roles to which each description is narrowed; empty: all of the description.
  std::vector<Name> over{};
  std::size_t k = 2;
  /// Tree: features or roles, the first is the root. An entity without a feature that is named here is not
  /// reached; a role that it has no feature of is passed over.
  std::vector<Name> order{};
  bool latch = false;
  /// Tree: where this holds (over symbols, the plant, ...), all levels are forgotten for the next step.
  logic::Formula reset = logic::truth(false);
  /// Whether reading the entity whole suffices as well. Default: AtLeast yes, Definition no. Full and
  /// TreeOrFull always do, Tree never does.
  std::optional<bool> direct{};
  util::Location location{};  ///< Of the policy in its file, for messages.
};

/// "full", "tree", "tree-or-full", "definition", "at-least".
[[nodiscard]] std::string_view to_string(PolicyOptions::Kind kind);
[[nodiscard]] std::optional<PolicyOptions::Kind> read_policy(std::string_view word);

/// Things that together suffice, and why they do.
struct Evidence {
  std::vector<std::string> atoms;  ///< Symbols of perception and levels of the tree, sorted.
  std::vector<owl::AxiomId> axioms;
};

/// A state bit of the tree: false at first, then the value that `update` had one step before.
struct LevelMemory {
  std::string name;  ///< "tree_stop_sign_1": level 1 had been reached one step before (or ever, with latch).
  logic::Formula update;  ///< Over current symbols and levels.
  std::string comment;
};

struct RecognisedEntity {
  std::size_t entity;
  std::string name;        ///< "recognised_stop_sign"
  logic::Formula formula;  ///< Over symbols, levels and earlier `recognised_...`.
  std::vector<owl::AxiomId> axioms;
  std::vector<Evidence> evidence;  ///< Prime implicants; at most `evidence_cap`.
  std::vector<Evidence> own;       ///< The same without what comes from its members.
  bool evidence_complete = true;
};

struct PrescribedBehaviour {
  std::size_t behaviour;
  std::string name;        ///< "prescribed_halt"
  logic::Formula formula;  ///< Over `recognised_...`: the most general entities that prescribe it.
  std::vector<owl::AxiomId> axioms;
  std::vector<std::size_t> because;  ///< These entities.
};

/// A compiled policy: definitions over what perception reports. Nothing here is chosen by a player.
struct Recognition {
  std::string words;  ///< "any 2 of sign, red, octagon (stop sign)"
  std::vector<LevelMemory> memories;
  std::vector<RecognisedEntity>
      entities;  ///< Each uses only earlier ones; entities never recognised are left out.
  std::vector<PrescribedBehaviour> behaviours;  ///< Those that some recognised entity prescribes.
  util::Diagnostics notes;                      ///< Such as an entity that the tree cannot reach.

  [[nodiscard]] const RecognisedEntity* find_entity(std::size_t entity) const;
  [[nodiscard]] const PrescribedBehaviour* find_behaviour(std::size_t behaviour) const;
};

/// How many prime implicants are listed per entity; what is compiled is never shortened.
inline constexpr std::size_t evidence_cap = 128;

/// \throws util::InputError  unknown names; k = 0; a tree without order; Full without anything that is read
/// whole.
[[nodiscard]] Recognition compile_policy(const Catalogue& catalogue, const Perception& perception,
                                         const PolicyOptions& options);

}  // namespace heed::awareness
