#include "encoder.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>

namespace heed::game {
namespace {

using bdd::Bdd;
using logic::Formula;
using logic::Op;

[[noreturn]] void refuse(const Formula& node, std::string code, std::string message, std::string hint = {}) {
  throw util::InputError(node.location(), std::move(code), std::move(message), std::move(hint));
}

/// A name possibly under Next, as it stands in a comparison; empty otherwise.
std::string plain_name(const Formula& node) {
  const Formula* at = &node;
  while (at->op() == Op::Next) at = &(*at)[0];
  return at->op() == Op::Name ? at->name() : std::string();
}

}  // namespace

void Encoder::add_variable(const Encoded& variable) {
  Symbol symbol;
  for (auto pair = variable.bits.rbegin(); pair != variable.bits.rend(); ++pair) {
    symbol.word.push_back(manager_.variable(pair->current));
    is_next_.resize(std::max<std::size_t>(is_next_.size(), pair->next + std::size_t{1}));
    is_next_[pair->next] = true;
  }
  const model::Domain& domain = variable.variable.domain;
  symbol.word.push_back(manager_.constant(false));
  if (domain.kind == model::Domain::Kind::Boolean) {
    symbol.truth = symbol.word.front();
    symbol.word.clear();
  }
  if (domain.low != 0) symbol.word = word_add(symbol.word, word_constant(manager_, domain.low));
  if (domain.kind == model::Domain::Kind::Enumeration) symbol.enumeration = &domain;
  names_.push_back(variable.variable.name);
  symbols_.insert_or_assign(variable.variable.name, std::move(symbol));
}

void Encoder::add_definition(const std::string& name, const Bdd& value) {
  names_.push_back(name);
  symbols_.insert_or_assign(name, Symbol{value, {}, nullptr});
}

Bdd Encoder::has_code(bdd::Manager& manager, const Encoded& variable, std::int32_t code, bool next) {
  const std::int64_t offset = std::int64_t{code} - variable.variable.domain.low;
  std::vector<bdd::Literal> literals;
  for (std::size_t i = 0; i < variable.bits.size(); ++i) {
    const bdd::Pair& pair = variable.bits[i];
    literals.push_back(
        {next ? pair.next : pair.current, ((offset >> (variable.bits.size() - 1 - i)) & 1) != 0});
  }
  return manager.cube(literals);
}

Bdd Encoder::holds(const Formula& formula) const {
  Memo memo(formula);
  for (std::size_t i = 0; i < memo.nodes.size(); ++i) {
    budget_.check();
    memo.meanings.push_back(meaning(i, memo));
  }
  return truth(memo.nodes.size() - 1, memo);
}

Encoder::Meaning Encoder::meaning(std::size_t place, const Memo& memo) const {
  const Formula& node = memo.nodes[place];
  switch (node.op()) {
    case Op::True:
    case Op::False:
      return {manager_.constant(node.op() == Op::True), {}, nullptr};
    case Op::Name:
      return meaning_of_name(node);
    case Op::Number:
      return {std::nullopt, word_constant(manager_, node.number()), nullptr};
    case Op::Next:
      return shifted(node, memo.meanings[memo.operand(place, 0)]);
    case Op::Add:
    case Op::Sub:
    case Op::Mul:
      return {std::nullopt, arithmetic(place, memo), nullptr};
    default:
      return {node.op() >= Op::Eq && node.op() <= Op::Ge ? comparison(place, memo) : connective(place, memo),
              {},
              nullptr};
  }
}

Encoder::Meaning Encoder::meaning_of_name(const Formula& node) const {
  const auto found = symbols_.find(node.name());
  if (found == symbols_.end()) return {};
  return {found->second.truth, found->second.word, found->second.enumeration};
}

bool Encoder::mentions_next(const Bdd& function) const {
  for (const bdd::Var variable : function.support_variables())
    if (variable < is_next_.size() && is_next_[variable]) return true;
  return false;
}

Encoder::Meaning Encoder::shifted(const Formula& node, const Meaning& operand) const {
  Meaning result;
  result.enumeration = operand.enumeration;
  const auto shift = [&](const Bdd& function) {
    if (mentions_next(function))
      refuse(node, "nested-next", "'X' stands below another 'X'; a step has only one next state");
    return function.next();
  };
  if (operand.truth) result.truth = shift(*operand.truth);
  for (const Bdd& bit : operand.word) result.word.push_back(shift(bit));
  return result;
}

Bdd Encoder::connective(std::size_t place, const Memo& memo) const {
  const Formula& node = memo.nodes[place];
  std::vector<Bdd> operands;
  if (node.op() < Op::Not || node.op() > Op::Iff)
    refuse(node, "temporal-operator", "a temporal operator other than 'X' stands in a part of the game");
  for (const std::uint32_t operand : memo.nodes.operands(place)) operands.push_back(truth(operand, memo));
  switch (node.op()) {
    case Op::Not:
      return !operands[0];
    case Op::And:
      return manager_.conjunction(operands);
    case Op::Or:
      return manager_.disjunction(operands);
    case Op::Implies:
      return operands[0].implies(operands[1]);
    default:
      return operands[0].iff(operands[1]);
  }
}

Bdd Encoder::comparison(std::size_t place, const Memo& memo) const {
  const Formula& node = memo.nodes[place];
  const auto* left_values = memo.meanings[memo.operand(place, 0)].enumeration;
  const auto* right_values = memo.meanings[memo.operand(place, 1)].enumeration;
  // Where both could be values of the other, the right one is (spec::enumeration_value).
  if (left_values && left_values->read(plain_name(node[1]))) right_values = nullptr;
  const Word left = term(memo.operand(place, 0), memo, right_values);
  const Word right = term(memo.operand(place, 1), memo, left_values);
  switch (node.op()) {
    case Op::Eq:
      return word_equal(left, right);
    case Op::Ne:
      return !word_equal(left, right);
    case Op::Lt:
      return word_less(left, right);
    case Op::Le:
      return !word_less(right, left);
    case Op::Gt:
      return word_less(right, left);
    default:
      return !word_less(left, right);
  }
}

Word Encoder::arithmetic(std::size_t place, const Memo& memo) const {
  const Formula& node = memo.nodes[place];
  const Word left = term(memo.operand(place, 0), memo, nullptr);
  const Word right = term(memo.operand(place, 1), memo, nullptr);
  const std::size_t width =
      node.op() == Op::Mul ? left.size() + right.size() : std::max(left.size(), right.size()) + 1;
  if (width > max_word_width) refuse(node, "number-range", "the value of this term needs more than 64 bits");
  if (node.op() == Op::Add) return word_add(left, right);
  if (node.op() == Op::Sub) return word_subtract(left, right);
  return word_multiply(left, right);
}

const Bdd& Encoder::truth(std::size_t place, const Memo& memo) const {
  const Formula& node = memo.nodes[place];
  const Meaning& found = memo.meanings[place];
  if (found.truth) return *found.truth;
  if (const std::string name = plain_name(node); !name.empty()) {
    if (found.word.empty())
      refuse(node, "unknown-name", fmt::format("'{}' is not declared", name), util::suggestion(name, names_));
    refuse(node, "type", fmt::format("'{}' is not Boolean; a comparison is expected here", name));
  }
  refuse(node, "type", "a truth value is expected here, not a number");
}

Word Encoder::term(std::size_t place, const Memo& memo, const model::Domain* other) const {
  const Formula& node = memo.nodes[place];
  const std::string name = plain_name(node);
  // Beside an enumerated variable its values win over variables of the same name.
  if (other != nullptr && !name.empty())
    if (const auto code = other->read(name)) return word_constant(manager_, *code);
  const Meaning& found = memo.meanings[place];
  if (!found.word.empty()) return found.word;
  if (found.truth) return {*found.truth, manager_.constant(false)};
  refuse(node, "unknown-name",
         fmt::format("'{}' is neither a variable nor a value of what it is compared with", name),
         util::suggestion(name, other ? other->values : names_));
}

}  // namespace heed::game
