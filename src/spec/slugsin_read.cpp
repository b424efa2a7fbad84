#include <heed/spec/slugsin.h>
#include <heed/util/diagnostic.h>

#include "peer.h"

#include <fmt/format.h>

#include <charconv>
#include <unordered_map>

// A line is read from left to right with a stack of the operators that still wait for operands. Chains of one
// associative operator, `& & & a b c d`, are one frame, so depth counts alternations and not length.

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

/// A subformula with where its text begins, and whether it speaks of the next step.
struct Value {
  Formula formula;
  std::size_t begin = 0;
  bool primed = false;
};

/// An operator that waits for operands; Op::Name stands for a block, Op::Iff for exclusive or.
struct Frame {
  Op op;
  std::size_t waiting;
  std::size_t begin;  ///< Offset of its text.
  std::size_t base;   ///< Its operands are the values from here on.
};

struct Known {
  Formula now, next;
  bool input = false;
};

class Reader {
 public:
  Reader(const util::SourceText& source, const util::Limits& limits) : source_(source), limits_(limits) {}

  Gr1 read() {
    check_size(source_, limits_);
    spec_.name = stem_of(source_.name());
    const std::string& text = source_.text();
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      read_line(begin, end);
      begin = end + 1;
    }
    return std::move(spec_);
  }

 private:
  void read_line(std::size_t begin, std::size_t end) {
    const std::string& text = source_.text();
    while (begin < end && is_blank(text[begin])) ++begin;
    while (end > begin && is_blank(text[end - 1])) --end;
    if (begin == end || text[begin] == '#') return;
    at_ = begin;
    end_ = end;
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    if (line[0] == '[') {
      section_ = find_section(source_, begin, line);
    } else if (section_ == nullptr) {
      fail(begin, "no-section", "a line outside any section", "begin with a section such as [INPUT]");
    } else if (section_->clauses == nullptr) {
      declare(begin, std::string(line));
    } else {
      read_clause();
    }
  }

  void declare(std::size_t begin, std::string name) {
    if (name.find_first_of(" \t\v\f\r") != std::string::npos)
      fail(begin, "name", fmt::format("'{}' is no name: it has blanks in it", name), "one variable a line");
    const bool reserved = name.size() == 1 && std::string_view("&|^!$?01").find(name[0]) != std::string::npos;
    if (reserved || name.ends_with('\''))
      fail(begin, "name", fmt::format("'{}' cannot stand as a name", name),
           "operators, 0 and 1 are reserved, and a prime means the next value");
    const bool input = section_->input;
    const auto [place, fresh] = known_.try_emplace(name);
    if (!fresh) fail(begin, "duplicate-name", fmt::format("the name '{}' is declared twice", name));
    place->second = {logic::name(name), logic::next(logic::name(name)), input};
    names_.push_back(name);
    model::Variable variable{std::move(name), model::Domain::boolean(), {}, source_.at(begin)};
    if (input)
      spec_.inputs.push_back(std::move(variable));
    else
      spec_.outputs.push_back({std::move(variable), model::OutputRole::Output});
  }

  void read_clause() {
    const std::size_t begin = at_;
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
    if (section_->justice || conjuncts_.empty())
      return add({values_[0].formula, begin, values_[0].primed}, end_);
    for (std::size_t i = 0; i < conjuncts_.size(); ++i) add(conjuncts_[i].first, conjuncts_[i].second);
  }

  void add(const Value& value, std::size_t end) {
    if (value.formula.is_true() && !section_->justice) return;
    Clause clause;
    clause.formula =
        section_->step && !value.primed ? on_steps(value.formula, source_.at(value.begin)) : value.formula;
    clause.text = source_.text().substr(value.begin, end - value.begin);
    (spec_.*section_->clauses).push_back(std::move(clause));
  }

  [[nodiscard]] std::string_view token() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < end_ && !is_blank(source_.text()[at_])) ++at_;
    return std::string_view(source_.text()).substr(begin, at_ - begin);
  }

  void skip_blanks() {
    while (at_ < end_ && is_blank(source_.text()[at_])) ++at_;
  }

  void read_token() {
    const std::string_view word = token();
    const std::size_t begin = at_ - word.size();
    if (word.empty())
      fail(end_, "syntax", "the line ends where an operand is expected",
           frames_.empty()
               ? ""
               : fmt::format("of the operator at column {}", source_.at(frames_.back().begin).column));
    if (word.size() > 1) return leaf(name(word, begin));
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
        return leaf(recall(begin));
      case '0':
      case '1':
        return leaf({logic::truth(word[0] == '1'), begin, false});
      default:
        return leaf(name(word, begin));
    }
  }

  void open(Op op, std::size_t operands, std::size_t begin) {
    const bool chain = !frames_.empty() && frames_.back().op == op && (op == Op::And || op == Op::Or);
    if (chain) {
      ++frames_.back().waiting;
      return;
    }
    if (limits_.nesting != 0 && frames_.size() >= limits_.nesting)
      fail(begin, "too-deep", fmt::format("operators are nested deeper than {}", limits_.nesting));
    frames_.push_back({op, operands, begin, values_.size()});
  }

  [[nodiscard]] std::size_t number(const char* what) {
    const std::string_view word = token();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size())
      fail(at_ - word.size(), "number", fmt::format("expected {}", what));
    return value;
  }

  void open_block(std::size_t begin) {
    const std::size_t parts = number("the number of formulas in the block, as in '$ 3'");
    if (parts == 0) fail(begin, "empty-block", "a block of no formulas has no value");
    open(Op::Name, parts, begin);
    blocks_.push_back(frames_.size() - 1);
  }

  [[nodiscard]] Value recall(std::size_t begin) {
    const std::size_t index = number("the index of a formula of the block, as in '? 0'");
    if (blocks_.empty()) fail(begin, "no-block", "'?' outside any block", "blocks begin with '$ n'");
    const Frame& block = frames_[blocks_.back()];
    const bool direct = blocks_.back() + 1 == frames_.size();
    const std::size_t ready = (direct ? values_.size() : frames_[blocks_.back() + 1].base) - block.base;
    if (index >= ready)
      fail(begin, "not-yet-known", fmt::format("formula {} of the block is not known yet", index),
           fmt::format("{} before it {} known here", ready, ready == 1 ? "is" : "are"));
    const Value& known = values_[block.base + index];
    return {known.formula, begin, known.primed};
  }

  [[nodiscard]] Value name(std::string_view word, std::size_t begin) {
    const bool primed = word.ends_with('\'');
    const auto found = known_.find(std::string(word.substr(0, word.size() - (primed ? 1 : 0))));
    if (found == known_.end())
      fail(begin, "unknown-name",
           fmt::format("'{}' is neither an operator nor a variable declared before", word),
           util::suggestion(word, names_));
    const Known& known = found->second;
    check_place(source_, begin, *section_, word, known.input, primed);
    return {primed ? known.next : known.now, begin, primed};
  }

  /// Hands a finished operand to the operator that waits for it, and on as long as that finishes others.
  void leaf(Value value) {
    for (;;) {
      values_.push_back(std::move(value));
      if (frames_.empty()) return;
      if (frames_.size() == 1 && frames_[0].op == Op::And) conjuncts_.emplace_back(values_.back(), at_);
      if (--frames_.back().waiting > 0) return;
      value = close();
    }
  }

  [[nodiscard]] Value close() {
    const Frame frame = frames_.back();
    frames_.pop_back();
    Value result{Formula(), frame.begin, false};
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
      result.formula = joined(frame.op, std::move(parts));
    }
    values_.resize(frame.base);
    return result;
  }

  static Formula joined(Op op, std::vector<Formula> parts) {
    if (op == Op::Not) return !parts[0];
    if (op == Op::Iff) return !logic::iff(parts[0], parts[1]);
    return joined_flat(op, std::move(parts));
  }

  [[noreturn]] void fail(std::size_t offset, std::string code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(source_, offset, std::move(code), std::move(message), std::move(hint));
  }

  const util::SourceText& source_;
  const util::Limits& limits_;
  Gr1 spec_;
  const SlugsSection* section_ = nullptr;
  std::unordered_map<std::string, Known> known_;
  std::vector<std::string> names_;
  std::size_t at_ = 0, end_ = 0;
  std::vector<Frame> frames_;
  std::vector<Value> values_;
  std::vector<std::size_t> blocks_;                       ///< Indices of frames.
  std::vector<std::pair<Value, std::size_t>> conjuncts_;  ///< Of a top-level `&`, each with its end.
};

}  // namespace

Gr1 read_slugsin(const util::SourceText& source, const util::Limits& limits) {
  return Reader(source, limits).read();
}

}  // namespace heed::spec
