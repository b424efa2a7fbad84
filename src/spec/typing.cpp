#include "typing.h"

#include <heed/util/diagnostic.h>

#include "nodes.h"

#include <fmt/format.h>

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

/// A node's type; `domain` tells enumerations apart. Unknown: an enumeration's value, typed by its
/// comparison.
struct Type {
  enum class Kind : std::uint8_t { Unknown, Boolean, Integer, Enumeration };
  Kind kind = Kind::Unknown;
  const model::Domain* domain = nullptr;
};

Type type_of(const Symbol* symbol) {
  if (!symbol) return {};
  switch (symbol->domain.kind) {
    case model::Domain::Kind::Boolean:
      return {Type::Kind::Boolean};
    case model::Domain::Kind::Integer:
      return {Type::Kind::Integer};
    case model::Domain::Kind::Enumeration:
      return {Type::Kind::Enumeration, &symbol->domain};
  }
  return {};
}

std::string word(Type type) {
  switch (type.kind) {
    case Type::Kind::Unknown:
      return "a value of an enumeration";
    case Type::Kind::Boolean:
      return "a truth value";
    case Type::Kind::Integer:
      return "an integer";
    case Type::Kind::Enumeration:
      return fmt::format("one of {}", fmt::join(type.domain->values, ", "));
  }
  return {};
}

class Checker {
 public:
  Checker(const Formula& formula, const Symbols& symbols, const Place& place)
      : nodes_(formula), symbols_(symbols), place_(place), types_(nodes_.size()), reached_(nodes_.size()) {}

  void run() {
    mark();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (reached_[i] != 0) check_place(i);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (reached_[i] != 0) types_[i] = infer(i);
    require(nodes_.size() - 1, Type::Kind::Boolean);
  }

 private:
  static constexpr std::uint8_t now = 1, primed = 2, beyond = 4;

  /// Which steps each node speaks of, from the root down. The value in `state = M4` is no name and stays
  /// unmarked.
  void mark() {
    reached_.back() = now;
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      std::uint8_t steps = reached_[i];
      if (nodes_[i].op() == Op::Next)
        steps = static_cast<std::uint8_t>(((steps & now) != 0 ? primed : 0) |
                                          ((steps & (primed | beyond)) != 0 ? beyond : 0));
      for (std::size_t k = 0; k < nodes_.operands(i).size(); ++k)
        if (!is_comparison(nodes_[i].op()) || !enumeration_value(nodes_[i], k, symbols_))
          reached_[nodes_.operands(i)[k]] |= steps;
    }
  }

  void check_place(std::size_t i) const {
    const Formula& node = nodes_[i];
    if (is_temporal_beyond_next(node.op()))
      fail(node, "temporal", fmt::format("a temporal operator other than next in {}", place_.what),
           "general LTL goes into [task]");
    if ((reached_[i] & beyond) != 0)
      fail(node, "next-twice", fmt::format("next inside next in {}", place_.what),
           "one step ahead is all that a clause sees");
    if (node.op() == Op::Next && place_.next == Place::Next::Never)
      fail(node, "next-not-allowed",
           fmt::format("next (X or ') in {}, which speaks of one step", place_.what), "");
    if (node.op() == Op::Name) check_name(node, reached_[i]);
  }

  void check_name(const Formula& node, std::uint8_t steps) const {
    const Symbol* symbol = symbols_.find(node.name());
    if (!symbol)
      fail(node, "unknown-name", fmt::format("unknown name '{}' in {}", node.name(), place_.what),
           util::suggestion(node.name(), symbols_.names()));
    const bool input = symbol->kind == Symbol::Kind::Input;
    if (place_.only_inputs && !input)
      fail(node, "not-an-input",
           fmt::format("'{}' is no input, and {} speaks of inputs only", node.name(), place_.what), "");
    if ((steps & primed) != 0 && place_.next == Place::Next::Inputs && !input)
      fail(node, "next-not-allowed",
           fmt::format("the next value of '{}' in {}, which knows only the next inputs", node.name(),
                       place_.what),
           "");
  }

  Type infer(std::size_t i) {
    const Formula& node = nodes_[i];
    const auto& operands = nodes_.operands(i);
    switch (node.op()) {
      case Op::Name:
        return type_of(symbols_.find(node.name()));
      case Op::Number:
        return {Type::Kind::Integer};
      case Op::Next:
        return types_[operands[0]];
      case Op::Add:
      case Op::Sub:
      case Op::Mul:
        for (const std::uint32_t operand : operands) require(operand, Type::Kind::Integer);
        return {Type::Kind::Integer};
      default:
        break;
    }
    if (is_comparison(node.op())) {
      check_comparison(i);
    } else {
      for (const std::uint32_t operand : operands) require(operand, Type::Kind::Boolean);
    }
    return {Type::Kind::Boolean};
  }

  void check_comparison(std::size_t i) const {
    const Formula& node = nodes_[i];
    const bool equality = node.op() == Op::Eq || node.op() == Op::Ne;
    const Type left = types_[nodes_.operands(i)[0]], right = types_[nodes_.operands(i)[1]];
    if (enumeration_value(node, 0, symbols_) || enumeration_value(node, 1, symbols_)) {
      if (!equality) fail(node, "type", "an enumeration has no order: only = and != compare its values", "");
      return;
    }
    const bool same = left.kind == right.kind &&
                      (left.kind != Type::Kind::Enumeration || left.domain->values == right.domain->values);
    if (!same) fail(node, "type", fmt::format("{} is compared with {}", word(left), word(right)), "");
    if (!equality && left.kind != Type::Kind::Integer)
      fail(node, "type", fmt::format("only integers have an order, and this is {}", word(left)), "");
  }

  void require(std::size_t i, Type::Kind kind) const {
    if (types_[i].kind == kind) return;
    const std::string hint = kind == Type::Kind::Boolean ? "compare it, as in 'x = 3'" : "";
    fail(nodes_[i], "type", fmt::format("{} is expected and this is {}", word({kind}), word(types_[i])),
         hint);
  }

  [[noreturn]] void fail(const Formula& node, std::string code, std::string message, std::string hint) const {
    util::Location location = node.location();
    for (std::size_t i = nodes_.size(); i-- > 0 && location.line == 0;) location = nodes_[i].location();
    if (location.line == 0 && !place_.text.empty()) message += fmt::format(": {}", place_.text);
    throw util::InputError(std::move(location), std::move(code), std::move(message), std::move(hint));
  }

  Nodes nodes_;
  const Symbols& symbols_;
  const Place& place_;
  std::vector<Type> types_;
  std::vector<std::uint8_t> reached_;
};

}  // namespace

void check_formula(const Formula& formula, const Symbols& symbols, const Place& place) {
  Checker(formula, symbols, place).run();
}

}  // namespace heed::spec
