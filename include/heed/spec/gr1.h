#pragma once

#include <heed/logic/formula.h>
#include <heed/model/mealy.h>
#include <heed/model/variable.h>

#include <string>
#include <vector>

namespace heed::spec {

/// Where a clause comes from: for messages, `heed explain`, and for what may be dropped.
enum class Origin : std::uint8_t { Task, Plant, Knowledge, Perception, Binding, Lowering };

/// One conjunct of a part of the specification. Names may be inputs, outputs, memories, definitions; `X v`
/// (Next) only where the part allows it.
struct Clause {
  logic::Formula formula;
  Origin origin = Origin::Task;
  std::string text;                   ///< As the user wrote it, or a name; for messages.
  std::vector<std::string> axioms{};  ///< Identifiers of the axioms behind it (knowledge only).
};

/// A derived symbol: D <-> formula at every time, the first included. May use inputs, outputs, memories and
/// other definitions (no cycle), never Next. Neither player chooses it.
struct Definition {
  std::string name;
  logic::Formula formula;
  model::OutputRole role = model::OutputRole::Recognised;
  std::string comment{};
  std::vector<std::string> axioms{};
};

/// A state variable that neither player chooses: `initial` at the first step, then its next value is
/// `update`, a formula (Boolean memory) or term (otherwise) over current and primed inputs, current outputs,
/// memories and definitions. A deterministic plant is one of these, written as cases.
struct Memory {
  struct Case {
    logic::Formula guard;  ///< The first case whose guard holds gives the value.
    std::int32_t value;    ///< Code in the domain.
  };
  model::Variable variable;
  /// Codes allowed at the first step: one, or several among which the **system** chooses at the start (plants
  /// only).
  std::vector<std::int32_t> initial{0};
  /// Boolean memories: `update` is used. Others: `cases`, exhaustive (else the value stays).
  logic::Formula update{};
  std::vector<Case> cases{};
  model::OutputRole role = model::OutputRole::Memory;
  std::string comment{};
};

enum class Timing : std::uint8_t { Mealy, Moore };
/// Who chooses first at the start (docs/semantics.md).
enum class InitialQuantifiers : std::uint8_t { ForallExists, ExistsForall, ForallForall, ExistsExists };

/// A GR(1) specification (θe, ρe, Je) -> (θs, ρs, Js), strict semantics (docs/semantics.md). A value; nothing
/// refers back into files but the locations of formulas.
///
/// | part        | may use                                             |
/// | env_init    | inputs                                              |
/// | env_safety  | everything current; primed inputs                   |
/// | env_justice | everything, current and primed                      |
/// | sys_init    | everything current                                  |
/// | sys_safety  | everything, current and primed                      |
/// | sys_justice | everything, current and primed                      |
///
/// A clause of `*_safety` **without** Next holds at every step, the first included (it is G φ).
struct Gr1 {
  std::string name;
  std::vector<model::Variable> inputs;
  std::vector<model::Output> outputs;  ///< Role Action or Output.
  std::vector<Memory> memories;
  std::vector<Definition> definitions;  ///< In an order in which each uses only earlier ones.
  std::vector<Clause> env_init, env_safety, env_justice;
  std::vector<Clause> sys_init, sys_safety, sys_justice;
  Timing timing = Timing::Mealy;
  InitialQuantifiers initial = InitialQuantifiers::ForallExists;
};

/// Checks names, types, Next where it may not stand, cycles among definitions, duplicate names; values of
/// enumerations are resolved against the compared variable. \throws util::InputError  with the clause's
/// position and a suggestion.
void validate(const Gr1& spec);

/// The columns of a controller for \p spec: outputs, then memories, then definitions, with their roles.
[[nodiscard]] std::vector<model::Output> controller_outputs(const Gr1& spec);

}  // namespace heed::spec
