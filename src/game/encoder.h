#pragma once

#include "word.h"

#include <heed/game/game.h>
#include <heed/logic/nodes.h>
#include <heed/util/limits.h>

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace heed::game {

/// Turns formulas into diagrams over the variables of a game. Loops over postorder(), so depth is no matter.
class Encoder {
 public:
  Encoder(bdd::Manager& manager, util::Budget& budget) : manager_(manager), budget_(budget) {}

  void add_variable(const Encoded& variable);
  void add_definition(const std::string& name, const bdd::Bdd& value);

  /// The function of a Boolean formula; Next reads next variables.
  /// \throws util::InputError  an unknown name, a temporal operator, a number where a truth value is expected
  [[nodiscard]] bdd::Bdd holds(const logic::Formula& formula) const;
  /// The current value of a variable as code - low, in its bits: true where it is \p code.
  [[nodiscard]] static bdd::Bdd has_code(bdd::Manager& manager, const Encoded& variable, std::int32_t code,
                                         bool next);

 private:
  struct Symbol {
    std::optional<bdd::Bdd> truth;
    Word word;
    const model::Domain* enumeration = nullptr;
  };
  /// What a node stands for: a truth value, a term, or a name that only its context can explain.
  struct Meaning {
    std::optional<bdd::Bdd> truth;
    Word word;  ///< Empty for a truth value: its one bit is the truth.
    const model::Domain* enumeration = nullptr;
  };
  /// The nodes of a formula, and what those so far stand for.
  struct Memo {
    explicit Memo(const logic::Formula& formula) : nodes(formula) { meanings.reserve(nodes.size()); }
    /// The place of the \p k th operand of a node.
    [[nodiscard]] std::size_t operand(std::size_t place, std::size_t k) const {
      return nodes.operands(place)[k];
    }
    logic::Nodes nodes;
    std::vector<Meaning> meanings;
  };

  [[nodiscard]] Meaning meaning(std::size_t place, const Memo& memo) const;
  [[nodiscard]] Meaning meaning_of_name(const logic::Formula& node) const;
  [[nodiscard]] Meaning shifted(const logic::Formula& node, const Meaning& operand) const;
  [[nodiscard]] bdd::Bdd connective(std::size_t place, const Memo& memo) const;
  [[nodiscard]] bdd::Bdd comparison(std::size_t place, const Memo& memo) const;
  [[nodiscard]] Word arithmetic(std::size_t place, const Memo& memo) const;
  [[nodiscard]] const bdd::Bdd& truth(std::size_t place, const Memo& memo) const;
  [[nodiscard]] Word term(std::size_t place, const Memo& memo, const model::Domain* other) const;
  [[nodiscard]] bool mentions_next(const bdd::Bdd& function) const;

  bdd::Manager& manager_;
  util::Budget& budget_;
  std::unordered_map<std::string, Symbol> symbols_;
  std::vector<std::string> names_;  ///< For suggestions, in the order added.
  std::vector<bool> is_next_;       ///< By diagram variable.
};

}  // namespace heed::game
