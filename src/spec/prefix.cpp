#include "prefix.h"

#include <heed/util/diagnostic.h>

#include "peer.h"

#include <fmt/format.h>

#include <charconv>

namespace heed::spec {

using logic::Formula;
using logic::Op;

Read PrefixReader::read(std::size_t begin, std::size_t end) {
  at_ = begin;
  end_ = end;
  frames_.clear();
  values_.clear();
  blocks_.clear();
  conjuncts_.clear();
  do {
    read_token();
  } while (!frames_.empty());
  skip_blanks();
  if (at_ < end_)
    fail(at_, "syntax", "the constraint is complete before this",
         "every line is one formula in prefix notation; a comment has a line of its own");
  values_[0].begin = begin;
  return values_[0];
}

std::string_view PrefixReader::token() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < end_ && !is_blank(source_.text()[at_])) ++at_;
  return std::string_view(source_.text()).substr(begin, at_ - begin);
}

void PrefixReader::skip_blanks() {
  while (at_ < end_ && is_blank(source_.text()[at_])) ++at_;
}

void PrefixReader::read_token() {
  const std::string_view word = token();
  const std::size_t begin = at_ - word.size();
  if (word.empty())
    fail(end_, "syntax", "the line ends where an operand is expected",
         frames_.empty()
             ? ""
             : fmt::format("of the operator at column {}", source_.at(frames_.back().begin).column));
  if (word.size() > 1) return operand(resolve_(word, begin));
  switch (word[0]) {
    case '&':
      return open(Op::And, 2, begin);
    case '|':
      return open(Op::Or, 2, begin);
    case '^':
      return open(Op::Iff, 2, begin);
    case '!':
      return open(Op::Not, 1, begin);
    case '$':
      return open_block(begin);
    case '?':
      return operand(recall(begin));
    case '0':
    case '1':
      return operand({logic::truth(word[0] == '1'), begin, false});
    default:
      return operand(resolve_(word, begin));
  }
}

void PrefixReader::open(Op op, std::size_t operands, std::size_t begin) {
  const bool chain = !frames_.empty() && frames_.back().op == op && (op == Op::And || op == Op::Or);
  if (chain) {
    ++frames_.back().waiting;
    return;
  }
  if (limits_.nesting != 0 && frames_.size() >= limits_.nesting)
    fail(begin, "too-deep", fmt::format("operators are nested deeper than {}", limits_.nesting),
         "share inner parts by a buffer: $ 2 PART ? 0");
  frames_.push_back({op, operands, begin, values_.size()});
}

std::size_t PrefixReader::number(const char* what) {
  const std::string_view word = token();
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc() || end != word.data() + word.size())
    fail(at_ - word.size(), "number", fmt::format("expected {}", what));
  return value;
}

void PrefixReader::open_block(std::size_t begin) {
  const std::size_t parts = number("the number of formulas in the block, as in '$ 3'");
  if (parts == 0) fail(begin, "empty-block", "a block of no formulas has no value");
  open(Op::Name, parts, begin);
  blocks_.push_back(frames_.size() - 1);
}

Read PrefixReader::recall(std::size_t begin) {
  const std::size_t index = number("the index of a formula of the block, as in '? 0'");
  if (blocks_.empty()) fail(begin, "no-block", "'?' outside any block", "blocks begin with '$ n'");
  const std::size_t block = blocks_.back();
  const bool direct = block + 1 == frames_.size();
  const std::size_t ready = (direct ? values_.size() : frames_[block + 1].base) - frames_[block].base;
  if (index >= ready)
    fail(begin, "not-yet-known", fmt::format("formula {} of the block is not known yet", index),
         fmt::format("here the block has {} before it", ready));
  const Read& known = values_[frames_[block].base + index];
  return {known.formula, begin, known.primed};
}

/// Hands a finished operand to the operator that waits for it, and on as long as that finishes others.
void PrefixReader::operand(Read value) {
  for (;;) {
    values_.push_back(std::move(value));
    if (frames_.empty()) return;
    if (frames_.size() == 1 && frames_[0].op == Op::And) conjuncts_.emplace_back(values_.back(), at_);
    if (--frames_.back().waiting > 0) return;
    value = close();
  }
}

Read PrefixReader::close() {
  const Frame frame = frames_.back();
  frames_.pop_back();
  Read result{Formula(), frame.begin, false};
  if (frame.op == Op::Name) {
    blocks_.pop_back();
    result.formula = values_.back().formula;
    result.primed = values_.back().primed;
  } else {
    std::vector<Formula> parts;
    parts.reserve(values_.size() - frame.base);
    for (std::size_t i = frame.base; i < values_.size(); ++i) {
      result.primed = result.primed || values_[i].primed;
      parts.push_back(std::move(values_[i].formula));
    }
    if (frame.op == Op::Not)
      result.formula = !parts[0];
    else if (frame.op == Op::Iff)
      result.formula = !logic::iff(parts[0], parts[1]);
    else
      result.formula = joined_flat(frame.op, std::move(parts));
  }
  values_.resize(frame.base);
  return result;
}

void PrefixReader::fail(std::size_t offset, std::string code, std::string message, std::string hint) const {
  throw util::InputError(source_, offset, std::move(code), std::move(message), std::move(hint));
}

}  // namespace heed::spec
