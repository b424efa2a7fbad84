// An operator-precedence reader with two explicit stacks, operands and pending operators. Recursive descent
// would be shorter, but its depth is the input's; here nesting costs memory only, and the limit on it is a
// message.

#include "lexer.h"
#include "precedence.h"

#include <fmt/format.h>
#include <heed/logic/parse.h>
#include <heed/util/diagnostic.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace heed::logic {
namespace {

/// A bare name may turn out to be either; so may what `'` makes of it.
enum class Sort : std::uint8_t { Truth, Term, Either };

struct Operand {
  Formula formula;
  Sort sort = Sort::Truth;
  std::size_t depth = 0;
  std::size_t offset = 0;
};

struct Pending {
  Op op = Op::True;
  bool open = false;         ///< A parenthesis rather than an operator.
  std::size_t operands = 2;  ///< `a & b & c` is one conjunction of three.
  std::size_t offset = 0;
  std::string text{};
};

class Parser {
 public:
  Parser(const util::SourceText& source, const util::Limits& limits)
      : source_(source), limits_(limits), lexer_(source) {}

  Formula read() {
    bool more = true;
    while (more) more = operand_expected_ ? read_operand() : read_operator();
    return std::move(operands_.back().formula);
  }

 private:
  bool read_operand();
  bool read_operator();
  void push_prefix(const Token& token);
  void push_infix(const Token& token);
  void push_atom(const Token& token);
  void close_parenthesis(const Token& token);
  void finish();
  void apply_prime(const Token& token);
  void reduce_while(int binding, bool equal_too);
  void reduce();
  void require(const Operand& operand, Sort sort, const Pending& pending) const;
  [[nodiscard]] Formula build(const Pending& pending, std::vector<Formula> parts) const;
  [[noreturn]] void fail_operand(const Token& token) const;
  [[noreturn]] void fail_operator(const Token& token) const;
  [[noreturn]] void fail_nesting(std::size_t offset) const;

  const util::SourceText& source_;
  const util::Limits& limits_;
  Lexer lexer_;
  std::vector<Operand> operands_;
  std::vector<Pending> pending_;
  std::size_t parentheses_ = 0;
  bool operand_expected_ = true;
};

bool Parser::read_operand() {
  const Token token = lexer_.next(true);
  switch (token.kind) {
    case Token::Kind::Open:
      pending_.push_back({Op::True, true, 0, token.offset, token.text});
      if (++parentheses_ > limits_.nesting && limits_.nesting != 0) fail_nesting(token.offset);
      break;
    case Token::Kind::Operator:
      if (!is_prefix(token.op)) fail_operand(token);
      push_prefix(token);
      break;
    case Token::Kind::Name:
    case Token::Kind::Number:
    case Token::Kind::True:
    case Token::Kind::False:
      push_atom(token);
      operand_expected_ = false;
      break;
    default:
      fail_operand(token);
  }
  return true;
}

bool Parser::read_operator() {
  const Token token = lexer_.next(false);
  switch (token.kind) {
    case Token::Kind::End:
      finish();
      return false;
    case Token::Kind::Prime:
      apply_prime(token);
      break;
    case Token::Kind::Close:
      close_parenthesis(token);
      break;
    case Token::Kind::Operator:
      if (is_prefix(token.op)) fail_operator(token);
      push_infix(token);
      operand_expected_ = true;
      break;
    default:
      fail_operator(token);
  }
  return true;
}

void Parser::push_atom(const Token& token) {
  const util::Location location = source_.at(token.offset);
  switch (token.kind) {
    case Token::Kind::Name:
      operands_.push_back({Formula::make_name(token.text, location), Sort::Either, 0, token.offset});
      break;
    case Token::Kind::Number:
      operands_.push_back({Formula::make_number(token.number, location), Sort::Term, 0, token.offset});
      break;
    default: {
      const Op op = token.kind == Token::Kind::True ? Op::True : Op::False;
      operands_.push_back({Formula::make(op, {}, location), Sort::Truth, 0, token.offset});
    }
  }
}

void Parser::push_prefix(const Token& token) {
  pending_.push_back({token.op, false, 1, token.offset, token.text});
  if (token.twice) pending_.push_back({Op::Eventually, false, 1, token.offset, token.text});
  if (pending_.size() - parentheses_ > limits_.nesting && limits_.nesting != 0) fail_nesting(token.offset);
}

void Parser::push_infix(const Token& token) {
  const Op op = token.op;
  reduce_while(binding(op), !is_right_associative(op) && op != Op::And && op != Op::Or && !is_comparison(op));
  if (!pending_.empty() && !pending_.back().open) {
    Pending& top = pending_.back();
    if (top.op == op && (op == Op::And || op == Op::Or)) {
      ++top.operands;
      return;
    }
    if (is_comparison(top.op) && is_comparison(op))
      throw util::InputError(source_, token.offset, "chained-comparison", "comparisons do not chain",
                             "write a < b & b < c");
  }
  pending_.push_back({op, false, 2, token.offset, token.text});
  if (pending_.size() - parentheses_ > limits_.nesting && limits_.nesting != 0) fail_nesting(token.offset);
}

void Parser::reduce_while(int level, bool equal_too) {
  while (!pending_.empty() && !pending_.back().open) {
    const int top = binding(pending_.back().op);
    if (top < level || (top == level && !equal_too)) return;
    reduce();
  }
}

void Parser::apply_prime(const Token& token) {
  Operand& operand = operands_.back();
  operand.formula = Formula::make(Op::Next, {operand.formula}, operand.formula.location());
  if (++operand.depth > limits_.nesting && limits_.nesting != 0) fail_nesting(token.offset);
}

void Parser::close_parenthesis(const Token& token) {
  reduce_while(BindNothing, true);
  if (pending_.empty())
    throw util::InputError(source_, token.offset, "syntax", "')' closes nothing",
                           "remove it, or add '(' before it");
  operands_.back().offset = pending_.back().offset;
  pending_.pop_back();
  --parentheses_;
}

void Parser::finish() {
  reduce_while(BindNothing, true);
  if (!pending_.empty())
    throw util::InputError(source_, pending_.back().offset, "syntax", "'(' is never closed", "add ')'");
  if (operands_.back().sort == Sort::Term)
    throw util::InputError(source_, operands_.back().offset, "formula-expected",
                           "expected a formula, found an integer term", "compare it: x = 1");
}

void Parser::require(const Operand& operand, Sort sort, const Pending& pending) const {
  if (operand.sort == sort || operand.sort == Sort::Either) return;
  if (sort == Sort::Truth)
    throw util::InputError(source_, operand.offset, "formula-expected",
                           fmt::format("'{}' needs a formula, found an integer term", pending.text),
                           "compare it: x = 1");
  throw util::InputError(source_, operand.offset, "term-expected",
                         fmt::format("'{}' needs integer terms or values, found a formula", pending.text),
                         is_comparison(pending.op) ? "compare truth values with <-> and !(a <-> b)"
                                                   : "use & and | between formulas");
}

Formula Parser::build(const Pending& pending, std::vector<Formula> parts) const {
  const bool prefix = is_prefix(pending.op);
  util::Location location = prefix ? source_.at(pending.offset) : parts.front().location();
  return Formula::make(pending.op, std::move(parts), std::move(location));
}

void Parser::reduce() {
  const Pending pending = std::move(pending_.back());
  pending_.pop_back();
  const bool of_terms = is_comparison(pending.op) || is_arithmetic(pending.op);
  Operand result;
  result.sort = is_arithmetic(pending.op) ? Sort::Term : Sort::Truth;
  const std::size_t first = operands_.size() - pending.operands;
  result.offset = pending.operands == 1 ? pending.offset : operands_[first].offset;
  std::vector<Formula> parts;
  for (std::size_t i = first; i < operands_.size(); ++i) {
    require(operands_[i], of_terms ? Sort::Term : Sort::Truth, pending);
    result.depth = std::max(result.depth, operands_[i].depth + 1);
    parts.push_back(std::move(operands_[i].formula));
  }
  if (result.depth > limits_.nesting && limits_.nesting != 0) fail_nesting(pending.offset);
  operands_.resize(first);
  result.formula = build(pending, std::move(parts));
  operands_.push_back(std::move(result));
}

/// What should have stood where an operand is missing.
std::string hint_for_operand(bool alone, bool parenthesis, bool prefix) {
  if (alone) return "what always holds is written true";
  if (parenthesis) return "parentheses hold one formula: (a | b)";
  return prefix ? "a prefix operator stands before a formula: G a"
                : "an operator between formulas has one on each side: a | b";
}

void Parser::fail_operand(const Token& token) const {
  const bool alone = pending_.empty();
  const std::string after = alone ? std::string() : fmt::format(" after '{}'", pending_.back().text);
  std::string hint =
      hint_for_operand(alone, !alone && pending_.back().text == "(", !alone && is_prefix(pending_.back().op));
  if (token.kind == Token::Kind::Operator && binding(token.op) == BindUntil)
    hint = fmt::format("a name that is spelled like an operator is quoted: \"{}\"", token.text);
  if (token.kind == Token::Kind::Operator && token.op == Op::Sub) hint = "write 0 - x for the negative of x";
  std::string found = fmt::format("found '{}'", token.text);
  if (token.kind == Token::Kind::End) found = alone ? "found nothing" : "but the text ends";
  throw util::InputError(source_, token.offset, "syntax",
                         fmt::format("expected a formula{}, {}", after, found), hint);
}

std::string hint_for_words(std::string_view left, const Token& found) {
  for (const std::string_view word : {left, std::string_view(found.text)}) {
    if (word == "and" || word == "AND") return "write & for and";
    if (word == "or" || word == "OR") return "write | for or";
    if (word == "implies") return "write ->";
    if (word == "not" || word == "NOT") return "write ! for not";
    if (word == "next") return "write X for next";
    if (word == "always") return "write G for always";
    if (word == "eventually") return "write F for eventually";
    if (word == "until") return "write U for until";
    if (word == "V") return "write R for release";
  }
  if (found.kind == Token::Kind::Open) return "heed's formulas have no functions; join formulas with & or |";
  if (found.kind == Token::Kind::Operator)
    return "a prefix operator needs & or | before it; a name like an operator is quoted";
  return "join formulas with &, |, -> or U; quote a name with other characters";
}

void Parser::fail_operator(const Token& token) const {
  const Formula& left = operands_.back().formula;
  const std::string_view word = left.op() == Op::Name ? std::string_view(left.name()) : std::string_view();
  throw util::InputError(source_, token.offset, "syntax",
                         fmt::format("expected an operator or the end, found '{}'", token.text),
                         hint_for_words(word, token));
}

void Parser::fail_nesting(std::size_t offset) const {
  throw util::InputError(source_, offset, "nesting",
                         fmt::format("the formula is nested deeper than {}", limits_.nesting),
                         "write it as several formulas: a conjunction is a list of them");
}

}  // namespace

Formula parse(const util::SourceText& source, const util::Limits& limits) {
  return Parser(source, limits).read();
}

Formula parse(std::string_view text) {
  return parse(util::SourceText("<formula>", std::string(text)));
}

}  // namespace heed::logic
