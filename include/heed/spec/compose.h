#pragma once

#include <heed/logic/formula.h>
#include <heed/model/fts.h>
#include <heed/spec/gr1.h>
#include <heed/util/diagnostic.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace heed::spec {

/// The variables that stand for the plant in a composed specification.
inline constexpr const char* plant_state = "state";
inline constexpr const char* plant_action = "action";

/// A formula in LTL as the user wrote it, for assumptions and guarantees.
struct Requirement {
  logic::Formula formula;
  std::string text{};                 ///< As written; printed from the formula when empty.
  std::vector<std::string> axioms{};  ///< Knowledge only.
};

/// What a prescribed behaviour means for the plant: a formula over plant labels, values and `state`, without
/// Next.
struct Binding {
  std::string behaviour;  ///< Name of a definition (role Prescribed).
  logic::Formula effect;
  std::string text{};  ///< As written, such as "stopping".
  /// While this holds the behaviour gives way to another one; over definitions.
  logic::Formula unless = logic::truth(false);
};

/// What is put together beside the plant. All formulas may speak of the inputs, memories and definitions, of
/// the plant's labels and values (`moving`, `location = 0`, `location' < 3`), of `state = M4` and of `action
/// = go`.
struct Composition {
  std::string name{};
  std::vector<std::uint32_t> initial_states{};          ///< Subset of the plant's; empty: all of them.
  std::vector<model::Variable> inputs{};                ///< What perception reports.
  std::optional<model::Valuation> first_observation{};  ///< Fixes the inputs at the first step.
  std::vector<Requirement> perception{};                ///< Assumptions on perception, LTL.
  std::vector<Memory> memories{};                       ///< Of the knowledge (tree levels).
  std::vector<Definition> definitions{};  ///< Recognised entities, prescribed behaviours; any order.
  std::vector<Binding> bindings{};
  bool only_when_prescribed = false;  ///< `X φ <-> OR triggers`, else `trigger -> X φ` each.
  std::vector<Requirement> assumptions{}, guarantees{};  ///< The task, LTL.
};

struct Composed {
  Gr1 spec;
  util::Diagnostics notes;  ///< Such as how nondeterminism is resolved, behaviours bound to nothing.
};

/// The game that `heed run` plays: plant, perception, knowledge, bindings and task as one specification.
/// A deterministic plant is the memory `state` and the output `action`, and "the chosen action is enabled" is
/// a guarantee; a nondeterministic one has `state` as an input, so that it is resolved against the system,
/// which a note says. `X φ` over a deterministic plant is rewritten by expand_plant(): it constrains the
/// action chosen now. The result is validated. \throws util::InputError  name clashes, unknown symbols with
/// the nearest name, an X in a binding ("x-in-binding"), a binding of an unknown behaviour, initial states
/// outside the plant's, or a requirement that is outside what lowering can do.
[[nodiscard]] Composed compose(const model::Fts& plant, const Composition& parts);

/// Rewrites plant labels, values and, for a deterministic plant, Next over them into a formula over `state`
/// and `action` of the same step: `X stopping` becomes "one of the actions that lead from `state` to a
/// stopping state". Where the action is not enabled the value is left open. A nondeterministic plant keeps
/// Next over `state`, and so does every plant below a second Next or another temporal operator. Other names
/// stay. O(nodes * transitions), a comparison of a present with a next value O(states^2). \throws
/// util::InputError  a plant value outside a comparison, an unknown state
[[nodiscard]] logic::Formula expand_plant(const logic::Formula& formula, const model::Fts& plant);

}  // namespace heed::spec
