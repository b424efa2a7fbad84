// Onset expressions: reading into postfix form with an explicit stack (so that nesting costs no call depth),
// and evaluation over ranges, since while a trace unfolds an onset may only be known to lie ahead.
#include "onset.h"

#include <heed/util/diagnostic.h>

#include <algorithm>
#include <charconv>

namespace heed::sim {
namespace {

using Operation = OnsetExpression::Operation;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) > 127;
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

class OnsetReader {
 public:
  OnsetReader(const util::SourceText& source, const util::Limits& limits)
      : source_(source), text_(source.text()), limits_(limits) {}

  OnsetExpression read() {
    spaces();
    const std::size_t begin = position_;
    for (bool operand = true; operand || !at_end();) operand = operand ? read_operand() : read_operator();
    if (!open_.empty()) fail("expected ')' before the end");
    OnsetExpression result(std::move(items_), source_.text());
    result.set_location(source_.at(begin));
    return result;
  }

 private:
  /// An open parenthesis; `operation` Number where it only groups.
  struct Open {
    Operation operation;
    std::int64_t operands;
    util::Location location;
  };

  [[noreturn]] void fail(const std::string& message) const {
    throw util::InputError(source_, position_, "bad-onset", message,
                           "a cell is a number, a feature, 'never', min(...), max(...), with '+ n' or '- n'");
  }
  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }
  void spaces() {
    while (!at_end() && (text_[position_] == ' ' || text_[position_] == '\t')) ++position_;
  }
  bool take(char wanted) {
    if (at_end() || text_[position_] != wanted) return false;
    ++position_;
    spaces();
    return true;
  }
  void emit(Operation operation, std::int64_t number, std::size_t at, std::string name = {}) {
    items_.push_back({operation, number, std::move(name), source_.at(at)});
  }
  std::int64_t read_number() {
    std::int64_t value = 0;
    const char* begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc() || value > 1'000'000) fail("a cell number is at most 1,000,000");
    position_ += static_cast<std::size_t>(end - begin);
    spaces();
    return value;
  }
  void open(Operation operation) {
    if (open_.size() >= limits_.nesting) fail("nested too deeply");
    open_.push_back({operation, 1, source_.at(position_)});
  }
  std::string read_quoted() {
    const std::size_t end = text_.find('"', position_ + 1);
    if (end == std::string_view::npos) fail("a quoted name has no end");
    std::string name(text_.substr(position_ + 1, end - position_ - 1));
    position_ = end + 1;
    return name;
  }
  std::string read_word() {
    const std::size_t begin = position_;
    while (!at_end() &&
           (is_letter(text_[position_]) || is_digit(text_[position_]) || text_[position_] == '.'))
      ++position_;
    return std::string(text_.substr(begin, position_ - begin));
  }

  /// Reads up to an operand's end or one opening parenthesis. \returns whether an operand is still expected
  bool read_operand() {
    if (at_end()) fail("expected a cell");
    const std::size_t begin = position_;
    const char c = text_[position_];
    if (is_digit(c)) {
      emit(Operation::Number, read_number(), begin);
      return false;
    }
    if (take('(')) {
      open(Operation::Number);
      return true;
    }
    if (c != '"' && !is_letter(c)) fail("expected a cell");
    const std::string word = c == '"' ? read_quoted() : read_word();
    spaces();
    if (c != '"' && (word == "min" || word == "max")) {
      if (!take('(')) fail("expected '(' after " + word);
      open(word == "min" ? Operation::Min : Operation::Max);
      return true;
    }
    if (c != '"' && word == "never")
      emit(Operation::Never, 0, begin);
    else
      emit(Operation::Feature, 0, begin, word);
    return false;
  }

  /// After an operand. \returns whether an operand is expected next
  bool read_operator() {
    const std::size_t begin = position_;
    const bool minus = text_[position_] == '-';
    if (take('+') || take('-')) {
      if (at_end() || !is_digit(text_[position_])) fail("expected a number: only numbers are added");
      const std::int64_t number = read_number();
      emit(Operation::Add, minus ? -number : number, begin);
      return false;
    }
    if (open_.empty()) fail("unexpected text after the cell");
    if (take(')')) {
      const Open& closed = open_.back();
      if (closed.operation != Operation::Number) emit(closed.operation, closed.operands, begin);
      open_.pop_back();
      return false;
    }
    if (open_.back().operation == Operation::Number || !take(',')) fail("expected ')', '+' or '-'");
    ++open_.back().operands;
    return true;
  }

  const util::SourceText& source_;
  std::string_view text_;
  const util::Limits& limits_;
  std::size_t position_ = 0;
  std::vector<Open> open_;
  std::vector<OnsetExpression::Item> items_;
};

std::int64_t add(std::int64_t onset, std::int64_t number) {
  return onset == infinite ? infinite : onset + number;
}

/// Folds the topmost \p operands ranges into one.
void fold(std::vector<OnsetRange>& stack, std::int64_t operands, Operation operation) {
  for (std::int64_t i = 1; i < operands; ++i) {
    const OnsetRange top = stack.back();
    stack.pop_back();
    OnsetRange& below = stack.back();
    if (operation == Operation::Min)
      below = {std::min(below.low, top.low), std::min(below.high, top.high)};
    else
      below = {std::max(below.low, top.low), std::max(below.high, top.high)};
  }
}

}  // namespace

OnsetExpression parse_onset(const util::SourceText& source, const util::Limits& limits) {
  return OnsetReader(source, limits).read();
}

OnsetRange ResolvedExpression::evaluate(const std::vector<OnsetRange>& onsets) const {
  std::vector<OnsetRange> stack;
  for (const Item& item : items) {
    switch (item.operation) {
      case Operation::Number:
        stack.push_back({item.number, item.number});
        break;
      case Operation::Feature:
        stack.push_back(onsets[static_cast<std::size_t>(item.number)]);
        break;
      case Operation::Never:
        stack.push_back({infinite, infinite});
        break;
      case Operation::Add:
        stack.back() = {add(stack.back().low, item.number), add(stack.back().high, item.number)};
        break;
      case Operation::Min:
      case Operation::Max:
        fold(stack, item.number, item.operation);
        break;
    }
  }
  return stack.back();
}

ResolvedExpression resolve(const OnsetExpression& expression, const std::vector<std::string>& features) {
  ResolvedExpression result;
  for (const OnsetExpression::Item& item : expression.items()) {
    std::int64_t number = item.number;
    if (item.operation == Operation::Feature) {
      const auto found = std::find(features.begin(), features.end(), item.name);
      if (found == features.end())
        throw util::InputError(item.location, "unknown-feature",
                               "the profile has no feature '" + item.name + "'",
                               util::suggestion(item.name, features));
      number = found - features.begin();
      result.features.push_back(static_cast<std::uint32_t>(number));
    }
    result.items.push_back({item.operation, number});
  }
  std::sort(result.features.begin(), result.features.end());
  result.features.erase(std::unique(result.features.begin(), result.features.end()), result.features.end());
  return result;
}

}  // namespace heed::sim
