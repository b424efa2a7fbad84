#pragma once

#include <heed/model/mealy.h>
#include <heed/model/variable.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace heed::model {

/// Boolean functions over numbered bits as one shared decision diagram: plain data that needs no manager, to
/// be written down, carried to another manager, or evaluated as it is.
///
/// The bits are those of inputs, then chosen outputs, then memories, each variable's most significant first:
/// its value is `domain.low` plus the binary number that they spell. The bit of position p has the number 2p
/// as it is now and 2p + 1 one step later.
struct Diagrams {
  /// `high` where the bit is 1, `low` where it is 0.
  struct Node {
    std::uint32_t bit;
    std::uint32_t low;   ///< A function, of a node before this one.
    std::uint32_t high;  ///< The same; never complemented.
    bool operator==(const Node&) const = default;
  };
  std::vector<std::uint32_t> order;  ///< Bits, top first: a node's bit stands above those of its children.
  std::vector<Node> nodes;
  bool operator==(const Diagrams&) const = default;
};

/// One function of a Diagrams: 2 * index + complement; index 0 is `true`, index i > 0 is nodes[i - 1].
using Function = std::uint32_t;
constexpr Function function_true = 0;
constexpr Function function_false = 1;

/// The value of \p function. \param bits  By number; covers all that occur. O(bits)
[[nodiscard]] bool evaluate(const Diagrams& diagrams, Function function, const std::vector<bool>& bits);

/// How many bits code \p domain's values; none when there is one.
[[nodiscard]] std::size_t bit_width(const Domain& domain);

/// A level of a ranking: \p states has all states of this level and of those below it. Where `assumption` is
/// set, a state of this level may also be followed by one of this level, in a step that fails that
/// assumption.
struct Level {
  Function states = function_false;
  std::optional<std::uint32_t> assumption;
  bool operator==(const Level&) const = default;
};

/// A finite controller whose tables are functions (docs/formats/symbolic.md): for machines too large to list.
/// Together with what it does it holds what proves it right: `winning`, which it never leaves, and for each
/// goal a ranking that goes down.
struct SymbolicController {
  /// Functions of the first observation; of bits that are chosen before, too: memories first, then outputs.
  struct Start {
    Function answered = function_true;  ///< First observations that it answers.
    std::vector<Function> memories, outputs;
    bool operator==(const Start&) const = default;
  };
  /// What it does on the way to one goal.
  struct Goal {
    std::vector<Function> answers;  ///< Bits of the outputs; each may use the answers before it.
    Function met = function_true;   ///< Steps that end the way to this goal; the next one's turn has come.
    std::vector<Level> ranks;
    bool operator==(const Goal&) const = default;
  };

  std::string name;
  std::vector<Variable> inputs;
  std::vector<Output> outputs, memories, definitions;
  std::vector<std::string> assumptions, notes;
  Diagrams diagrams;
  Start start;
  std::vector<Function> legal;       ///< It answers the next observations of which each of them holds.
  std::vector<Function> updates;     ///< Next bits of the memories; may use the next inputs.
  std::vector<Function> derived;     ///< Definitions, over current bits.
  Function winning = function_true;  ///< States that it may be in, over current bits.
  std::vector<Goal> goals;           ///< At least one; it begins with the first.
  bool operator==(const SymbolicController& other) const;
};

/// Symbolic controller files: docs/formats/symbolic.md. Reading checks everything that writing guarantees.
[[nodiscard]] std::string write_symbolic(const SymbolicController& controller);
/// \throws util::InputError
[[nodiscard]] SymbolicController read_symbolic(const util::SourceText& source,
                                               const util::Limits& limits = {});
/// Whether \p source says that it is a symbolic controller; whether it is a right one is not looked at.
[[nodiscard]] bool is_symbolic(const util::SourceText& source);

/// One round of a defeat: from the states that it adds to those lost before, the environment keeps the play
/// in `lost` and goal `goal` unmet, unless the system steps into what was lost before.
struct LosingRound {
  Function lost = function_false;     ///< With those of the rounds before.
  std::optional<std::uint32_t> goal;  ///< Unset: the environment steps into what was lost before at once.
  /// Per assumption, sets that grow to `lost`: from one the environment meets the assumption or steps into
  /// the one before.
  std::vector<std::vector<Function>> chains;
};

/// What a solver says of a game, with all that is needed to see that it is true (docs/semantics.md).
struct Claim {
  std::vector<Variable> inputs, outputs, memories;
  Diagrams diagrams;
  bool realizable = false;
  Function winning = function_false;      ///< Realizable: states from which the system wins.
  std::vector<std::vector<Level>> ranks;  ///< Realizable: by goal.
  std::vector<LosingRound> rounds;        ///< Unrealizable.
};

}  // namespace heed::model
