#include "infix.h"

#include <heed/util/diagnostic.h>

#include "peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace heed::spec {

using logic::Formula;
using logic::Op;

namespace {

constexpr std::size_t most_cases = 4096;
constexpr int prefix_power = 50, comparison_power = 60, sum_power = 70, overwrite_power = 80;

bool is_comparison(Sign sign) {
  return sign >= Sign::Eq && sign <= Sign::Ge;
}

Op comparison_op(Sign sign) {
  constexpr Op ops[] = {Op::Eq, Op::Ne, Op::Lt, Op::Le, Op::Gt, Op::Ge};
  return ops[static_cast<int>(sign) - static_cast<int>(Sign::Eq)];
}

std::size_t bit_length(std::int64_t value) {
  std::size_t bits = 0;
  for (; value > 0; value >>= 1) ++bits;
  return bits;
}

std::vector<TermCase> cases_of(const Operand& value) {
  if (!value.cases.empty()) return value.cases;
  return {{Formula(), value.formula}};
}

Formula conjunction(const Formula& a, const Formula& b) {
  return joined_flat(Op::And, {a, b});
}

}  // namespace

int InfixReader::power(Sign sign) const {
  if (sign == Sign::Not || sign == Sign::Next) return prefix_power;
  if (is_comparison(sign)) return comparison_power;
  if (sign == Sign::Plus) return sum_power;
  if (sign == Sign::Overwrite) return overwrite_power;
  return sign == Sign::Open ? 0 : grammar_.power(sign);
}

Formula InfixReader::read(std::size_t begin, std::size_t& end) {
  operators_.clear();
  values_.clear();
  depth_ = nexts_ = 0;
  bool wanted = true;  // an operand
  for (std::size_t at = begin;;) {
    const Token token = grammar_.lex(at);
    at = token.end;
    if (token.sign == Sign::End && !wanted) {
      while (!operators_.empty()) {
        if (operators_.back().sign == Sign::Open)
          fail(operators_.back().begin, "syntax", "this parenthesis is never closed");
        reduce();
      }
      end = token.begin;
      break;
    }
    if (wanted) {
      operand(token);
      wanted = token.sign != Sign::Name && token.sign != Sign::Number;
    } else if (token.sign == Sign::Close) {
      close(token);
    } else {
      binary(token);
      wanted = true;
    }
  }
  require_formula(values_[0]);
  return values_[0].formula;
}

/// Where an operand may begin: names, numbers, prefix operators, parentheses.
void InfixReader::operand(const Token& token) {
  const std::string_view word = std::string_view(source_.text()).substr(token.begin, token.end - token.begin);
  switch (token.sign) {
    case Sign::Name:
      values_.push_back(grammar_.resolve(word, token.begin, nexts_ > 0));
      return;
    case Sign::Number: {
      Operand value{Formula(), token.begin, true, true};
      const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value.low);
      if (parsed.ec != std::errc() || value.low > INT32_MAX)
        fail(token.begin, "number", "the number does not fit 32 bits");
      value.high = value.low;
      value.bits = bit_length(value.low);
      value.formula = Formula::make_number(value.low, source_.at(token.begin));
      values_.push_back(std::move(value));
      return;
    }
    case Sign::Next:
      if (nexts_ > 0)
        fail(token.begin, "next-twice", "next inside next", "one step ahead is all that is seen");
      ++nexts_;
      [[fallthrough]];
    case Sign::Not:
    case Sign::Open:
      if (limits_.nesting != 0 && ++depth_ > limits_.nesting)
        fail(token.begin, "too-deep", fmt::format("the formula is nested deeper than {}", limits_.nesting),
             "write a conjunction as a line for each part, or define an inner part by a variable");
      operators_.push_back(token);
      return;
    default:
      fail(token.begin, "syntax",
           token.sign == Sign::End ? "the formula ends where an operand is expected"
                                   : fmt::format("expected an operand and found '{}'", word));
  }
}

void InfixReader::binary(const Token& token) {
  if (token.sign < Sign::Iff) fail(token.begin, "syntax", "expected an operator or the end of the formula");
  const int mine = power(token.sign);
  while (!operators_.empty()) {
    const Sign top = operators_.back().sign;
    const bool chain = top == token.sign && (top == Sign::And || top == Sign::Or);
    if (top == Sign::Open || chain || power(top) < mine) break;
    reduce();
  }
  operators_.push_back(token);
}

void InfixReader::close(const Token& token) {
  while (!operators_.empty() && operators_.back().sign != Sign::Open) reduce();
  if (operators_.empty()) fail(token.begin, "syntax", "this closes a parenthesis that was never opened");
  if (operators_.back().square != token.square)
    fail(token.begin, "syntax", "this parenthesis does not fit the one that it closes");
  operators_.pop_back();
  --depth_;
  values_.back().bare = false;
}

/// Applies the operator on top to the values on top.
void InfixReader::reduce() {
  const Token top = operators_.back();
  operators_.pop_back();
  if (top.sign == Sign::Not || top.sign == Sign::Next) {
    --depth_;
    require_formula(values_.back());
    if (top.sign == Sign::Next)
      --nexts_;  // names below it were read as primed
    else
      values_.back().formula = !values_.back().formula;
    values_.back().begin = top.begin;
    return;
  }
  std::size_t count = 2;
  while ((top.sign == Sign::And || top.sign == Sign::Or) && !operators_.empty() &&
         operators_.back().sign == top.sign) {
    operators_.pop_back();
    ++count;
  }
  reduce_binary(top.sign, top.begin, count);
}

void InfixReader::reduce_binary(Sign sign, std::size_t begin, std::size_t count) {
  if (is_comparison(sign)) return compare(sign, begin);
  if (sign == Sign::Plus) return add(begin);
  if (sign == Sign::Overwrite) return overwrite(begin);
  std::vector<Formula> parts;
  for (std::size_t i = values_.size() - count; i < values_.size(); ++i) {
    require_formula(values_[i]);
    parts.push_back(values_[i].formula);
  }
  const std::size_t start = values_[values_.size() - count].begin;
  values_.resize(values_.size() - count);
  Operand result{Formula(), start};
  switch (sign) {
    case Sign::Iff:
      result.formula = logic::iff(parts[0], parts[1]);
      break;
    case Sign::Implies:
      result.formula = logic::implies(parts[0], parts[1]);
      break;
    case Sign::Xor:
      result.formula = !logic::iff(parts[0], parts[1]);
      break;
    default:
      result.formula = joined_flat(sign == Sign::And ? Op::And : Op::Or, std::move(parts));
  }
  values_.push_back(std::move(result));
}

void InfixReader::compare(Sign sign, std::size_t begin) {
  const Operand right = std::move(values_.back());
  values_.pop_back();
  const Operand left = std::move(values_.back());
  values_.pop_back();
  require_integer(left);
  require_integer(right);
  const bool plain =
      left.bare && right.bare && left.formula.op() != Op::Number && right.formula.op() == Op::Number;
  if (grammar_.plain_comparisons && !plain)
    fail(begin, "syntax", "a comparison has a variable on its left and a number on its right");
  std::vector<Formula> alternatives;
  for (const TermCase& a : cases_of(left))
    for (const TermCase& b : cases_of(right)) {
      const Formula holds = Formula::make(comparison_op(sign), {a.term, b.term}, source_.at(begin));
      alternatives.push_back(conjunction(conjunction(a.guard, b.guard), holds));
      if (alternatives.size() > most_cases)
        fail(begin, "too-large", fmt::format("the comparison falls into more than {} cases", most_cases));
    }
  values_.push_back({joined_flat(Op::Or, std::move(alternatives)), left.begin});
}

void InfixReader::add(std::size_t begin) {
  const Operand right = std::move(values_.back());
  values_.pop_back();
  const Operand left = std::move(values_.back());
  values_.pop_back();
  require_integer(left);
  require_integer(right);
  Operand sum{Formula(), left.begin, true};
  sum.low = left.low + right.low;
  sum.high = left.high + right.high;
  const bool carry = left.bits != 0 && right.bits != 0;
  sum.bits = std::max(left.bits, right.bits) + (carry ? 1 : 0);
  if (left.cases.empty() && right.cases.empty()) {
    sum.formula = Formula::make(Op::Add, {left.formula, right.formula}, source_.at(begin));
  } else {
    for (const TermCase& a : cases_of(left))
      for (const TermCase& b : cases_of(right))
        sum.cases.push_back({conjunction(a.guard, b.guard), Formula::make(Op::Add, {a.term, b.term})});
    if (sum.cases.size() > most_cases)
      fail(begin, "too-large", fmt::format("the sum falls into more than {} cases", most_cases));
  }
  values_.push_back(std::move(sum));
}

/// `a LEASTSIGNIFICANTBITOVERWRITES b` is a + 2^k * floor(b / 2^k), where k is the number of bits of a: one
/// case for each value of the floor.
void InfixReader::overwrite(std::size_t begin) {
  const Operand right = std::move(values_.back());
  values_.pop_back();
  const Operand left = std::move(values_.back());
  values_.pop_back();
  require_integer(left);
  require_integer(right);
  if (left.bits >= right.bits || left.low < 0 || right.low < 0 || !left.cases.empty() || !right.cases.empty())
    fail(begin, "overwrite",
         "bits can be overwritten only in a longer number, and only once, of plain terms");
  const std::int64_t block = std::int64_t{1} << left.bits;
  if ((right.high - right.low) / block > static_cast<std::int64_t>(most_cases))
    fail(begin, "too-large", fmt::format("overwriting falls into more than {} cases", most_cases));
  Operand result{Formula(), left.begin, true};
  for (std::int64_t high = right.low / block; high <= right.high / block; ++high) {
    const Formula from = logic::compare(Op::Ge, right.formula, logic::number(high * block));
    const Formula to = logic::compare(Op::Lt, right.formula, logic::number((high + 1) * block));
    result.cases.push_back(
        {conjunction(from, to), Formula::make(Op::Add, {left.formula, logic::number(high * block)})});
  }
  result.low = 0;
  result.high = (right.high / block + 1) * block - 1;
  result.bits = right.bits;
  values_.push_back(std::move(result));
}

void InfixReader::require_formula(const Operand& value) const {
  if (value.integer)
    fail(value.begin, "type", "a truth value is expected and this is an integer",
         "compare it, as in 'x = 3'");
}

void InfixReader::require_integer(const Operand& value) const {
  if (!value.integer) fail(value.begin, "type", "an integer is expected and this is a truth value");
}

void InfixReader::fail(std::size_t offset, std::string code, std::string message, std::string hint) const {
  throw util::InputError(source_, offset, std::move(code), std::move(message), std::move(hint));
}

}  // namespace heed::spec
