#pragma once

#include <heed/spec/gr1.h>

#include "program.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace heed::check {

/// One compiled clause of the specification.
struct Rule {
  const spec::Clause* clause;
  Program program;
};

/// How a memory gets its next value from what was kept and the next inputs.
struct Update {
  struct Case {
    Program guard;
    std::int32_t value;
  };
  std::vector<Case> cases;  ///< Otherwise:
  Program otherwise;
};

/// What can be computed or decided while inputs are assigned one after the other, and when.
struct Task {
  enum class Kind : std::uint8_t { Memory, Definition, Check };
  Kind kind;
  std::uint32_t index;  ///< Memory, definition, or into the rules of `Enumeration::checks`.
};

/// How the legal inputs of a step are enumerated. `levels[0]` is done before the first input is assigned,
/// `levels[k + 1]` once inputs 0 ... k are. `after` needs the machine's answer.
struct Enumeration {
  std::vector<std::vector<Task>> levels;
  std::vector<Rule> checks;
  std::vector<Rule>
      start;  ///< First step only: over a plant's initial state, which the system chooses so that they hold.
  std::vector<Rule> after;
};

/// The specification, compiled. Present rules look at one step; step rules at a step and at what was kept of
/// the one before.
struct Rules {
  explicit Rules(const spec::Gr1& specification);

  const spec::Gr1& spec;
  Layout layout;
  Kept kept;
  Enumeration first, later;
  std::vector<Update> updates;       ///< Per memory.
  std::vector<Program> definitions;  ///< Per definition, over the columns.
  std::vector<Rule> sys_init, sys_present;
  std::vector<Rule> sys_coming;  ///< With Next, and yet of the step that is reached alone.
  std::vector<Rule> sys_step;    ///< Of both steps.
  std::vector<std::optional<Program>> justice_present;  ///< Environment's first, then the system's; by kind
  std::vector<std::optional<Program>> justice_step;     ///< one of the two is there.
  std::vector<std::uint32_t> step_justices;             ///< Those in justice_step.
  std::size_t env_justices = 0, sys_justices = 0;
  std::size_t registers = 0;  ///< Enough for every program.

  struct KeptProgram {
    std::vector<std::pair<Program, std::int32_t>> cases;
    Program term;
  };
  std::vector<KeptProgram> kept_programs;

 private:
  void compile_memories();
  void compile_system();
  void compile_justice();
  void compile_kept();
  void need(const Program& program);
  [[nodiscard]] Enumeration enumeration(bool at_start);
};

}  // namespace heed::check
