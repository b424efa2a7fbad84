#pragma once

#include "number.h"

#include <heed/logic/formula.h>
#include <heed/model/symbolic.h>
#include <heed/spec/gr1.h>
#include <heed/spec/symbols.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace heed::certify {

enum class Owner : std::uint8_t { Input, Output, Memory };

/// A variable of the specification; its value is the low end of its domain plus the number that its bits
/// spell.
struct Coded {
  const model::Variable* variable;
  Owner owner;
  std::vector<bdd::Pair> bits;  ///< Most significant first.
};

/// The specification's variables in a manager of its own, and its formulas as functions over them. This is
/// not the solver's encoder: it shares nothing with it but the kernel of the diagrams.
class Encoding {
 public:
  /// \param order  Bits as in model::Diagrams, top first; those that it lacks go below.
  Encoding(const spec::Gr1& spec, const std::vector<std::uint32_t>& order, util::Budget& budget);

  [[nodiscard]] bdd::Manager& manager() const { return *manager_; }
  [[nodiscard]] const std::vector<Coded>& variables() const { return variables_; }
  [[nodiscard]] bdd::Bdd constant(bool value) const { return manager_->constant(value); }
  /// All bits of one owner, in order, most significant first.
  [[nodiscard]] std::vector<bdd::Var> bits(Owner owner, bool next) const;
  [[nodiscard]] bdd::Bdd cube(Owner owner, bool next) const;
  /// Codes that are values, of all variables of \p owner; current.
  [[nodiscard]] bdd::Bdd in_range(Owner owner) const;
  [[nodiscard]] static bdd::Bdd below(bdd::Manager& manager, const Coded& variable);
  /// True where the current value of \p variable is \p code.
  [[nodiscard]] bdd::Bdd has_code(const Coded& variable, std::int32_t code) const;
  /// A formula over current and next values, definitions put in. \throws util::InputError  number-range
  [[nodiscard]] bdd::Bdd holds(const logic::Formula& formula) const;
  /// Definitions, in the specification's order; current.
  [[nodiscard]] const std::vector<bdd::Bdd>& definitions() const { return definitions_; }
  [[nodiscard]] const spec::Symbols& symbols() const { return symbols_; }

  /// All functions of \p diagrams that \p wanted lists, over the bits of this manager.
  [[nodiscard]] std::vector<bdd::Bdd> import(const model::Diagrams& diagrams,
                                             const std::vector<model::Function>& wanted) const;
  /// "a = true, n = 3, next a = false": the values of an assignment indexed by diagram variable.
  [[nodiscard]] std::string values(const std::vector<bdd::Literal>& assignment) const;

 private:
  /// A truth value, or a term; neither for a name that only its context explains.
  struct Value {
    bdd::Bdd truth;
    Number number;
    bool is_number = false;
  };
  using Memo = std::unordered_map<const void*, Value>;

  void declare(const spec::Gr1& spec, const std::vector<std::uint32_t>& order);
  [[nodiscard]] Value value(const logic::Formula& node, const Memo& memo) const;
  [[nodiscard]] Value variable(const std::string& name) const;
  [[nodiscard]] Value value_of(const Coded& coded) const;
  [[nodiscard]] static Value shifted(const Value& value);
  [[nodiscard]] bdd::Bdd comparison(const logic::Formula& node, const Memo& memo) const;
  [[nodiscard]] bdd::Bdd connective(const logic::Formula& node, const Memo& memo) const;
  [[nodiscard]] Number term(const logic::Formula& node, std::size_t operand, const Memo& memo) const;

  util::Budget& budget_;
  std::unique_ptr<bdd::Manager> manager_;
  spec::Symbols symbols_;
  std::vector<Coded> variables_;
  std::size_t outputs_ = 0, memories_ = 0;  ///< Where these begin in `variables_`.
  std::vector<Value> values_;               ///< Of `variables_`, now.
  std::vector<bdd::Bdd> definitions_;
  std::vector<bdd::Var> by_bit_;  ///< Diagram variable of each bit of model::Diagrams.
};

}  // namespace heed::certify
