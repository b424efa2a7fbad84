#include "encoding.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace heed::certify {

using bdd::Bdd;
using logic::Formula;
using logic::Op;

namespace {

/// The order is the one that the claim was found with, so that only much larger diagrams call for another.
bdd::ManagerOptions options() {
  bdd::ManagerOptions result;
  result.first_reordering *= 10;
  return result;
}

}  // namespace

Encoding::Encoding(const spec::Gr1& spec, const std::vector<std::uint32_t>& order, util::Budget& budget)
    : budget_(budget), manager_(std::make_unique<bdd::Manager>(options(), &budget)), symbols_(spec) {
  declare(spec, order);
  for (const auto& definition : spec.definitions) definitions_.push_back(holds(definition.formula));
}

void Encoding::declare(const spec::Gr1& spec, const std::vector<std::uint32_t>& order) {
  for (const auto& input : spec.inputs) variables_.push_back({&input, Owner::Input, {}});
  outputs_ = variables_.size();
  for (const auto& output : spec.outputs) variables_.push_back({&output.variable, Owner::Output, {}});
  memories_ = variables_.size();
  for (const auto& memory : spec.memories) variables_.push_back({&memory.variable, Owner::Memory, {}});
  std::size_t positions = 0;
  for (const Coded& coded : variables_) positions += model::bit_width(coded.variable->domain);
  std::vector<std::uint32_t> ranked;
  std::vector<bool> placed(positions, false);
  const auto place = [&](std::size_t position) {
    if (position < positions && !placed[position]) ranked.push_back(static_cast<std::uint32_t>(position));
    if (position < positions) placed[position] = true;
  };
  for (const std::uint32_t bit : order) place(bit / 2);
  for (std::size_t position = 0; position < positions; ++position) place(position);
  std::vector<bdd::Pair> pairs(positions);
  for (const std::uint32_t position : ranked) pairs[position] = manager_->new_pair();
  auto next = pairs.begin();
  for (Coded& coded : variables_) {
    const auto end = next + static_cast<std::ptrdiff_t>(model::bit_width(coded.variable->domain));
    coded.bits.assign(next, end);
    next = end;
  }
  for (const Coded& coded : variables_) values_.push_back(value_of(coded));
  for (const bdd::Pair& pair : pairs) by_bit_.insert(by_bit_.end(), {pair.current, pair.next});
}

std::vector<bdd::Var> Encoding::bits(Owner owner, bool next) const {
  std::vector<bdd::Var> result;
  for (const Coded& coded : variables_)
    if (coded.owner == owner)
      for (const bdd::Pair& pair : coded.bits) result.push_back(next ? pair.next : pair.current);
  return result;
}

Bdd Encoding::cube(Owner owner, bool next) const {
  return manager_->cube(bits(owner, next));
}

Bdd Encoding::below(bdd::Manager& manager, const Coded& variable) {
  const auto last = static_cast<std::uint64_t>(variable.variable->domain.size() - 1);
  Bdd fits = manager.constant(true);
  std::size_t weight = 0;
  for (auto pair = variable.bits.rbegin(); pair != variable.bits.rend(); ++pair, ++weight) {
    const Bdd bit = manager.variable(pair->current);
    fits = ((last >> weight) & 1) != 0 ? fits | !bit : fits & !bit;
  }
  return fits;
}

Bdd Encoding::in_range(Owner owner) const {
  Bdd all = constant(true);
  for (const Coded& coded : variables_)
    if (coded.owner == owner) all &= below(*manager_, coded);
  return all;
}

Bdd Encoding::has_code(const Coded& variable, std::int32_t code) const {
  const std::int64_t distance = std::int64_t{code} - variable.variable->domain.low;
  std::vector<bdd::Literal> literals;
  const std::size_t width = variable.bits.size();
  for (std::size_t weight = 0; weight < width; ++weight)
    literals.push_back({variable.bits[width - 1 - weight].current, ((distance >> weight) & 1) != 0});
  return manager_->cube(literals);
}

Bdd Encoding::holds(const Formula& formula) const {
  Memo memo;
  try {
    for (const Formula& node : logic::postorder(formula)) {
      budget_.check();
      memo.emplace(node.identity(), value(node, memo));
    }
  } catch (const OutOfRange&) {
    throw util::InputError(formula.location(), "number-range",
                           "a term of this formula needs more than 62 bits");
  }
  return memo.at(formula.identity()).truth;
}

Encoding::Value Encoding::value(const Formula& node, const Memo& memo) const {
  switch (node.op()) {
    case Op::True:
    case Op::False:
      return {constant(node.op() == Op::True), {}, false};
    case Op::Name:
      return variable(node.name());
    case Op::Number:
      return {{}, {node.number(), {}}, true};
    case Op::Next:
      return shifted(memo.at(node[0].identity()));
    case Op::Add:
      return {{}, add(term(node, 0, memo), term(node, 1, memo)), true};
    case Op::Sub:
      return {{}, subtract(term(node, 0, memo), term(node, 1, memo)), true};
    case Op::Mul:
      return {{}, multiply(term(node, 0, memo), term(node, 1, memo)), true};
    default:
      return {node.op() >= Op::Eq && node.op() <= Op::Ge ? comparison(node, memo) : connective(node, memo),
              {},
              false};
  }
}

Encoding::Value Encoding::variable(const std::string& name) const {
  const spec::Symbol* symbol = symbols_.find(name);
  if (symbol == nullptr) return {};
  using Kind = spec::Symbol::Kind;
  if (symbol->kind == Kind::Definition) return {definitions_.at(symbol->index), {}, false};
  const std::size_t begin = symbol->kind == Kind::Input    ? 0
                            : symbol->kind == Kind::Output ? outputs_
                                                           : memories_;
  return values_[begin + symbol->index];
}

Encoding::Value Encoding::value_of(const Coded& coded) const {
  const model::Domain& domain = coded.variable->domain;
  if (domain.kind == model::Domain::Kind::Boolean)
    return {manager_->variable(coded.bits.front().current), {}, false};
  Value result{{}, {domain.low, {}}, true};
  for (auto pair = coded.bits.rbegin(); pair != coded.bits.rend(); ++pair)
    result.number.bits.push_back(manager_->variable(pair->current));
  return result;
}

Encoding::Value Encoding::shifted(const Value& value) {
  Value result = value;
  if (result.truth.valid()) result.truth = result.truth.next();
  for (Bdd& bit : result.number.bits) bit = bit.next();
  return result;
}

Number Encoding::term(const Formula& node, std::size_t operand, const Memo& memo) const {
  if (node.op() >= Op::Eq && node.op() <= Op::Ge)
    if (const auto code = spec::enumeration_value(node, operand, symbols_)) return {*code, {}};
  const Value& found = memo.at(node[operand].identity());
  if (found.is_number) return found.number;
  if (found.truth.valid()) return {0, {found.truth}};
  throw util::InputError(node.location(), "unknown-name",
                         "an operand is no value of what it is compared with");
}

Bdd Encoding::comparison(const Formula& node, const Memo& memo) const {
  const Number left = term(node, 0, memo), right = term(node, 1, memo);
  switch (node.op()) {
    case Op::Eq:
      return equal(*manager_, left, right);
    case Op::Ne:
      return !equal(*manager_, left, right);
    case Op::Lt:
      return less(*manager_, left, right);
    case Op::Ge:
      return !less(*manager_, left, right);
    case Op::Gt:
      return less(*manager_, right, left);
    default:
      return !less(*manager_, right, left);
  }
}

Bdd Encoding::connective(const Formula& node, const Memo& memo) const {
  std::vector<Bdd> operands;
  for (const Formula& operand : node.operands()) operands.push_back(memo.at(operand.identity()).truth);
  switch (node.op()) {
    case Op::Not:
      return !operands[0];
    case Op::And:
      return manager_->conjunction(operands);
    case Op::Or:
      return manager_->disjunction(operands);
    case Op::Implies:
      return (!operands[0]) | operands[1];
    case Op::Iff:
      return operands[0].ite(operands[1], !operands[1]);
    default:
      throw util::InputError(node.location(), "temporal-operator",
                             "a temporal operator other than 'X' stands in a part of the game");
  }
}

std::vector<Bdd> Encoding::import(const model::Diagrams& diagrams,
                                  const std::vector<model::Function>& wanted) const {
  bdd::Serialised data;
  data.nodes.reserve(diagrams.nodes.size());
  for (const auto& node : diagrams.nodes) data.nodes.push_back({node.bit, node.low, node.high});
  data.roots = wanted;
  return bdd::deserialise(*manager_, data, by_bit_);
}

std::string Encoding::values(const std::vector<bdd::Literal>& assignment) const {
  std::map<bdd::Var, bool> value;
  for (const bdd::Literal& literal : assignment) value[literal.variable] = literal.value;
  std::string out;
  for (const bool next : {false, true})
    for (const Coded& coded : variables_) {
      std::int64_t code = 0;
      bool known = coded.bits.empty() && !next;
      for (const bdd::Pair& pair : coded.bits) {
        const auto found = value.find(next ? pair.next : pair.current);
        code = 2 * code + (found != value.end() && found->second ? 1 : 0);
        known = known || found != value.end();
      }
      if (!known) continue;
      const model::Domain& domain = coded.variable->domain;
      code = std::min<std::int64_t>(code + domain.low, domain.high);
      out += fmt::format("{}{}{} = {}", out.empty() ? "" : ", ", next ? "next " : "", coded.variable->name,
                         domain.print(static_cast<std::int32_t>(code)));
    }
  return out;
}

}  // namespace heed::certify
