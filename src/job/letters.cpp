// Formulas over the letters of a machine: evaluated once per distinct pair of letters, in postorder over
// integers, where a truth value is 0 or 1.

#include "letters.h"

#include <heed/job/evaluate.h>
#include <heed/logic/parse.h>
#include <heed/util/diagnostic.h>
#include <heed/util/hash.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

namespace heed::job {
namespace {

using logic::Formula;
using logic::Op;

/// Where a name of a formula finds its value: a column, or a constant (the value of an enumeration).
struct Place {
  enum class Kind : std::uint8_t { Input, Output, Constant, Operand } kind = Kind::Operand;
  std::size_t column = 0;
  std::int64_t constant = 0;
};

class LetterFormula {
 public:
  LetterFormula(const Formula& formula, const model::Mealy& machine, const std::vector<std::string>& replaced)
      : machine_(machine), replaced_(replaced), nodes_(logic::postorder(formula)) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) index_[nodes_[i].identity()] = i;
    places_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].op() == Op::Name) places_[i] = place(nodes_[i]);
    for (const Formula& node : nodes_) {
      // What is said of the plant after X is a column by now: a name that is left there means nothing.
      if (node.op() == Op::Next && is_unknown(node[0])) unknown(node[0]);
      if (node.op() >= Op::Next) refuse_temporal(node);
      if (node.op() >= Op::Eq && node.op() <= Op::Ge) resolve_values(node);
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (is_unknown(nodes_[i])) unknown(nodes_[i]);
  }

  [[nodiscard]] bool holds(const model::Valuation& input, const model::Valuation& output) {
    values_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) values_[i] = value(i, input, output);
    return values_.back() != 0;
  }

 private:
  [[noreturn]] static void refuse_temporal(const Formula& node) {
    throw util::InputError(
        node.location(), "temporal",
        fmt::format("'{}' cannot be decided in one step", logic::to_string(node)),
        "events and outcomes speak of one step; X may stand before what holds of the plant");
  }

  [[nodiscard]] Place place(const Formula& name) const {
    for (std::size_t i = 0; i < machine_.outputs.size(); ++i)
      if (machine_.outputs[i].variable.name == name.name()) return {Place::Kind::Output, i, 0};
    for (std::size_t i = 0; i < machine_.inputs.size(); ++i)
      if (machine_.inputs[i].name == name.name()) return {Place::Kind::Input, i, 0};
    return {};
  }

  [[nodiscard]] bool is_unknown(const Formula& node) const {
    return node.op() == Op::Name && places_[index_.at(node.identity())].kind == Place::Kind::Operand;
  }

  [[nodiscard]] const model::Domain* domain_of(const Formula& term) const {
    if (term.op() != Op::Name) return nullptr;
    const Place& at = places_[index_.at(term.identity())];
    if (at.kind == Place::Kind::Input) return &machine_.inputs[at.column].domain;
    if (at.kind == Place::Kind::Output) return &machine_.outputs[at.column].variable.domain;
    return nullptr;
  }

  /// In `state = M4` the name M4 is a value of the other side's domain.
  void resolve_values(const Formula& comparison) {
    for (const std::size_t side : {std::size_t{1}, std::size_t{0}}) {
      const Formula& term = comparison[side];
      const model::Domain* domain = domain_of(comparison[1 - side]);
      if (term.op() != Op::Name || domain == nullptr || domain->kind != model::Domain::Kind::Enumeration)
        continue;
      if (const auto code = domain->read(term.name())) {
        places_[index_.at(term.identity())] = {Place::Kind::Constant, 0, *code};
        return;
      }
    }
  }

  [[noreturn]] void unknown(const Formula& name) const {
    std::vector<std::string> known;
    for (const model::Variable& v : machine_.inputs) known.push_back(v.name);
    for (const model::Output& o : machine_.outputs) known.push_back(o.variable.name);
    for (const std::string& other : replaced_)
      if (std::find(known.begin(), known.end(), other) == known.end()) known.push_back(other);
    throw util::InputError(
        name.location(), "unknown-symbol",
        fmt::format("nothing is called '{}' in the controller '{}'", name.name(), machine_.name),
        util::suggestion(name.name(), known, 20));
  }

  [[nodiscard]] std::int64_t operand(std::size_t node, std::size_t i) const {
    return values_[index_.at(nodes_[node][i].identity())];
  }

  [[nodiscard]] std::int64_t value(std::size_t i, const model::Valuation& input,
                                   const model::Valuation& output) const {
    const Formula& node = nodes_[i];
    switch (node.op()) {
      case Op::True:
        return 1;
      case Op::False:
        return 0;
      case Op::Number:
        return node.number();
      case Op::Name:
        return name_value(places_[i], input, output);
      case Op::Not:
        return operand(i, 0) == 0 ? 1 : 0;
      case Op::Implies:
        return operand(i, 0) == 0 || operand(i, 1) != 0 ? 1 : 0;
      case Op::And:
      case Op::Or:
        return junction(i);
      default:
        return binary(i);
    }
  }

  [[nodiscard]] static std::int64_t name_value(const Place& place, const model::Valuation& input,
                                               const model::Valuation& output) {
    if (place.kind == Place::Kind::Input) return input[place.column];
    if (place.kind == Place::Kind::Output) return output[place.column];
    return place.constant;
  }

  [[nodiscard]] std::int64_t junction(std::size_t i) const {
    const bool conjunction = nodes_[i].op() == Op::And;
    for (std::size_t k = 0; k < nodes_[i].operands().size(); ++k)
      if ((operand(i, k) != 0) != conjunction) return conjunction ? 0 : 1;
    return conjunction ? 1 : 0;
  }

  [[nodiscard]] std::int64_t binary(std::size_t i) const {
    const Formula& node = nodes_[i];
    const std::int64_t a = operand(i, 0), b = operand(i, 1);
    switch (node.op()) {
      case Op::Iff:
        return (a != 0) == (b != 0);
      case Op::Eq:
        return a == b;
      case Op::Ne:
        return a != b;
      case Op::Lt:
        return a < b;
      case Op::Le:
        return a <= b;
      case Op::Gt:
        return a > b;
      case Op::Ge:
        return a >= b;
      case Op::Add:
        return a + b;
      case Op::Sub:
        return a - b;
      case Op::Mul:
        return a * b;
      default:
        break;
    }
    return 0;  // the constructor refused everything else
  }

  const model::Mealy& machine_;
  const std::vector<std::string>& replaced_;
  std::vector<Formula> nodes_;
  std::unordered_map<const void*, std::size_t> index_;
  std::vector<Place> places_;
  std::vector<std::int64_t> values_;
};

}  // namespace

struct LetterFormulas::Parts {
  std::vector<std::string> replaced;  ///< Which the formulas refer to.
  std::vector<LetterFormula> formulas;
};

LetterFormulas::LetterFormulas(const std::vector<Formula>& formulas, const model::Mealy& machine,
                               const std::vector<std::string>& replaced)
    : parts_(std::make_unique<Parts>()) {
  parts_->replaced = replaced;
  parts_->formulas.reserve(formulas.size());
  for (const Formula& formula : formulas) parts_->formulas.emplace_back(formula, machine, parts_->replaced);
}

LetterFormulas::~LetterFormulas() = default;

bool LetterFormulas::holds(std::size_t formula, const model::Valuation& input,
                           const model::Valuation& output) {
  return parts_->formulas[formula].holds(input, output);
}

std::vector<std::vector<bool>> hold_at_transitions(const std::vector<Formula>& formulas,
                                                   const model::Mealy& machine,
                                                   const std::vector<std::string>& replaced) {
  std::vector<std::vector<bool>> result(formulas.size(),
                                        std::vector<bool>(machine.transitions.size(), false));
  for (std::size_t f = 0; f < formulas.size(); ++f) {
    LetterFormula formula(formulas[f], machine, replaced);
    std::unordered_map<std::uint64_t, bool> known;  // by pair of letters; only looked up, never walked
    for (std::size_t t = 0; t < machine.transitions.size(); ++t) {
      const auto& row = machine.transitions[t];
      const std::uint64_t key = (std::uint64_t{row.input} << 32) | row.output;
      auto found = known.find(key);
      if (found == known.end())
        found = known
                    .emplace(key, formula.holds(machine.input_letters[row.input],
                                                machine.output_letters[row.output]))
                    .first;
      result[f][t] = found->second;
    }
  }
  return result;
}

}  // namespace heed::job
