#pragma once

#include <heed/dl/reasoner.h>
#include <heed/owl/ontology.h>
#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace heed::awareness {

/// A name as a user wrote it: local name, label, prefixed name or full IRI of something in the ontology, or
/// an atom of the catalogue. The location is for messages and may be unknown.
struct Name {
  Name(std::string name_text, util::Location name_location = {})
      : text(std::move(name_text)), location(std::move(name_location)) {}
  Name(const char* name_text) : text(name_text) {}
  std::string text;
  util::Location location{};
};

/// Which part of an ontology is the catalogue. A root stands for itself and everything below it: subclasses,
/// individuals of these classes, and for a root that is an individual whatever leads to it by
/// `subclass_role`.
struct CatalogueOptions {
  std::vector<Name> entities;    ///< Such as Sign.
  std::vector<Name> features;    ///< Such as Feature, or Colour and Shape.
  std::vector<Name> behaviours;  ///< Such as Behaviour.
  /// Roles that bind features to entities; subproperties count. The order settles which of two features with
  /// the same filler has the plain name: with hasMainColour before hasGroundColour, `red` is the main colour.
  std::vector<Name> feature_roles;
  std::vector<Name> action_roles;         ///< Such as hasAction; subproperties count.
  std::optional<Name> subclass_role;      ///< For ontologies of individuals: isSubClass.
  bool sufficient = false;                ///< Read every necessary description as a definition.
  std::vector<Name> sufficient_entities;  ///< The same for some entities only.
  std::string language = "en";            ///< Of labels.
};

/// That the ontology entails something, with axioms from which it follows (ascending ids).
struct Entailed {
  std::size_t index;  ///< Into the list that the holder names.
  std::vector<owl::AxiomId> axioms;
};

/// What perception can report of a thing.
struct Feature {
  enum class Kind {
    Class,  ///< It is a `filler`: Sign.
    Some,   ///< It has a `filler` by `role`: hasMainColour some Red.
    Value   ///< It has the individual `filler` by `role`: hasColor(x, red).
  };
  Kind kind = Kind::Class;
  std::string atom;   ///< Name in formulas: "red".
  std::string label;  ///< For people.
  owl::Iri filler{};
  owl::Iri role{};                         ///< Unless kind == Class.
  std::string role_atom{};                 ///< "main_colour"; empty when kind == Class.
  std::vector<owl::AxiomId> functional{};  ///< Why the role has at most one value; empty: nothing says so.
  std::vector<Entailed> implies{};         ///< More general features, all of them (features).
  std::optional<std::size_t> entity{};     ///< kind == Class: the entity that it is (entities).
  /// Part of descriptions unless perception says otherwise; not so the groups of entities that only may be
  /// reported.
  bool standard = true;
};

struct Behaviour {
  std::string atom;  ///< "halt".
  std::string label;
  owl::Iri iri{};
  bool individual = false;
  std::vector<Entailed> parents{};  ///< Direct: doing this is doing that (behaviours).
  std::vector<Entailed> general{};  ///< All, itself excluded (behaviours).
};

/// How the ontology lets an entity be recognised.
enum class Sufficiency {
  Defined,      ///< Its described features entail it.
  Declared,     ///< Only because the options say that its description suffices, or role assertions were
                ///< normalised.
  MembersOnly,  ///< Through its recognisable subentities.
  Never
};

struct Entity {
  std::string atom;  ///< "stop_sign".
  std::string label;
  owl::Iri iri{};
  bool individual = false;
  util::Location location{};  ///< Of its declaration or first axiom.
  bool satisfiable = true;
  Sufficiency sufficiency = Sufficiency::Never;
  std::vector<Entailed> parents{};      ///< Direct (entities); equivalent ones are each other's.
  std::vector<Entailed> ancestors{};    ///< All, itself excluded (entities).
  std::vector<std::size_t> children{};  ///< Direct (entities).
  std::vector<Entailed> features{};     ///< All that the ontology entails, also the general ones (features).
  std::vector<Entailed>
      behaviours{};  ///< prescribed(D): inherited ones and those of subbehaviours too (behaviours).
  std::vector<owl::AxiomId> impossible{};  ///< Why it is not satisfiable.
  [[nodiscard]] bool is_leaf() const { return children.empty(); }
};

/// "Whatever is and has all of these is that": a definition, a general inclusion, or that things exclude each
/// other, beyond what Entity, Feature and Behaviour list of themselves.
struct Implication {
  enum class Head { Entity, Feature, Behaviour, Nothing };
  std::vector<std::size_t> entities{}, features{};  ///< The conditions, ascending; not both empty.
  Head head = Head::Nothing;
  std::size_t index = 0;  ///< Of the head; 0 for Nothing.
  std::vector<owl::AxiomId> axioms{};
};

/// Something a safety engineer should know. Codes: unasserted-subsumption, unasserted-equivalence,
/// unsatisfiable-entity, indistinguishable, unused-feature, excludes-nothing, conflicting-prescriptions,
/// never-recognised, sufficient-refused, no-prescription; excludes-less of what perception reports.
struct Warning {
  std::string code;
  std::string message;                 ///< Whole sentences with labels.
  std::vector<owl::AxiomId> axioms{};  ///< Why; may be empty where something is missing.
  std::vector<std::size_t> entities{};
  std::string hint{};         ///< What to do about it; may be empty.
  util::Location location{};  ///< In the scenario, where it is about that; else unknown.
};

/// "Whatever is a `sub` is a `super`", to ask the reasoner.
struct Inclusion {
  owl::ClassExpression sub, super;
};

/// Entities, features and behaviours in normal form (docs/awareness.md). A value. Atoms are distinct over all
/// three lists, except that a feature that is an entity shares its atom.
struct Catalogue {
  owl::Ontology ontology;
  std::string language;
  std::vector<Entity> entities;
  std::vector<Feature> features;
  std::vector<Behaviour> behaviours;
  std::vector<Warning> warnings;
  util::Diagnostics notes;  ///< Such as that role assertions of individuals were read as class descriptions.
  /// Pairs (smaller, larger) of features that no thing can have together, and why.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<owl::AxiomId>> exclusive;
  std::vector<Implication> implications;  ///< In the order of the ontology, then what the reasoner added.
  std::vector<owl::Iri> action_roles;     ///< By which entities prescribe behaviours; subproperties count.

  /// By atom, local name, label or IRI; a feature also as "hasMainColour Red" or "hasMainColour.Red". \throws
  /// util::InputError "unknown-entity", "unknown-feature", "unknown-behaviour" with the nearest name;
  /// "ambiguous-name".
  [[nodiscard]] std::size_t entity(const Name& name) const;
  [[nodiscard]] std::size_t feature(const Name& name) const;
  [[nodiscard]] std::size_t behaviour(const Name& name) const;

  /// What is entailed of \p entity in that list, nullptr when it is not. O(log n).
  [[nodiscard]] const Entailed* has_feature(std::size_t entity, std::size_t feature) const;
  [[nodiscard]] const Entailed* prescribes(std::size_t entity, std::size_t behaviour) const;
  [[nodiscard]] const Entailed* is_below(std::size_t entity, std::size_t ancestor) const;
  [[nodiscard]] const Entailed* implies(std::size_t feature, std::size_t general) const;

  /// described(D): the most specific of the entailed features among \p perceivable (one flag per feature;
  /// empty: all).
  [[nodiscard]] std::vector<Entailed> described(std::size_t entity,
                                                const std::vector<bool>& perceivable = {}) const;
};

/// Builds the catalogue and its warnings. O(entities * (features + behaviours)) questions to the reasoner at
/// most. \throws util::InputError  a root or role that the ontology does not have ("unknown-root",
/// "unknown-role"), with the nearest name; no entity at all.
[[nodiscard]] Catalogue build_catalogue(const dl::Reasoner& reasoner, const CatalogueOptions& options,
                                        util::Budget& budget);

}  // namespace heed::awareness
