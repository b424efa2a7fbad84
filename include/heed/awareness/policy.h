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
  enum class Kind { Full, Tree, TreeOrFull, Definition, AtLeast, Identifying };
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
  /// TreeOrFull always do, Tree never does. Identifying: yes; else whole readings are not part of what is
  /// observed.
  std::optional<bool> direct{};
  /// Which behaviours are prescribed: what the recognised entities prescribe; what every candidate does; what
  /// some candidate does. With a candidate each is within the next when the policy is Identifying.
  enum class Acting { Cautious, Common, Brave };
  Acting acting = Acting::Cautious;
  /// Everything that there is, is in the catalogue: candidates are its leaves. Otherwise a group is a
  /// candidate too once none of its members is possible.
  bool closed = false;
  /// Behaviours that are prescribed when nothing in the catalogue fits what is seen.
  std::vector<Name> fallback{};
  util::Location location{};  ///< Of the policy in its file, for messages.
};

/// "cautious", "common", "brave".
[[nodiscard]] std::string_view to_string(PolicyOptions::Acting acting);
[[nodiscard]] std::optional<PolicyOptions::Acting> read_acting(std::string_view word);

/// "full", "tree", "tree-or-full", "definition", "at-least", "identifying".
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
  logic::Formula formula;  ///< Over symbols, levels, situations and earlier `recognised_...`.
  std::vector<owl::AxiomId> axioms;
  std::vector<Evidence> evidence;  ///< Prime implicants; at most `evidence_cap`.
  std::vector<Evidence> own;       ///< The same without what comes from its members.
  bool evidence_complete = true;
};

struct PrescribedBehaviour {
  std::size_t behaviour;
  std::string name;  ///< "prescribed_halt"
  /// Over `recognised_...`: the most general entities that prescribe it; Common and Brave also over symbols
  /// and situations.
  logic::Formula formula;
  std::vector<owl::AxiomId> axioms;
  std::vector<std::size_t> because;  ///< These entities; none when only candidates prescribe it.
};

/// What can be said of an observation as a whole, or of an entity under it.
struct Situation {
  enum class Kind { Seen, Conflict, Possible, Unknown };
  Kind kind = Kind::Possible;
  std::string name;  ///< "something_seen", "observation_conflict", "possible_stop_sign", "unknown_entity"
  logic::Formula formula;               ///< Over symbols and earlier situations.
  std::string words;                    ///< "'stop sign' is still possible"
  std::optional<std::size_t> entity{};  ///< kind == Possible.
  std::vector<Evidence>
      against{};  ///< Minimal evidence that makes it false (Possible) or true (others); capped.
};

/// A compiled policy: definitions over what perception reports. Nothing here is chosen by a player.
struct Recognition {
  std::string words;  ///< "any 2 of sign, red, octagon (stop sign)"
  std::vector<LevelMemory> memories;
  /// Only where the policy asks for candidates (Identifying, Common, Brave, or a fallback).
  std::vector<Situation> situations;
  std::vector<RecognisedEntity>
      entities;  ///< Each uses only earlier ones; entities never recognised are left out.
  std::vector<PrescribedBehaviour> behaviours;  ///< Those that some recognised entity prescribes.
  util::Diagnostics notes;                      ///< Such as an entity that the tree cannot reach.

  [[nodiscard]] const RecognisedEntity* find_entity(std::size_t entity) const;
  [[nodiscard]] const PrescribedBehaviour* find_behaviour(std::size_t behaviour) const;
};

/// How many prime implicants are listed per entity; what is compiled is never shortened.
inline constexpr std::size_t evidence_cap = 128;

/// \throws util::LimitExceeded  more than a million pieces of evidence tell the candidates apart.
/// \throws util::InputError  unknown names; k = 0; a tree without order; Full without anything that is read
/// whole.
[[nodiscard]] Recognition compile_policy(const Catalogue& catalogue, const Perception& perception,
                                         const PolicyOptions& options);

}  // namespace heed::awareness
