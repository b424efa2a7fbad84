#pragma once

#include <heed/awareness/policy.h>
#include <heed/logic/formula.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace heed::awareness::test {

/// Truth by the textbook, small formulas only: shares nothing with the code under test.
inline bool truth_of(const logic::Formula& f, const std::map<std::string, bool>& values) {
  using logic::Op;
  const auto operands = f.operands();
  const auto holds = [&](const logic::Formula& g) { return truth_of(g, values); };
  switch (f.op()) {
    case Op::True:
      return true;
    case Op::False:
      return false;
    case Op::Name:
      return values.contains(f.name()) && values.at(f.name());
    case Op::Not:
      return !holds(f[0]);
    case Op::And:
      return std::all_of(operands.begin(), operands.end(), holds);
    case Op::Or:
      return std::any_of(operands.begin(), operands.end(), holds);
    default:
      throw std::logic_error("not propositional");
  }
}

/// What is recognised and prescribed, for given symbols and levels.
inline std::map<std::string, bool> react(const Recognition& recognition, std::map<std::string, bool> values) {
  for (const auto& entity : recognition.entities) values[entity.name] = truth_of(entity.formula, values);
  for (const auto& behaviour : recognition.behaviours)
    values[behaviour.name] = truth_of(behaviour.formula, values);
  return values;
}

/// The levels of the next step.
inline std::map<std::string, bool> advance(const Recognition& recognition,
                                           const std::map<std::string, bool>& values) {
  std::map<std::string, bool> next;
  for (const auto& memory : recognition.memories) next[memory.name] = truth_of(memory.update, values);
  return next;
}

/// A catalogue made by hand: no ontology, no reasoner. Axiom ids are made up.
///
///     sign (slow_down)
///       priority
///         stop:  sign red octagon (halt, give_way)
///         yield: sign red triangle (give_way)
///       prohibitory: sign disc
///         limit: sign red disc (observe)
///       mandatory: sign blue disc
///
/// Halting and giving way are ways to slow down.
class SmallWorld {
 public:
  enum EntityIndex : std::size_t { Sign, Priority, Prohibitory, Mandatory, Stop, Yield, Limit };
  enum FeatureIndex : std::size_t { IsSign, Red, Blue, Octagon, Triangle, Disc };
  enum BehaviourIndex : std::size_t { SlowDown, Halt, GiveWay, Observe };

  SmallWorld() {
    catalogue.language = "en";
    add_features();
    for (const char* behaviour : {"slow_down", "halt", "give_way", "observe"})
      catalogue.behaviours.push_back({behaviour, behaviour, {}, false, {}, {}});
    for (const std::size_t special : {Halt, GiveWay}) {
      catalogue.behaviours[special].parents = {{SlowDown, axiom(90)}};
      catalogue.behaviours[special].general = {{SlowDown, axiom(90)}};
    }
    add_entity("sign", {}, {IsSign}, {SlowDown}, Sufficiency::Defined);
    add_entity("priority", {Sign}, {IsSign}, {SlowDown}, Sufficiency::MembersOnly);
    add_entity("prohibitory", {Sign}, {IsSign, Disc}, {SlowDown}, Sufficiency::MembersOnly);
    add_entity("mandatory", {Sign}, {IsSign, Blue, Disc}, {SlowDown}, Sufficiency::Defined);
    add_entity("stop", {Sign, Priority}, {IsSign, Red, Octagon}, {SlowDown, Halt, GiveWay},
               Sufficiency::Defined);
    add_entity("yield", {Sign, Priority}, {IsSign, Red, Triangle}, {SlowDown, GiveWay}, Sufficiency::Defined);
    add_entity("limit", {Sign, Prohibitory}, {IsSign, Red, Disc}, {SlowDown, Observe}, Sufficiency::Defined);
    catalogue.exclusive = {{{Red, Blue}, axiom(80)},
                           {{Octagon, Triangle}, axiom(81)},
                           {{Octagon, Disc}, axiom(81)},
                           {{Triangle, Disc}, axiom(81)}};
  }

  /// Single inputs for every feature; `stop_seen` when the stop sign is read whole.
  [[nodiscard]] Perception perception(bool whole = true) const {
    PerceptionOptions options;
    for (const char* name : {"sign", "red", "blue", "octagon", "triangle", "disc"})
      options.reported.push_back({name, "", {}});
    if (whole) options.reported.push_back({"stop", "stop_seen", Reported::Reading::Whole});
    options.enumerate = false;
    return resolve_perception(catalogue, options);
  }

  static std::vector<owl::AxiomId> axiom(std::uint32_t number) { return {owl::AxiomId{number}}; }

  Catalogue catalogue{};

 private:
  void add_features() {
    Feature sign;
    sign.atom = sign.label = "sign";
    sign.entity = Sign;
    catalogue.features.push_back(sign);
    for (const char* atom : {"red", "blue", "octagon", "triangle", "disc"}) {
      Feature feature;
      feature.kind = Feature::Kind::Some;
      feature.atom = feature.label = atom;
      const bool colour = catalogue.features.size() < Octagon;
      feature.role_atom = colour ? "main_colour" : "shape";
      feature.role = owl::Iri{colour ? 1U : 2U};  // any two names that every ontology knows
      feature.functional = axiom(70);
      catalogue.features.push_back(feature);
    }
  }

  void add_entity(const std::string& atom, std::vector<std::size_t> ancestors,
                  std::vector<std::size_t> features, std::vector<std::size_t> behaviours,
                  Sufficiency sufficiency) {
    const auto base = static_cast<std::uint32_t>(10 * (catalogue.entities.size() + 1));
    Entity entity;
    entity.atom = entity.label = atom;
    entity.sufficiency = sufficiency;
    for (const std::size_t a : ancestors) entity.ancestors.push_back({a, axiom(base)});
    if (!ancestors.empty()) entity.parents = {entity.ancestors.back()};
    for (const std::size_t f : features)
      entity.features.push_back({f, axiom(base + 1 + static_cast<std::uint32_t>(f))});
    for (const std::size_t b : behaviours) entity.behaviours.push_back({b, axiom(base + 8)});
    if (!ancestors.empty())
      catalogue.entities[ancestors.back()].children.push_back(catalogue.entities.size());
    catalogue.entities.push_back(entity);
  }
};

/// Every assignment to \p names.
inline std::vector<std::map<std::string, bool>> all_assignments(const std::vector<std::string>& names) {
  std::vector<std::map<std::string, bool>> result;
  for (std::size_t bits = 0; bits < (std::size_t{1} << names.size()); ++bits) {
    std::map<std::string, bool> values;
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i]] = ((bits >> i) & 1U) != 0;
    result.push_back(values);
  }
  return result;
}

inline const std::vector<std::string>& small_world_symbols() {
  static const std::vector<std::string> names{"sign",     "red",  "blue",     "octagon",
                                              "triangle", "disc", "stop_seen"};
  return names;
}

}  // namespace heed::awareness::test
