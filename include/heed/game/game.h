#pragma once

#include <heed/bdd/bdd.h>
#include <heed/game/techniques.h>
#include <heed/model/variable.h>
#include <heed/spec/gr1.h>
#include <heed/util/limits.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace heed::game {

enum class Owner : std::uint8_t { Input, Output, Memory };

/// A variable of the specification as bits: its value is `low` plus the binary number that they spell.
struct Encoded {
  model::Variable variable;
  Owner owner = Owner::Input;
  std::vector<bdd::Pair> bits;  ///< Most significant first; none when the domain has one value.
};

/// A conjunct of what the system must keep, and the clause that it comes from.
struct Part {
  static constexpr std::size_t no_clause = static_cast<std::size_t>(-1);
  bdd::Bdd relation;
  std::size_t clause = no_clause;  ///< Index into the part of the specification; no_clause: a range.
};

/// A justice; `step` says that it speaks of two successive states and not of one.
struct Justice {
  bdd::Bdd relation;
  bool step = false;
  std::size_t clause = Part::no_clause;
};

/// A specification as diagrams over the current (X, Y, M) and the next (X', Y', M') values of inputs, outputs
/// and memories. Definitions are substituted away. A copy shares the manager; it is cheap.
///
/// How the table of spec::Gr1 is read where it leaves room:
/// - A clause of env_safety without Next that speaks of inputs and memories alone holds for X at the first
/// step and for
///   X' at every later one. One that mentions outputs can only be judged after the system's answer: where
///   the current state breaks it, the environment has no legal move and has lost.
/// - At the first step an input is legal when some initial value of the memories makes it so; the system then
/// chooses an
///   initial value that does.
struct Game {
  std::shared_ptr<bdd::Manager> manager;
  std::shared_ptr<const spec::Gr1> spec;
  std::vector<Encoded>
      variables;  ///< Inputs, then outputs, then memories, each in the specification's order.
  std::vector<bdd::Bdd> definitions;  ///< Over current variables, in the specification's order.

  bdd::Bdd inputs, outputs, memories;                 ///< Cubes of current variables.
  bdd::Bdd next_inputs, next_outputs, next_memories;  ///< Cubes of next variables.
  bdd::Bdd valid;                                     ///< Current codes are codes of the domains.

  bdd::Bdd env_initial;  ///< X, M: theta_e and what the environment always keeps.
  /// X, Y, M, X', M': the conjuncts of rho_e, where BuildOptions asked for them. As one diagram they can be
  /// larger than all else in the game.
  std::vector<bdd::Bdd> env_safety;
  std::vector<bdd::Bdd> env_steps;   ///< The same for solving: without what nobody reads.
  bdd::Bdd memory_initial;           ///< M: the values that memories may start with.
  std::vector<Part> sys_initial;     ///< X, Y, M: theta_s, by clause of sys_init.
  std::vector<Part> initial_safety;  ///< X, Y, M: clauses of sys_safety without Next, at the first step.
  std::vector<Part> sys_safety;      ///< X, Y, M, X', Y', M': rho_s by clause of sys_safety.
  std::vector<bdd::Bdd>
      updates;  ///< X, Y, M, X': the next value of each bit of the memories, in their order.
  std::vector<Justice> env_justice, sys_justice;  ///< Never empty.

  /// The bits of all variables of \p owner, in order, most significant first.
  [[nodiscard]] std::vector<bdd::Var> bits(Owner owner, bool next) const;
  /// theta_s, with what holds at every step and the choice of initial memories. Over X, Y, M.
  [[nodiscard]] bdd::Bdd initial_answer() const;
  /// Inputs that are legal at the first step. Over X.
  [[nodiscard]] bdd::Bdd initial_inputs() const;
};

/// Which clauses of the system stay; for looking at a part of a specification.
struct Selection {
  std::vector<bool> init, safety, justice;
};

struct BuildOptions {
  /// Whether Game::env_safety is kept. Solving does without it where the environment is partitioned.
  bool whole_environment = true;
  Techniques techniques{};
};

/// Encodes \p spec. The variable order follows from its structure: names that stand in clauses together stand
/// near each other, each bit's current and next variable adjacent. \throws util::InputError  a name, a Next
/// or a type where it may not stand; util::LimitExceeded
[[nodiscard]] Game build_game(const spec::Gr1& spec, util::Budget& budget, const BuildOptions& options = {});

/// The game with fewer obligations on the system. Ranges and memories stay.
[[nodiscard]] Game select(const Game& game, const Selection& selection);

}  // namespace heed::game
